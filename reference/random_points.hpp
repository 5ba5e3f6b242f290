#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reference/column_solution.hpp"
#include "reference/random_problems.hpp"

/// Random points of the whole range that the reference states to be valid in.
namespace porowave::fixtures {

struct RandomPoint {
  Problem problem;
  double x;
  double t;
  std::string place;  ///< what is special about (x, t)
};

/// Porosity 0.02 to 0.98, E_oed/K_f 1e-6 to 1e6, permeability 1e-18 to 1e-2 m^2, relaxation_rate *
/// t up to 1e8, every near and far end, every load, up to 300 crossings of the fast wave; half of
/// the points anywhere, the others where formulas break.
class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : random_(seed) {}

  RandomPoint next() {
    const Material dry = material();
    const double length = random_.log_uniform(0.01, 100.0);
    const double crossing = length / wave_speeds(dry).p1;
    const double t = crossing * (random_.index(4) > 0 ? random_.uniform(0.01, 4.0)
                                                      : random_.log_uniform(4.0, 300.0));
    Material m = dry;
    do {
      m.intrinsic_permeability = random_.log_uniform(1e-18, 1e-2);
    } while (m.relaxation_rate() * t > 1e8);
    const auto near = static_cast<NearEnd>(random_.index(4));
    const auto far = static_cast<FarEnd>(random_.index(4));
    Column column{length, near, far};
    if (far == FarEnd::half_space) column.length.reset();
    RandomPoint point{{m, column, load(t)}, 0.0, t, ""};
    place(length, point);
    return point;
  }

 private:
  Material material() {
    Material m{random_.uniform(0.02, 0.98),    random_.uniform(1500, 4000),
               random_.uniform(600, 1400),     1.0,
               random_.log_uniform(1e7, 1e10), 1.0,
               random_.log_uniform(1e-4, 1e-1)};
    m.constrained_modulus = m.fluid_bulk_modulus * random_.log_uniform(1e-6, 1e6);
    return m;
  }

  Load load(double t) {
    const double duration = t * random_.log_uniform(0.01, 5.0);
    const auto shape = static_cast<LoadShape>(random_.index(6));
    if (shape != LoadShape::table) return {shape, random_.log_uniform(1e-3, 1e6), duration};
    std::vector<double> times = {0.0};
    std::vector<double> values = {random_.index(2) * random_.uniform(-1, 1)};
    const int count = 2 + random_.index(6);
    for (int i = 1; i < count; ++i) {
      times.push_back(i * duration / count * random_.uniform(0.8, 1.0));
      values.push_back(random_.uniform(-1, 1));
    }
    values.back() = 1.0;
    return {random_.log_uniform(1e-3, 1e6), times, values};
  }

  void place(double length, RandomPoint& point) {
    const reference::ColumnSolution solution(point.problem);
    point.x = length * random_.uniform(0.0, 1.0);
    switch (random_.index(12)) {
      case 0:
        point.place = "near end";
        point.x = 0.0;
        break;
      case 1:
        point.place = "far end";
        point.x = length;
        break;
      case 2:
        point.place = "1e-9 of the length from an end";
        point.x = random_.index(2) == 0 ? 1e-9 * length : length * (1 - 1e-9);
        break;
      case 3:
      case 4: {
        const auto fronts = solution.fronts(point.t);
        if (fronts.empty()) break;
        point.place = "1e-9 of the length from a front";
        const double front =
            fronts[static_cast<std::size_t>(random_.index(static_cast<int>(fronts.size())))];
        point.x = std::min(length,
                           std::max(0.0, front + (random_.index(2) == 0 ? -1e-9 : 1e-9) * length));
        break;
      }
      case 5: {
        const auto fronts = solution.fronts(point.t);
        if (fronts.empty()) break;
        point.place = "on a front";
        point.x = std::min(
            length,
            fronts[static_cast<std::size_t>(random_.index(static_cast<int>(fronts.size())))]);
        break;
      }
      default:
        point.place = "anywhere";
        break;
    }
  }

  RandomProblems random_;
};

}  // namespace porowave::fixtures
