#include "reference/problem/material.hpp"

#include <cmath>

#include "reference/problem/toml_document.hpp"

namespace porowave {

double Material::relaxation_rate() const {
  return drag() * (1.0 / solid_partial_density() + 1.0 / fluid_partial_density());
}

double Material::undrained_speed() const {
  return std::sqrt((constrained_modulus + storage_modulus()) / mixture_density());
}

WaveSpeeds wave_speeds(const Material& m) {
  // det(A - c^2 D) = 0 with A = [[E + K ns^2, K ns nf], [K ns nf, K nf^2]], D = diag(m1, m2);
  // the smaller root from the product of both, so that nothing cancels.
  const double ns = m.solid_fraction();
  const double nf = m.porosity;
  const double K = m.storage_modulus();
  const double E = m.constrained_modulus;
  const double a = (E + K * ns * ns) / m.solid_partial_density();
  const double b = K * nf * nf / m.fluid_partial_density();
  const double coupling =
      K * ns * K * nf * ns * nf / (m.solid_partial_density() * m.fluid_partial_density());
  const double fast = 0.5 * (a + b + std::hypot(a - b, 2.0 * std::sqrt(coupling)));
  const double product = E * K * nf * nf / (m.solid_partial_density() * m.fluid_partial_density());
  return {std::sqrt(fast), std::sqrt(product / fast)};
}

Material read_material(const TomlDocument& document) {
  auto section = document.section("material");
  const Range positive = Range::positive();
  Material m;
  m.porosity = section.number("porosity", Range::inside(0.0, 1.0));
  m.grain_density = section.number("grain_density", positive);
  m.fluid_density = section.number("fluid_density", positive);
  m.constrained_modulus = section.number("constrained_modulus", positive);
  m.fluid_bulk_modulus = section.number("fluid_bulk_modulus", positive);
  m.intrinsic_permeability = section.number("intrinsic_permeability", positive);
  m.fluid_viscosity = section.number("fluid_viscosity", positive);
  section.done();
  return m;
}

}  // namespace porowave
