#include "solver/particle_domain.hpp"

#include <algorithm>

namespace porowave::solver {

namespace {

constexpr double least_stretch = 0.1;

}  // namespace

void stretch_domains(std::span<const double> strain, std::span<double> domain) {
  for (std::size_t p = 0; p < domain.size(); ++p) {
    domain[p] *= std::max(1.0 + strain[p], least_stretch);
  }
}

}  // namespace porowave::solver
