#include "verification/dispersion/dispersion.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/stability/step_operator.hpp"

namespace porowave::verification {

namespace {

using Complex = std::complex<double>;
using solver::CarriedFields;

constexpr int cells = 64;
// Frequencies below this share of the largest rate are rounding: such a wave does not travel.
constexpr double no_frequency = 1e-7;

/// Of a map of v_s, v_f, σ′, p. Scaled to √ρ v and σ/√E, which is all of one size: otherwise the
/// slow wave loses its digits.
Rates eigenvalues(const Eigen::Matrix4cd& map, const Material& material) {
  const Eigen::Vector4d scale(
      std::sqrt(material.solid_partial_density()), std::sqrt(material.fluid_partial_density()),
      1.0 / std::sqrt(material.constrained_modulus), 1.0 / std::sqrt(material.storage_modulus()));
  const Eigen::Matrix4cd scaled = scale.asDiagonal() * map * scale.cwiseInverse().asDiagonal();
  const Eigen::Vector4cd values =
      Eigen::ComplexEigenSolver<Eigen::Matrix4cd>(scaled, false).eigenvalues();
  return {values[0], values[1], values[2], values[3]};
}

void require_uniform(const solver::Case& scene) {
  const solver::Discretization& choice = scene.discretization;
  if (choice.placement == solver::Placement::uniform && choice.empty_elements.empty() &&
      scene.time.order == 2) {
    return;
  }
  throw std::invalid_argument(
      "dispersion: expected uniform points without empty elements and time_order = 2");
}

/// An endless column's stand-in, long enough that no step from its middle sees an end.
solver::Case middle_of_nowhere(solver::Case scene, double spacing) {
  scene.discretization.elements = cells;
  scene.problem.column.length = cells * spacing;
  scene.problem.column.far = FarEnd::rigid_sealed;
  return scene;
}

struct Line {
  const std::vector<double>& x;
  const std::vector<double>& values;
};

std::array<Line, 4> lines(const CarriedFields& fields) {
  return {{{fields.node_x, fields.solid_velocity},
           {fields.node_x, fields.fluid_velocity},
           {fields.cell_x, fields.effective_stress},
           {fields.cell_x, fields.pore_pressure}}};
}

/// The state of which one field holds one value, in the middle, and all else is zero.
std::vector<double> single_value(const solver::StepOperator& step, std::size_t field) {
  std::vector<double> state(step.size(), 0.0);
  for (double& component : state) {
    component = 1.0;
    const CarriedFields fields = step.fields(state);
    const Line line = lines(fields)[field];
    if (line.values[line.values.size() / 2] != 0.0) return state;
    component = 0.0;
  }
  throw std::invalid_argument("dispersion: no state holds a single value of a field");
}

}  // namespace

Rates exact_rates(const Material& material, double wave_number) {
  const double ns = material.solid_fraction(), nf = material.porosity;
  const double ms = material.solid_partial_density(), mf = material.fluid_partial_density();
  const double d = material.drag(), k = material.storage_modulus();
  const Complex ik(0.0, wave_number);
  Eigen::Matrix4cd a = Eigen::Matrix4cd::Zero();
  // n_s ρ_s v_s' = ∂(σ′ − n_s p) + d (v_f − v_s),  n_f ρ_f v_f' = −n_f ∂p − d (v_f − v_s)
  a.row(0) << -d / ms, d / ms, ik / ms, -ns * ik / ms;
  a.row(1) << d / mf, -d / mf, 0.0, -nf * ik / mf;
  // σ′' = E_oed ∂v_s,  p' = −K ∂(n_s v_s + n_f v_f)
  a.row(2) << material.constrained_modulus * ik, 0.0, 0.0, 0.0;
  a.row(3) << -k * ns * ik, -k * nf * ik, 0.0, 0.0;
  return eigenvalues(a, material);
}

SchemeDispersion::SchemeDispersion(const solver::Case& scene, double courant)
    : material_(scene.problem.material) {
  require_uniform(scene);
  spacing_ = scene.problem.column.length.value_or(1.0) / scene.discretization.elements;
  time_step_ = courant * spacing_ / wave_speeds(scene.problem.material).p1;
  const auto step = solver::step_operator(middle_of_nowhere(scene, spacing_));
  const solver::LinearMap map = step->at(time_step_);
  std::vector<double> after(map.size);
  for (std::size_t from = 0; from < 4; ++from) {
    const std::vector<double> before = single_value(*step, from);
    const CarriedFields start = step->fields(before);
    map.apply(before, after);
    const CarriedFields end = step->fields(after);
    const Line source = lines(start)[from];
    const std::size_t middle = source.values.size() / 2;
    for (std::size_t of = 0; of < 4; ++of) {
      const Line line = lines(end)[of];
      for (std::size_t j = 0; j < line.values.size(); ++j) {
        if (line.values[j] == 0.0) continue;
        responses_[of][from].push_back(
            {line.x[j] - source.x[middle], line.values[j] / source.values[middle]});
      }
    }
  }
}

Rates SchemeDispersion::rates(double wave_number) const {
  if (!(wave_number > 0.0 && wave_number * spacing_ < std::numbers::pi)) {
    throw std::invalid_argument("dispersion: expected a wave number in (0, pi/h)");
  }
  Eigen::Matrix4cd step = Eigen::Matrix4cd::Zero();
  for (int of = 0; of < 4; ++of) {
    for (int from = 0; from < 4; ++from) {
      for (const Response& r :
           responses_[static_cast<std::size_t>(of)][static_cast<std::size_t>(from)]) {
        // A wave e^(ikx) holds e^(−ik distance) where the value came from.
        step(of, from) += r.value * std::polar(1.0, -wave_number * r.distance);
      }
    }
  }
  Rates rates = eigenvalues(step, material_);
  for (Complex& rate : rates) rate = std::log(rate) / time_step_;
  return rates;
}

TravellingWaves travelling(const Rates& rates) {
  Rates sorted = rates;
  std::sort(sorted.begin(), sorted.end(),
            [](const Complex& a, const Complex& b) { return a.imag() > b.imag(); });
  double largest = 0.0;
  for (const Complex& rate : rates) largest = std::max(largest, std::abs(rate));
  TravellingWaves waves{sorted[0], std::nullopt};
  if (sorted[1].imag() > no_frequency * largest) waves.slow = sorted[1];
  return waves;
}

}  // namespace porowave::verification
