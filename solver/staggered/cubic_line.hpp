#pragma once

// Values at regular places along the column and the cubics through four neighbouring ones, read as
// value or slope at any x: the interpolation of staggered4 and, read half-way between places, its
// fourth-order staggered difference (9/8, −1/24).
//
// Beyond an end the values are continued as its rule says; where nothing is known, the last cubic
// serves up to the end.

#include <array>
#include <cstddef>
#include <vector>

namespace porowave::solver {

enum class EndRule {
  open,  // nothing is known at the end
  held,  // the value at the end itself is known: one more place (cell middles only)
  odd,   // mirrored with the opposite sign: velocities at a rigid wall
  even,  // mirrored: stresses at a rigid wall
};

// The cubic at one x as weights of four values.
struct CubicRow {
  std::array<std::size_t, 4> index;  // may repeat where values are mirrored
  std::array<double, 4> weight;      // of a slope in 1/length
};

class CubicLine {
 public:
  // cells + 1 places at the nodes i h; index i. Rules: open, odd or even.
  static CubicLine nodes(std::size_t cells, double spacing, EndRule near, EndRule far);
  // `cells` places at the middles (c + 1/2) h with index c + 1; index 0 and cells + 1 are the
  // values at x = 0 and x = cells h, used where the rule is held.
  static CubicLine middles(std::size_t cells, double spacing, EndRule near, EndRule far);
  // Both throw std::invalid_argument for fewer than 4 cells or a spacing that is not positive.

  CubicRow value(double x) const;
  CubicRow slope(double x) const;

 private:
  struct Place {
    double x;
    std::size_t index;
    double sign;
  };

  CubicLine() = default;
  void add_ghosts(EndRule near, EndRule far, double length);
  std::size_t first_of_stencil(double x) const;

  std::vector<Place> places_;  // ascending in x
};

}  // namespace porowave::solver
