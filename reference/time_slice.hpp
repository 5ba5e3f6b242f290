#pragma once

#include <list>

#include "reference/column_solution.hpp"
#include "reference/inversion.hpp"

namespace porowave::reference {

/// The solution at one time. Contours and their nodes, found for one point, serve its neighbours:
/// many points of a time cost a tenth of as many single ones.
///
/// Values and bounds are those of ColumnSolution::at or ::time_integral. Not to be shared by
/// threads.
class TimeSlice {
 public:
  /// `solution` must outlive the slice. Throws InputError for a time that is not finite.
  /// With TimeIntegral::once the slice is that of the fields' integrals over time.
  TimeSlice(const ColumnSolution& solution, double t, TimeIntegral integral = TimeIntegral::none);
  // Its contours refer to its load.
  TimeSlice(const TimeSlice&) = delete;
  TimeSlice& operator=(const TimeSlice&) = delete;

  /// Fields at 0 <= x <= length. Throws InputError for other x.
  BoundedFields at(double x);

 private:
  struct Known {
    double age;
    Arrival::Part part;
    double worst;  ///< bound that it gave where it was found
    NodeTable table;
  };
  Inverted invert_group(const ArrivalGroup& group, int splits);
  Inverted by_contour(const ArrivalGroup& group, Integrand& integrand);
  /// Values at the fronts themselves at t = 0; returns the jumps that rounding of an arrival may
  /// hide.
  FourSums add_fronts(const std::vector<Ray>& rays, FourSums& value, FourSums& error) const;

  const ColumnSolution& solution_;
  double t_;
  double uncertainty_;
  LoadTransform load_;
  FourSums unit_;
  std::list<Known> known_;  ///< contours that served, the latest first
};

}  // namespace porowave::reference
