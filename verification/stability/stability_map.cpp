#include "verification/stability/stability_map.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <mutex>

#include "reference/problem/errors.hpp"
#include "verification/parallel.hpp"

namespace porowave::verification {

namespace {

MappedStability mapped(const solver::Case& scene, const solver::CriticalSettings& settings) {
  MappedStability found;
  try {
    solver::GrowthSettings of_growth;
    of_growth.limit = settings.limit;
    solver::SceneGrowth growth(scene, of_growth);
    found.crossing = growth.time_step(1.0);
    found.critical = solver::critical_step(
        [&](double courant) { return growth.at(courant).per_step; }, settings);
  } catch (const BreakdownError& error) {
    found.refused = error.what();
  }
  return found;
}

std::string in_quotes(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string in_csv(const std::string& text) {
  return text.find_first_of(",\"\n") == std::string::npos ? text : in_quotes(text);
}

std::string plain_text(const TomlValue& value) {
  const auto* word = std::get_if<std::string>(&value.value);
  return word != nullptr ? *word : value.text();
}

std::vector<MappedStability> stability_map(const Study& study,
                                           const solver::CriticalSettings& settings, int jobs,
                                           const std::function<void(std::size_t)>& progress) {
  std::vector<MappedStability> map(study.cases.size());
  std::mutex one_at_a_time;
  std::size_t done = 0;
  const auto fill = [&](std::size_t i) {
    map[i] = mapped(study.cases[i].scene, settings);
    const std::scoped_lock lock(one_at_a_time);
    ++done;
    if (progress) progress(done);
  };
  parallel_for(map.size(), fill, static_cast<std::size_t>(std::max(jobs, 0)));
  return map;
}

void write_map_csv(const Study& study, const std::vector<MappedStability>& map, std::ostream& out) {
  for (const Axis& axis : study.axes) out << axis.name() << ',';
  out << "critical_courant,unstable_courant,critical_time_step,unstable_below,growth_below,"
         "refused\n";
  for (std::size_t i = 0; i < map.size(); ++i) {
    for (const TomlValue& value : study.cases[i].coordinates) {
      out << in_csv(plain_text(value)) << ',';
    }
    const MappedStability& one = map[i];
    if (!one.refused.empty()) {
      out << ",,,,," << in_quotes(one.refused) << '\n';
      continue;
    }
    double growth = 0.0;
    const auto below = one.critical.unstable_below();
    for (const auto& sample : below) growth = std::max(growth, sample.growth - 1.0);
    const std::string unstable =
        one.critical.unstable > 0.0 ? fmt::format("{:.6g}", one.critical.unstable) : "";
    fmt::print(out, "{:.6g},{},{:.6g},{},{:.4g},\n", one.critical.courant, unstable,
               one.critical.courant * one.crossing, below.size(), growth);
  }
}

}  // namespace porowave::verification
