// Wrong placements of points. A lost point hardly changes the errors of moving least squares, so no
// study sees it: what must hold of the points themselves does.

#include <cmath>
#include <numeric>

#include "verification/faults/point_check.hpp"

namespace porowave::verification::faults {

using solver::Discretization;
using solver::Phase;
using solver::PlacedPoints;
using solver::Placement;

namespace {

constexpr int elements = 40;
constexpr double spacing = 0.25;

Discretization choice(Placement placement, int seed) {
  Discretization d;
  d.elements = elements;
  d.points_per_element = 3;
  d.placement = placement;
  d.seed = seed;
  return d;
}

Fault in_points(const std::string& what, const std::string& named, const PlaceFunction& wrong) {
  return {"solver", what, named, [wrong] { return caught_by_point_facts(wrong); }};
}

/// The right points after something was done to them.
PlaceFunction changed(const std::function<void(PlacedPoints&)>& change) {
  return [change](const Discretization& d, double h, Phase phase) {
    PlacedPoints placed = solver::place_points(d, h, phase);
    change(placed);
    return placed;
  };
}

}  // namespace

Catch caught_by_point_facts(const PlaceFunction& place) {
  const std::string by = "facts of points";
  for (const Placement placement : {Placement::uniform, Placement::stratified}) {
    const PlacedPoints points = place(choice(placement, 1), spacing, Phase::solid);
    std::vector<int> count(elements);
    for (const double x : points.x) {
      const double cell = std::floor(x / spacing);
      if (!(cell >= 0.0 && cell < elements)) return {by, "does not hold: points lie in the column"};
      ++count[static_cast<std::size_t>(cell)];
    }
    for (const int n : count) {
      if (n != 3) return {by, "does not hold: as many points in every cell as asked for"};
    }
    const double volume = std::accumulate(points.volume.begin(), points.volume.end(), 0.0);
    if (!(std::abs(volume - elements * spacing) < 1e-12)) {
      return {by, "does not hold: the volumes fill the column"};
    }
  }
  const auto random = [&](int seed, Phase phase) {
    return place(choice(Placement::stratified, seed), spacing, phase).x;
  };
  if (random(1, Phase::solid) == random(2, Phase::solid)) {
    return {by, "does not hold: another seed places other points"};
  }
  if (random(1, Phase::solid) == random(1, Phase::fluid)) {
    return {by, "does not hold: random points of the phases are not the same"};
  }
  return {by, ""};
}

std::vector<Fault> point_faults() {
  return {
      in_points("one point of the solid is lost", "as many points in every cell",
                changed([](PlacedPoints& points) {
                  points.x.pop_back();
                  points.volume.pop_back();
                })),
      in_points("volumes of points as if there were one more in a cell", "volumes fill",
                changed([](PlacedPoints& points) {
                  for (double& v : points.volume) v *= 0.75;
                })),
      in_points("points a whole cell to the right", "lie in the column",
                changed([](PlacedPoints& points) {
                  for (double& x : points.x) x += spacing;
                })),
      in_points("the seed is ignored", "another seed",
                [](Discretization d, double h, Phase phase) {
                  d.seed = 1;
                  return solver::place_points(d, h, phase);
                }),
      in_points("both phases get the same random points", "phases are not the same",
                [](const Discretization& d, double h, Phase) {
                  return solver::place_points(d, h, Phase::solid);
                }),
  };
}

}  // namespace porowave::verification::faults
