#pragma once

#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "verification/methods.hpp"
#include "verification/run.hpp"

namespace porowave::verification {

/// One method at one resolution.
struct WorkPrecision {
  Method method;             ///< its case with the elements of this run
  RunResult run;             ///< of the last repetition; errors are the same in all
  double cpu_seconds = 0.0;  ///< median of the repetitions

  /// Largest of the relative L2 errors of the four reconstructed fields: at this level all are.
  double error() const;
};

/// Measures every method at every resolution, with the step of courant = "auto". All methods are
/// judged by the reference of the first: they must share problem and end. Repetitions are
/// interleaved: all methods once, then all of them again, so that a machine that is busy for a
/// while slows all of them. Throws BreakdownError if a run breaks down, solver::NoStableStep if a
/// method has no stable step, std::invalid_argument for fewer than one repetition.
std::vector<WorkPrecision> measure(std::span<const Method> methods, std::span<const int> elements,
                                   int repetitions);

/// Indices of the measurements that no cheaper one is as accurate as, from cheap to expensive;
/// errors that are not finite have no place in it.
std::vector<std::size_t> pareto_front(std::span<const WorkPrecision> measured);

/// The cheapest measurement with an error of at most `level`; measured.size() if there is none.
std::size_t cheapest_within(std::span<const WorkPrecision> measured, double level);

/// transfer,kernel,support_radius,basis_order,strain,scheme,time_order,placement,
/// points_per_element,elements,courant,steps, then L2 errors of every field (FIELD_l2_points,
/// FIELD_l2_field), cpu_seconds,ns_per_point_step. One row a measurement.
void write_work_precision_csv(std::span<const WorkPrecision> measured, std::ostream& out);

/// For every error level its cheapest method, elements and CPU time, for people.
std::string best_of_levels(std::span<const WorkPrecision> measured,
                           std::span<const double> error_levels);

}  // namespace porowave::verification
