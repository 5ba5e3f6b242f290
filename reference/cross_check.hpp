#pragma once

#include <span>
#include <string>
#include <vector>

#include "reference/route.hpp"

namespace porowave::reference {

/// Two routes' values of one field at one point.
struct Disagreement {
  double difference = 0.0;  ///< relative to the load
  double allowed = 0.0;     ///< sum of what both state as their error, relative to the load
  std::string_view field = "";
  double x = 0.0;
  double t = 0.0;
  double main = 0.0;   ///< what the main route says, Pa or m/s
  double other = 0.0;  ///< what the other one says
};

/// One route against the main one.
struct RouteCheck {
  std::string route;
  std::string obstacle;      ///< why it was not compared; empty if it was
  std::size_t compared = 0;  ///< values, four at a point
  /// Values that one of the two did not find, or not to 1e-6 of the load: they would show nothing.
  std::size_t too_inaccurate = 0;
  bool agrees = true;  ///< no difference is larger than allowed
  /// Where the difference is largest; if they disagree, where it exceeds most what is allowed.
  Disagreement worst;
};

struct CrossCheck {
  std::vector<RouteCheck> routes;

  /// False if any two routes disagree.
  bool agree() const;
  /// Values compared, of all routes.
  std::size_t compared() const;
};

/// Compares routes with the main one at all x and t, field by field. A difference is allowed up to
/// the sum of both errors and 1e-12 of the load, for rounding in their comparison. Throws
/// InputError if an x lies outside of the column.
CrossCheck compare_routes(const Problem& problem, const Route& main, std::span<const Route> others,
                          const std::vector<double>& x, const std::vector<double>& t);

/// The same with all routes that this library has.
CrossCheck compare_routes(const Problem& problem, const std::vector<double>& x,
                          const std::vector<double>& t);

}  // namespace porowave::reference
