#pragma once

// The part of an endless one-dimensional grid, nodes at i h, that a body [a, b] fills. Its ends may
// lie anywhere in a cell.
//
//   cells     those that the body touches; of each the filled length l_c and the middle of the
//             filled part, where linear functions are integrated exactly by one value
//   inner     nodes inside the body or on its ends: the unknowns
//   outer     at most one node beyond either end, the far corner of a partly filled cell. It
//             follows the line through the two inner nodes next to it, so the functions of the two
//             are continued into the cell (extended functions of Höllig, Reif & Wipper 2001,
//             doi:10.1137/S0036142900373208, in one dimension). However thin the filled part, no
//             node has a small mass, and fields up to linear ones stay reproduced to the ends.
//
// Nodes and cells have their numbers in the endless grid; arrays over them start at first_node()
// and first_cell(). All lengths in m, per unit area.

#include <span>
#include <vector>

namespace porowave::solver {

class FilledGrid {
 public:
  // Throws std::invalid_argument unless 0 < h < ∞ and a < b are finite, and the body has at least
  // three inner nodes.
  FilledGrid(double spacing, double near, double far);

  double spacing() const { return spacing_; }
  double near() const { return near_; }
  double far() const { return far_; }

  long first_node() const { return first_node_; }
  long last_node() const { return last_node_; }
  long first_inner() const { return first_inner_; }
  long last_inner() const { return last_inner_; }
  std::size_t node_count() const { return static_cast<std::size_t>(last_node_ - first_node_) + 1; }
  long first_cell() const { return first_node_; }
  std::size_t cell_count() const { return node_count() - 1; }

  double node_position(long node) const { return spacing_ * static_cast<double>(node); }
  double filled_length(long cell) const;
  double filled_middle(long cell) const;

  // ∫ of the extended functions over the body; zero at outer nodes.
  std::vector<double> nodal_volume() const;
  // Values of the outer nodes from those of the inner ones.
  void extend(std::span<double> nodal) const;
  // The transpose: what acts on outer nodes goes to inner ones.
  void collect(std::span<double> nodal) const;
  // Adds s_c ∫ −∂N_i/∂x of all cells, and the stresses that act on the ends, to the force on the
  // nodes; then collects it.
  void internal_force(std::span<const double> cell_stress, double near_stress, double far_stress,
                      std::span<double> force) const;
  // The value of a nodal field (outer nodes included) at x inside the body.
  double value(std::span<const double> nodal, double x) const;

 private:
  std::size_t at(long node) const { return static_cast<std::size_t>(node - first_node_); }
  long cell_of(double x) const;

  double spacing_;
  double near_;
  double far_;
  long first_node_ = 0;
  long last_node_ = 0;
  long first_inner_ = 0;
  long last_inner_ = 0;
};

}  // namespace porowave::solver
