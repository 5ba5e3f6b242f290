#include "solver/regular_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace porowave::solver {

namespace {

// What rounded places do to the weights of a row: a place in elements is off by half a unit in the
// last place of the row's number, and slopes are about one an element. Found for all kernels, 1 to
// 8 points a cell, up to 100,000 cells: at most 1.2 such units.
double rounding_at(std::size_t row) {
  return 8.0 * std::numeric_limits<double>::epsilon() * static_cast<double>(row + 1);
}

// A symmetric row, and which others are like it.
class SymmetricRow {
 public:
  SymmetricRow(const BandedRows& rows, std::size_t row) : rows_(rows) {
    for (int d = 0; d <= reach(); ++d) values_.push_back(rows.value(row, d));
    while (values_.size() > 1 && std::abs(values_.back()) <= rounding_at(row)) values_.pop_back();
  }
  bool like(std::size_t row) const {
    const double tolerance = rounding_at(row);
    for (int d = -reach(); d <= reach(); ++d) {
      if (!(std::abs(rows_.value(row, d) - value(d)) <= tolerance)) return false;
    }
    return true;
  }
  // From the middle outwards.
  const std::vector<double>& values() const { return values_; }

 private:
  int reach() const { return static_cast<int>(rows_.reach()); }
  double value(int diagonal) const {
    const auto k = static_cast<std::size_t>(std::abs(diagonal));
    return k < values_.size() ? values_[k] : 0.0;
  }

  const BandedRows& rows_;
  std::vector<double> values_;
};

constexpr std::array coefficients{&NodeCoefficients::fluid_share, &NodeCoefficients::push,
                                  &NodeCoefficients::decay, &NodeCoefficients::solid_drive,
                                  &NodeCoefficients::fluid_drive};

bool like_first(const NodeCoefficients& eight, const NodeCoefficients& expected, double tolerance) {
  for (const auto coefficient : coefficients) {
    const double first = (expected.*coefficient)[0];
    // Stiff drag decays by the exponential of a large number, which has few digits.
    const double scale = coefficient == &NodeCoefficients::decay ? 1.0 : std::abs(first);
    for (const double value : eight.*coefficient) {
      if (!(std::abs(value - first) <= tolerance * scale)) return false;
    }
  }
  return true;
}

// What makes eight nodes, and the cells beside them, like others.
struct Likeness {
  SymmetricRow to_nodes;
  SymmetricRow to_cells;
  NodeCoefficients node;

  bool holds(std::size_t eight, const PreparedUpdate& update) const {
    const std::size_t row = eight * lanes;
    if (!like_first(update.coefficients(eight), node, rounding_at(row))) return false;
    if (!to_cells.like(row - 1)) return false;
    for (std::size_t r = row; r < row + lanes; ++r) {
      if (!to_nodes.like(r) || !to_cells.like(r)) return false;
    }
    return true;
  }
};

// S_i − S_(i−1) from the row of S.
std::vector<double> differences(const std::vector<double>& row) {
  std::vector<double> result = row;
  for (std::size_t k = 0; k + 1 < row.size(); ++k) result[k] -= row[k + 1];
  return result;
}

// The node's part of a stencil: move_free (free_node.hpp) as changes, sorted by what causes them.
void set_changes(const NodeCoefficients& node, double ns, double nf, RegularStencil& stencil) {
  const double share = node.fluid_share[0];
  const double push = node.push[0];
  const double solid_drive = node.solid_drive[0];
  RegularStencil::Change& lag = stencil.lag;
  lag = {node.decay[0] - 1.0, -solid_drive, ns * solid_drive - nf * node.fluid_drive[0]};
  stencil.solid = {-share * lag.relative, push - share * lag.effective,
                   -(ns + nf) * push - share * lag.pressure};
}

}  // namespace

RegularNodes::RegularNodes(const BandedRows& to_nodes, const BandedRows& to_cells,
                           const PreparedUpdate& update, double solid_fraction, double porosity,
                           std::size_t node_count) {
  const std::size_t eights = (node_count - 1) / lanes;  // the last node ends the column
  std::optional<Likeness> likeness;
  std::size_t first = 0;
  while (!likeness && ++first < eights) {
    if (!(update.coefficients(first).push[0] > 0.0)) continue;  // not a free node
    const std::size_t row = first * lanes;
    likeness.emplace(Likeness{SymmetricRow(to_nodes, row), SymmetricRow(to_cells, row),
                              update.coefficients(first)});
    if (!likeness->holds(first, update)) likeness.reset();
  }
  if (!likeness) return;
  stencil_.velocity = likeness->to_nodes.values();
  stencil_.force = differences(likeness->to_cells.values());
  set_changes(likeness->node, solid_fraction, porosity, stencil_);

  runs_.assign((node_count - 1) / BandedRows::block_rows + 1, IndexRange{0, 0});
  IndexRange run{first, first};
  for (std::size_t k = first; k < eights; ++k) {
    if (k % eights_of_block == 0 || run.last != k) run = {k, k};
    if (!likeness->holds(k, update)) continue;
    run.last = k + 1;
    IndexRange& longest = runs_[k / eights_of_block];
    if (run.size() > longest.size()) longest = run;
  }
}

}  // namespace porowave::solver
