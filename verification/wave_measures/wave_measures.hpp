#pragma once

#include <array>
#include <string>
#include <vector>

#include "verification/wave_measures/energy_drift.hpp"
#include "verification/wave_measures/gap_amplitudes.hpp"
#include "verification/wave_measures/overshoot.hpp"
#include "verification/wave_measures/ringing.hpp"

namespace porowave::verification {

/// What a run does to waves, beside the norms of its errors. Of fields: the reconstructed ones, in
/// the order of field_names. NaN where a measure is not defined; its header says where.
struct WaveMeasures {
  std::array<double, 2> arrival_delay;  ///< s, of the fast and of the slow wave
  std::array<Overshoot, 4> overshoot;
  std::array<Ringing, 4> ringing;
  GapAmplitudes gap;
  EnergyDrift energy;
};

/// Of a snapshot and the reference at its time, for the case's problem and its empty elements.
WaveMeasures wave_measures(const solver::Case& scene, const reference::Profile& profile,
                           const solver::Snapshot& snapshot, const ReferenceValues& reference);

/// Names under which a store has them. Delays and drifts come twice: with their sign, and as
/// `..._error` without it, for gates, which need numbers above zero.
///
///   fast_arrival_delay, slow_..., fast_arrival_error, slow_...                   s
///   FIELD_overshoot, FIELD_total_variation, FIELD_ringing, FIELD_ringing_share   dimensionless
///   gap_reflected, gap_transmitted                                               dimensionless
///   energy_drift_points, energy_drift_field, energy_error_points, ...            dimensionless
const std::vector<std::string>& wave_measure_names();
/// The numbers in the order of the names.
std::vector<double> wave_measure_values(const WaveMeasures& measures);

}  // namespace porowave::verification
