#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/bounded_fields.hpp"

namespace porowave::reference {

/// The independent ways to the exact solution, the main one first.
enum class Method {
  contour,   ///< ColumnSolution
  bromwich,  ///< BromwichSolution, by GSL
  modal,     ///< ModalSolution, by FFTW
};
inline constexpr std::array<std::string_view, 3> method_names = {"contour", "bromwich", "modal"};

constexpr std::string_view name(Method method) {
  return method_names[static_cast<std::size_t>(method)];
}

/// One way to the fields of one problem.
struct Route {
  std::string name;
  std::string obstacle;  ///< why it cannot do this problem; empty if it can
  /// Fields at some x and one t. Throws InputError outside of the column, and where it has an
  /// obstacle.
  std::function<std::vector<BoundedFields>(const std::vector<double>& x, double t)> fields;
};

Route route(Method method, const Problem& problem);

}  // namespace porowave::reference
