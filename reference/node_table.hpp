#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "reference/contour.hpp"
#include "reference/load_transform.hpp"
#include "reference/rays.hpp"

namespace porowave::reference {

/// One node of the upper half of a contour.
struct Node {
  double u;
  Complex s;
  Complex weight;  ///< of the inverse at step 1 in u: Re(weight * transform) counts both halves
  WaveState state;
  std::optional<ScaledTransform> settled;  ///< of the load, if the table keeps it
};

/// Nodes of the trapezoidal rule on a hyperbola, nested: level 0 has step 1/2 in u, each further
/// level the places half-way between those there are. They do not depend on the point, so one table
/// serves many points of a time. Made as they are asked for.
class NodeTable {
 public:
  /// With a load, whose settled transform is kept at every node; it must outlive the table.
  NodeTable(const Problem& problem, const WaveModes& modes, const Hyperbola& contour,
            WaveModes::Cut cut, const LoadTransform* load = nullptr);

  static constexpr double first_step = 0.5;
  static double step(int level) { return first_step / static_cast<double>(1 << level); }

  /// Node j of those that `level` adds.
  const Node& at(int level, std::size_t j);
  Node at(double u) const;
  WaveState state_at(Complex s) const;

  const Hyperbola& contour() const { return contour_; }

 private:
  const Problem* problem_;
  const WaveModes* modes_;
  Hyperbola contour_;
  WaveModes::Cut cut_;
  const LoadTransform* load_;
  std::vector<std::vector<Node>> levels_;
};

}  // namespace porowave::reference
