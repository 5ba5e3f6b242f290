#include "verification/sweep/repeat.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reference/problem/errors.hpp"
#include "reference/problem/toml_document.hpp"
#include "verification/study/case_identity.hpp"
#include "verification/sweep/case_runner.hpp"

namespace porowave::verification {

namespace {

constexpr double tolerance = 1e-6;

bool close(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

/// A program with other numerics may have known fewer measures: what it has not measured is NaN.
bool not_measured_then(const Record& then, const Record& now, std::size_t measure) {
  return then.id != now.id && std::isnan(then.measures[measure]);
}

bool differs(const Record& then, const Record& now, std::size_t measure) {
  return !not_measured_then(then, now, measure) &&
         !close(then.measures[measure], now.measures[measure]);
}

bool same_outcome(const Record& then, const Record& now) {
  if (then.status != now.status || then.steps != now.steps) return false;
  for (std::size_t m = 0; m < then.measures.size(); ++m) {
    if (differs(then, now, m)) return false;
  }
  return true;
}

}  // namespace

Repetition repeat(const Store& store, const std::string& id) {
  const auto rows = store.beginning_with(id);
  if (rows.size() != 1) {
    throw InputError(fmt::format("{}: {} rows have an id that begins with {}: expected one",
                                 store.path(), rows.size(), id));
  }
  Repetition result;
  result.stored = rows.front();
  const std::string name = fmt::format("{}: case {}", store.path(), result.stored.id);
  StudyCase one;
  one.specification = result.stored.specification;
  const auto document = TomlDocument::parse(one.specification, name);
  if (document.section("adapter").present()) {
    throw InputError(name +
                     ": another solver ran it by an adapter: expected a case of ours; to "
                     "repeat this one, sweep its study into a new store");
  }
  one.scene = solver::read_case(document);
  one.id = case_id(one.specification, one.scene);
  result.now =
      CaseRunner(result.stored.study, current_provenance().id, {}, run_and_explain).run(one);
  result.same = same_outcome(result.stored, result.now);
  return result;
}

std::string comparison(const Repetition& repetition) {
  const Record& then = repetition.stored;
  const Record& now = repetition.now;
  const auto word = [](const Record& r) {
    return case_status_names[static_cast<std::size_t>(r.status)];
  };
  std::string text =
      fmt::format("{:<34} {:>14} {:>14}\n{:<34} {:>14} {:>14}\n{:<34} {:>14} {:>14}\n", "",
                  "stored", "now", "status", word(then), word(now), "steps", then.steps, now.steps);
  for (std::size_t m = 0; m < measure_names().size(); ++m) {
    text += fmt::format("{:<34} {:>14.6e} {:>14.6e}{}\n", measure_names()[m], then.measures[m],
                        now.measures[m], differs(then, now, m) ? "  differs" : "");
  }
  return text;
}

}  // namespace porowave::verification
