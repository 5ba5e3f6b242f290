#include "verification/faults/open_reference.hpp"

#include <cmath>
#include <numbers>

namespace porowave::verification::faults {

using namespace porowave::reference;

namespace {

constexpr int nodes = 18;

struct ContourNode {
  Complex s;
  Complex weight;  ///< e^(s tau) ds/dtheta and all factors
};

std::vector<ContourNode> talbot(double tau, double first_weight) {
  const double r = 0.4 * nodes / tau;
  std::vector<ContourNode> contour = {{r, first_weight * r / nodes * std::exp(r * tau)}};
  for (int k = 1; k < nodes; ++k) {
    const double theta = k * std::numbers::pi / nodes;
    const double cotangent = 1.0 / std::tan(theta);
    const Complex s = r * theta * Complex(cotangent, 1.0);
    const double sigma = theta + (theta * cotangent - 1.0) * cotangent;
    contour.push_back({s, r / nodes * std::exp(s * tau) * Complex(1.0, sigma)});
  }
  return contour;
}

}  // namespace

Fields open_reference(const Problem& asked, double x, double t, const ReferenceParts& parts) {
  Problem problem = asked;
  parts.problem(problem);
  const WaveModes modes(problem.material);
  std::vector<Ray> rays = rays_until(problem, modes, x, t);
  parts.rays(rays);
  std::array<double, 4> sum{};
  // Ray by ray: each has its own age and so its own contour.
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const double tau = t - rays[r].arrival;
    if (tau <= 0.0) continue;
    for (const ContourNode& node : talbot(tau, parts.first_weight)) {
      WaveState state = wave_state(problem, modes, parts.modes(modes, node.s));
      parts.state(state);
      RaySum(problem, rays)
          .at(state, [&](std::size_t at, const FieldVector& wave, Complex exponent) {
            if (at != r) return;
            const Complex factor = problem.load.magnitude() / node.s * std::exp(exponent);
            for (std::size_t f = 0; f < 4; ++f) {
              sum[f] += (node.weight * factor * wave[f]).real();
            }
          });
    }
  }
  return {sum[0], sum[1], sum[2], sum[3]};
}

}  // namespace porowave::verification::faults
