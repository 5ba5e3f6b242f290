#include "solver/stability/run_growth.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "solver/stability/automatic_step.hpp"

namespace porowave::solver {

namespace {

constexpr double modulus_rounding = 1e-6;  // of the modulus of eigenvalues

GrowthSettings all_eigenvalues(bool want_mode) {
  GrowthSettings settings;
  settings.largest_dense = 8 * most_analysed_elements;
  settings.want_mode = want_mode;
  return settings;
}

struct Peak {
  double energy = 0.0;
  double x = 0.0;

  void see(const std::vector<double>& places, const std::vector<double>& real,
           const std::vector<double>& imaginary, double stiffness) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double here = stiffness * std::norm(std::complex(real[k], imaginary[k]));
      if (here <= energy) continue;
      energy = here;
      x = places[k];
    }
  }
};

double place_of(const Growth& growth, const StepOperator& step, const Material& m) {
  std::vector<double> real, imaginary;
  for (const auto& value : growth.mode) {
    real.push_back(value.real());
    imaginary.push_back(value.imag());
  }
  const CarriedFields a = step.fields(real), b = step.fields(imaginary);
  Peak peak;
  peak.see(a.node_x, a.solid_velocity, b.solid_velocity, m.solid_partial_density());
  peak.see(a.node_x, a.fluid_velocity, b.fluid_velocity, m.fluid_partial_density());
  peak.see(a.cell_x, a.effective_stress, b.effective_stress, 1.0 / m.constrained_modulus);
  peak.see(a.cell_x, a.pore_pressure, b.pore_pressure, 1.0 / m.storage_modulus());
  return peak.x;
}

}  // namespace

RunGrowth::RunGrowth(const Case& scene, double end)
    : scene_(scene), end_(end), growth_(scene, all_eigenvalues(false)) {}

double RunGrowth::steps(double courant) const {
  return std::max(1.0, std::ceil(end_ / growth_.time_step(courant)));
}

double RunGrowth::at(double courant) {
  const double per_step = growth_.at(courant).per_step;
  if (std::abs(per_step - 1.0) <= modulus_rounding) return 1.0;
  return std::pow(per_step, steps(courant));
}

FastestMode RunGrowth::fastest(double courant) const {
  SceneGrowth with_mode(scene_, all_eigenvalues(true));
  const Growth found = with_mode.at(courant);
  return {found.per_step, place_of(found, with_mode.step(), scene_.problem.material)};
}

CriticalSettings run_scan() {
  CriticalSettings settings;
  settings.limit = tolerated_growth - 1.0;
  settings.spacing = 0.1;
  settings.lowest = 0.1;
  settings.tolerance = 0.02;
  settings.whole_scan = false;
  return settings;
}

}  // namespace porowave::solver
