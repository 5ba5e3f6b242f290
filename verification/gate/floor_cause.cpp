#include "verification/gate/floor_cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/problem/errors.hpp"
#include "verification/study/case_identity.hpp"

namespace porowave::verification {

namespace {

constexpr std::size_t most_seeds = 4;
/// An error that falls by less than this share when one choice is refined is not made by it.
constexpr double noticeable = 0.2;

struct Refinement {
  std::string cause;
  std::string done;
  std::string section;
  std::string key;
  std::function<TomlValue(const solver::Case&)> value;
};

const std::vector<Refinement>& refinements() {
  static const std::vector<Refinement> all = {
      {"the time step", "half the time step", "time", "courant",
       [](const solver::Case& scene) { return TomlValue{0.5 * scene.time.courant}; }},
      {"the points in a cell", "twice the points in a cell", "discretization", "points_per_element",
       [](const solver::Case& scene) {
         return TomlValue{std::int64_t{2} * scene.discretization.points_per_element};
       }},
      {"the elements", "twice the elements", "discretization", "elements",
       [](const solver::Case& scene) {
         return TomlValue{std::int64_t{2} * scene.discretization.elements};
       }},
  };
  return all;
}

/// The error of a row's case after the refinement; none if it cannot be run.
std::optional<double> refined_error(const Record& row, const Refinement& refinement,
                                    std::size_t measure, CaseRunner& runner) {
  const TomlDocument before = TomlDocument::parse(row.specification, row.id);
  const TomlDocument alone = before.without({"adapter"});
  try {
    StudyCase one;
    const TomlDocument after =
        alone.with(refinement.section, refinement.key, refinement.value(solver::read_case(alone)));
    one.specification = after.canonical({"material", "column", "load", "discretization", "time"});
    one.scene = solver::read_case(after);
    one.id = row.id;
    const Record now = runner.run(one);
    if (now.status != CaseStatus::done || !(now.measures[measure] > 0.0)) return std::nullopt;
    return now.measures[measure];
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// By which share the errors of the finest level fall, in the mean of their logarithms.
std::optional<double> reduction(const std::vector<Record>& rows, const Refinement& refinement,
                                std::size_t measure, CaseRunner& runner) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < std::min(rows.size(), most_seeds); ++k) {
    const auto now = refined_error(rows[k], refinement, measure, runner);
    if (!now) return std::nullopt;
    sum += std::log(*now / rows[k].measures[measure]);
    ++count;
  }
  return -std::expm1(sum / static_cast<double>(count));
}

std::string what_is_left(const Record& row, std::size_t measure) {
  const double strain = row.measures[*measure_index("largest_strain")];
  if (strain >= 0.1 * row.measures[measure]) {
    return fmt::format("strains reach {:.1g}, and the reference is that of small strains", strain);
  }
  return "something that none of these changes";
}

}  // namespace

std::string cause_of_floor(const Study& study, const Group& group, std::size_t measure,
                           CaseRunner& runner) {
  const std::vector<Record>& finest = group.records.back();
  std::string tried;
  std::string cause;
  double largest = noticeable;
  for (const Refinement& refinement : refinements()) {
    const std::string name = refinement.section + "." + refinement.key;
    if (study.refine && study.axes[*study.refine].name() == name) continue;
    const auto share = reduction(finest, refinement, measure, runner);
    if (!share) continue;
    tried += fmt::format("{}{} changes it by {:+.0f} %", tried.empty() ? "" : ", ", refinement.done,
                         -100.0 * *share);
    if (*share < largest) continue;
    largest = *share;
    cause = refinement.cause;
  }
  if (cause.empty()) cause = what_is_left(finest.front(), measure);
  return fmt::format("made by {}{}{}", cause, tried.empty() ? "" : ": ", tried);
}

}  // namespace porowave::verification
