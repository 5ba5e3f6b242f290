#include "verification/wave_measures/wave_measures.hpp"

#include <cmath>
#include <utility>

#include "verification/wave_measures/arrival_delay.hpp"

namespace porowave::verification {

namespace {

/// Calls take(name, value) for every number, the one place where names and values meet. A name is
/// that of a field (or empty) and what follows it.
template <class Take>
void for_each_number(const WaveMeasures& m, Take take) {
  take("fast", "_arrival_delay", m.arrival_delay[0]);
  take("slow", "_arrival_delay", m.arrival_delay[1]);
  take("fast", "_arrival_error", std::abs(m.arrival_delay[0]));
  take("slow", "_arrival_error", std::abs(m.arrival_delay[1]));
  for (std::size_t f = 0; f < field_names.size(); ++f) {
    take(field_names[f], "_overshoot", m.overshoot[f].excess);
    take(field_names[f], "_total_variation", m.overshoot[f].total_variation);
    take(field_names[f], "_ringing", m.ringing[f].amplitude);
    take(field_names[f], "_ringing_share", m.ringing[f].share);
  }
  take("gap", "_reflected", m.gap.reflected);
  take("gap", "_transmitted", m.gap.transmitted);
  take("energy", "_drift_points", m.energy.points);
  take("energy", "_drift_field", m.energy.field);
  take("energy", "_error_points", std::abs(m.energy.points));
  take("energy", "_error_field", std::abs(m.energy.field));
}

}  // namespace

WaveMeasures wave_measures(const solver::Case& scene, const reference::Profile& profile,
                           const solver::Snapshot& snapshot, const ReferenceValues& reference) {
  WaveMeasures m;
  m.arrival_delay = arrival_delays(scene.problem, profile, snapshot, reference);
  const GridFields found = grid_fields(snapshot);
  const GridFields exact = grid_fields(reference);
  for (std::size_t f = 0; f < field_names.size(); ++f) {
    m.overshoot[f] = overshoot(found[f], exact[f]);
    m.ringing[f] = ringing(found[f], exact[f], f < 2 ? Places::cell_middles : Places::nodes);
  }
  m.gap = gap_amplitudes(scene, snapshot, reference);
  m.energy = energy_drift(scene.problem.material, snapshot, reference);
  return m;
}

const std::vector<std::string>& wave_measure_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for_each_number({}, [&](std::string_view of, std::string_view what, double) {
      list.push_back(std::string(of).append(what));
    });
    return list;
  }();
  return names;
}

std::vector<double> wave_measure_values(const WaveMeasures& measures) {
  std::vector<double> values;
  values.reserve(wave_measure_names().size());
  for_each_number(
      measures, [&](std::string_view, std::string_view, double value) { values.push_back(value); });
  return values;
}

}  // namespace porowave::verification
