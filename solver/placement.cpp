#include "solver/placement.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace porowave::solver {

namespace {

// Uniform on [0, 1) from the upper 53 bits: std::uniform_real_distribution is not the same
// everywhere, std::mt19937_64 and std::seed_seq are.
class Uniform {
 public:
  Uniform(std::uint64_t seed, Phase phase) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(phase)};
    generator_.seed(sequence);
  }
  double operator()() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 generator_;
};

// Position of point number `index` of all, in units of h.
double position(const Discretization& d, int index, Uniform& uniform) {
  const int n = d.points_per_element;
  const int cell = index / n;
  const double regular = cell + (index % n + 0.5) / n;
  switch (d.placement) {
    case Placement::uniform:
      return regular;
    case Placement::jittered:
      return regular + d.jitter * (uniform() - 0.5) / n;
    case Placement::stratified:
      return cell + uniform();
    case Placement::random:
      return d.elements * uniform();
  }
  return regular;
}

int element_of(double x_in_h, int elements) {
  return std::clamp(static_cast<int>(std::floor(x_in_h)), 0, elements - 1);
}

}  // namespace

PlacedPoints place_points(const Discretization& d, double spacing, Phase phase) {
  std::set<int> empty;
  for (const double x : d.empty_elements) empty.insert(element_of(x / spacing, d.elements));
  Uniform uniform(d.seed, phase);
  PlacedPoints points;
  for (int index = 0; index < d.elements * d.points_per_element; ++index) {
    const double x_in_h = position(d, index, uniform);
    if (empty.contains(element_of(x_in_h, d.elements))) continue;
    points.x.push_back(x_in_h * spacing);
    points.volume.push_back(spacing / d.points_per_element);
  }
  return points;
}

}  // namespace porowave::solver
