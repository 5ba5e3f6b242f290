#include "solver/particle_domain.hpp"

#include <algorithm>
#include <vector>

namespace porowave::solver {

namespace {

constexpr double least_stretch = 0.1;

}  // namespace

void stretch_domains(const Transfer<1>& transfer, std::span<const double> nodal_displacement,
                     std::span<double> domain) {
  std::vector<double> strain(domain.size());
  transfer.gradient_at_points(nodal_displacement, 0, strain);
  for (std::size_t p = 0; p < domain.size(); ++p) {
    domain[p] *= std::max(1.0 + strain[p], least_stretch);
  }
}

}  // namespace porowave::solver
