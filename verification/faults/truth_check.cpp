#include "verification/faults/truth_check.hpp"

#include <fmt/format.h>

#include "reference/field_fixtures.hpp"
#include "reference/tables/truth.hpp"

namespace porowave::verification::faults {

namespace {

std::vector<fixtures::TruthRow> moderate_rows() {
  auto rows =
      fixtures::read_truth(std::string(POROWAVE_SOURCE_DIR) + "/reference/tables/truth_step.csv");
  std::erase_if(rows, [](const fixtures::TruthRow& row) {
    return row.problem.material.relaxation_rate() * row.t > 30.0;
  });
  return rows;
}

}  // namespace

int truth_rows_compared() {
  return static_cast<int>(moderate_rows().size());
}

Catch caught_by_truth(const ReferenceFunction& values) {
  fixtures::Worst worst;
  for (const fixtures::TruthRow& row : moderate_rows()) {
    worst.see(fixtures::distance(row.problem, values(row.problem, row.x, row.t), row.value),
              row.id);
  }
  const std::string by = "truth table";
  if (worst.size <= 1e-6) return {by, ""};
  return {by, fmt::format("row {} is off by {:.2g} of the load", worst.where, worst.size)};
}

}  // namespace porowave::verification::faults
