#pragma once

// Sorted points in a column, and choices of transfer, for the tests of the forms of a step.

#include <boost/test/unit_test.hpp>
#include <vector>

#include "solver/column_operators.hpp"
#include "solver/placement.hpp"
#include "solver/transfer_fixtures.hpp"

namespace porowave::solver::test {

inline constexpr int column_cells = 600;  // more than two parts

inline Grid<1> column_grid() {
  return {Vector<1>(0.0), 0.01, CellIndex<1>(column_cells)};
}

// Random in every cell, an empty element, sorted.
inline PointSet<1> column_points(int per_cell) {
  Discretization d;
  d.elements = column_cells;
  d.points_per_element = per_cell;
  d.placement = Placement::stratified;
  d.empty_elements = {3.005};
  PlacedPoints placed = place_points(d, 0.01, Phase::solid);
  std::sort(placed.x.begin(), placed.x.end());
  PointSet<1> points;
  for (std::size_t p = 0; p < placed.x.size(); ++p) {
    points.x.emplace_back(placed.x[p]);
    points.volume.push_back(placed.volume[p] * (1.0 + 0.1 * static_cast<double>(p % 3)));
    points.mass.push_back(density * points.volume.back());
  }
  return points;
}

// Regular in every cell, some of them empty.
inline PointSet<1> regular_points(int per_cell, const std::vector<double>& empty_elements = {}) {
  Discretization d;
  d.elements = column_cells;
  d.points_per_element = per_cell;
  d.placement = Placement::uniform;
  d.empty_elements = empty_elements;
  PlacedPoints placed = place_points(d, 0.01, Phase::solid);
  PointSet<1> points;
  for (std::size_t p = 0; p < placed.x.size(); ++p) {
    points.x.emplace_back(placed.x[p]);
    points.mass.push_back(density * placed.volume[p]);
  }
  points.volume = std::move(placed.volume);
  return points;
}

inline Discretization recovered(Discretization choice) {
  choice.strain = Strain::recovered;
  return choice;
}

inline Discretization adaptive(Discretization choice) {
  choice.adaptive_support = true;
  return choice;
}

inline std::string strain_title(const Discretization& choice) {
  return std::string(choice.strain == Strain::recovered ? ", recovered" : "") +
         (choice.adaptive_support ? ", adaptive" : "");
}

inline std::vector<Discretization> column_choices() {
  return {shape(),
          mls<BSpline1>(1.0, 0),
          mls<BSpline1>(1.0, 1),
          mls<BSpline2>(1.5, 1),
          mls<BSpline3>(2.0, 2),
          mls<WendlandC2>(5.0, 0),
          mls<WendlandC4>(3.25, 1),
          mls<WendlandC6>(2.0, 2),
          recovered(shape()),
          recovered(mls<BSpline2>(1.5, 1)),
          adaptive(mls<BSpline1>(1.0, 1)),
          recovered(adaptive(mls<BSpline2>(1.5, 1)))};
}

// Calls check(points, grid, choice) for all choices, few and many points a cell.
template <class F>
void for_all_columns(F&& check) {
  for (const int per_cell : {1, 4, 7}) {
    for (const Discretization& choice : column_choices()) {
      BOOST_TEST_CONTEXT(title(choice)
                         << strain_title(choice) << ", " << per_cell << " points a cell") {
        check(column_points(per_cell), column_grid(), choice);
      }
    }
  }
}

}  // namespace porowave::solver::test
