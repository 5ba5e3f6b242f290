#pragma once

// Strain rates at the points from those of the cells, in one dimension.
//
// Linear shape functions give one strain a cell, which is right in its middle only. `recovered`
// interpolates linearly between the middles of the point's cell and of the next cell on its side:
//
//   point at the share t of cell c, s = |t − 1/2|, n the neighbour on its side, o the other one
//   (1 − s) e_c + s e_n;  (1 + s) e_c − s e_o where there is no n;  e_c where there is neither
//
// which is exact for linear strains, up to the ends of the column. A neighbour counts when its
// strain is that of material: points reach both of its nodes and its middle. So nothing looks
// across a numerical crack.
//
// `lend_empty` is what an adaptive support needs. The strain of a cell without points is felt by no
// point: the cell can open and close without any stress, nothing drives it, and it stays rigid,
// which reflects waves with an amplitude of the order of h. Here points next to such a cell
// interpolate towards it as above; all others keep the strain of their own cell.

#include <span>
#include <vector>

#include "solver/weights.hpp"

namespace porowave::solver {

enum class StrainSharing { lend_empty, recovered };

// Rows from nodal values (grid.node_count()) to their gradient at the points. `is_material` per
// cell. Throws std::invalid_argument for lengths that do not fit and positions that are not finite.
SparseRows shared_strain_rows(std::span<const Vector<1>> points, const Grid<1>& grid,
                              const std::vector<bool>& is_material, StrainSharing sharing);

}  // namespace porowave::solver
