#include "reference/node_table.hpp"

#include <numbers>

namespace porowave::reference {

NodeTable::NodeTable(const Problem& problem, const WaveModes& modes, const Hyperbola& contour,
                     WaveModes::Cut cut, const LoadTransform* load)
    : problem_(&problem), modes_(&modes), contour_(contour), cut_(cut), load_(load) {}

Node NodeTable::at(double u) const {
  // (1/2 pi i) ds = (1/2 pi i) s'(u) du; the lower half is the conjugate of the upper one.
  const double halves = u == 0.0 ? 1.0 : 2.0;
  const Complex s = contour_.point(u);
  const Complex weight =
      halves / (2.0 * std::numbers::pi) * contour_.tangent(u) / Complex(0.0, 1.0);
  Node node{u, s, weight, state_at(s), std::nullopt};
  if (load_ != nullptr) node.settled = load_->settled(s);
  return node;
}

WaveState NodeTable::state_at(Complex s) const {
  return wave_state(*problem_, *modes_, modes_->at(s, cut_));
}

const Node& NodeTable::at(int level, std::size_t j) {
  const auto index = static_cast<std::size_t>(level);
  if (levels_.size() <= index) levels_.resize(index + 1);
  auto& nodes = levels_[index];
  while (nodes.size() <= j) {
    const double place = static_cast<double>(nodes.size());
    // The places that level 1, 2, ... add lie half-way between those of the levels before.
    nodes.push_back(level == 0 ? at(place * first_step) : at((2.0 * place + 1.0) * step(level)));
  }
  return nodes[j];
}

}  // namespace porowave::reference
