#pragma once

// Points for the tests: independent and uniform in the cube [low, high)^Dim, from a fixed seed.

#include <cstddef>
#include <random>
#include <tuple>
#include <type_traits>
#include <vector>

#include "solver/vector.hpp"

namespace porowave::solver::test {

using Dimensions = std::tuple<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                              std::integral_constant<int, 3>>;

template <int Dim>
std::vector<Vector<Dim>> random_points(std::size_t count, unsigned seed, double low = 0.0,
                                       double high = 1.0) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> coordinate(low, high);
  std::vector<Vector<Dim>> points(count);
  for (Vector<Dim>& x : points) {
    for (int a = 0; a < Dim; ++a) x[a] = coordinate(generator);
  }
  return points;
}

}  // namespace porowave::solver::test
