#pragma once

// Finds the nodes amid points at regular places. There the rows of W and B (frozen_column.hpp) and
// the masses repeat from node to node, but for the rounding of the places, and rows are symmetric:
// one stencil serves them all. What that leaves out is no more than rounding the places otherwise
// would change.
//
// Elsewhere (ends, gaps, points at random) nothing repeats, and every node keeps its own row.

#include <vector>

#include "solver/banded_rows.hpp"
#include "solver/prepared_update.hpp"
#include "solver/regular_step.hpp"

namespace porowave::solver {

class RegularNodes {
 public:
  RegularNodes() = default;  // none
  // W and B, the same for both phases; `update` of all `node_count` nodes.
  RegularNodes(const BandedRows& to_nodes, const BandedRows& to_cells, const PreparedUpdate& update,
               double solid_fraction, double porosity, std::size_t node_count);

  // The longest run of regular nodes in a block of BandedRows::block_rows, in eights of the column:
  // nodes 8 first ... 8 last − 1. All of its rows, and those of the cells beside it, are alike.
  // {0, 0} if there is none.
  IndexRange in_block(std::size_t block) const {
    return runs_.empty() ? IndexRange{0, 0} : runs_[block];
  }
  const RegularStencil& stencil() const { return stencil_; }

 private:
  RegularStencil stencil_;
  std::vector<IndexRange> runs_;
};

}  // namespace porowave::solver
