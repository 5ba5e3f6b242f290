#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace porowave::verification {

/// How a case ended. Only `failed` is tried again: memory was short, say; the others would end the
/// same way.
enum class CaseStatus { done, broke_down, refused, failed };
inline constexpr std::array<std::string_view, 4> case_status_names = {"done", "broke_down",
                                                                      "refused", "failed"};

/// Names of the numbers that a run is measured by, in the order of Record::measures: for each field
/// the relative norms at the points and of the reconstructed field, such as
/// "effective_stress_field_l2" (24), then "reference_error" and "largest_strain", then those of
/// wave_measures.hpp. New ones come last.
const std::vector<std::string>& measure_names();
/// Index of a name in measure_names(); none if there is no such measure.
std::optional<std::size_t> measure_index(std::string_view name);

/// One row of a store: a case and what came of it. Only numbers that must be the same in every
/// repetition stand before `cpu_seconds`.
struct Record {
  std::string id;
  std::string study;
  std::string specification;  ///< the case as TOML, with [adapter] if another solver ran it
  CaseStatus status = CaseStatus::done;
  std::string reason;  ///< of a status other than done
  std::int64_t steps = 0;
  double time_step = 0.0;  ///< s
  std::int64_t points = 0;
  std::vector<double> measures;  ///< NaN where there is none
  double cpu_seconds = 0.0;
  double wall_seconds = 0.0;
  std::int64_t peak_rss_bytes = 0;
  /// Speed of the machine when the case was run (cost/calibration.hpp), ns; NaN if not measured.
  double calibration_ns = std::numeric_limits<double>::quiet_NaN();
  std::string finished;    ///< UTC, "2026-11-22T08:00:00Z"
  std::string provenance;  ///< id of a row of the table provenance

  double ns_per_point_step() const {
    return 1e9 * cpu_seconds / static_cast<double>(points) / static_cast<double>(steps);
  }
  /// CPU time of a point and step in that of a point of the calibration's stencil.
  double relative_cost() const { return ns_per_point_step() / calibration_ns; }
};

/// Where results come from: program, compiler, machine.
struct Provenance {
  std::string id;  ///< hash of the rest
  std::string version;
  std::string git;
  std::string numerics;
  std::string compiler;
  std::string flags;
  std::string cpu;
  std::string host;
};
/// Of this program on this machine.
Provenance current_provenance();

}  // namespace porowave::verification
