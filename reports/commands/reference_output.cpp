#include "reports/commands/reference_output.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "reports/output_file.hpp"

namespace porowave::reports {

const char* const derived_header =
    ",total_stress,seepage_velocity,solid_displacement,fluid_displacement,total_stress_error,"
    "seepage_velocity_error,solid_displacement_error,fluid_displacement_error";

std::string derived_cells(const reference::DerivedFields& derived) {
  const auto& [stress, seepage, solid, fluid] = derived;
  return fmt::format(",{:.17g},{:.17g},{:.17g},{:.17g},{:.3g},{:.3g},{:.3g},{:.3g}", stress.value,
                     seepage.value, solid.value, fluid.value, stress.error, seepage.error,
                     solid.error, fluid.error);
}

void write_energy_csv(std::span<const reference::EnergyBalance> balances, std::ostream& out) {
  out << "t,settlement,work,kinetic_energy,elastic_energy,dissipated_energy\n";
  for (const reference::EnergyBalance& row : balances) {
    fmt::print(out, "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", row.t,
               row.settlement.value, row.work.value, row.kinetic.value, row.elastic.value,
               row.dissipated.value);
  }
}

int run_energy(const Problem& problem, const std::vector<double>& times,
               const std::string& output) {
  if (!output.empty()) require_writable(output);
  const auto balances = reference::energy_balances(reference::ColumnSolution(problem), times);
  if (output.empty()) {
    write_energy_csv(balances, std::cout);
  } else {
    write_file(output, [&](std::ostream& out) { write_energy_csv(balances, out); });
    fmt::print("wrote {}\n", output);
  }
  const auto unresolved = std::count_if(balances.begin(), balances.end(), [](const auto& row) {
    return !std::isfinite(row.dissipated.error);
  });
  if (unresolved > 0) {
    fmt::print(
        stderr,
        "porowave: {} of {} balances could not be resolved (nan): too many waves have passed, "
        "or the drag is too stiff for this version\n",
        unresolved, balances.size());
  }
  return 0;
}

}  // namespace porowave::reports
