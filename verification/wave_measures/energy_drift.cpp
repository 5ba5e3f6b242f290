#include "verification/wave_measures/energy_drift.hpp"

#include <cmath>
#include <limits>

namespace porowave::verification {

namespace {

/// Factors of the squares of the four fields in the density of energy.
std::array<double, 4> factors(const Material& m) {
  return {0.5 / m.constrained_modulus, 0.5 / m.storage_modulus(), 0.5 * m.solid_partial_density(),
          0.5 * m.fluid_partial_density()};
}

double weighted_squares(std::span<const double> values, std::span<const double> weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += weights[i] * values[i] * values[i];
  return sum;
}

double point_energy(const Material& material, const std::array<std::span<const double>, 4>& fields,
                    const solver::Snapshot& s) {
  const auto factor = factors(material);
  double sum = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    sum += factor[f] * weighted_squares(fields[f], f % 2 == 0 ? s.solid.volume : s.fluid.volume);
  }
  return sum;
}

double drift(double energy, double reference) {
  if (!(reference > 0.0) || !std::isfinite(energy)) return std::numeric_limits<double>::quiet_NaN();
  return (energy - reference) / reference;
}

}  // namespace

double grid_energy(const Material& material, const GridFields& fields, double spacing) {
  const auto factor = factors(material);
  double sum = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    double squares = 0.0;
    for (const double v : fields[f]) squares += v * v;
    if (f >= 2) {
      squares -=
          0.5 * (fields[f].front() * fields[f].front() + fields[f].back() * fields[f].back());
    }
    sum += factor[f] * squares;
  }
  return sum * spacing;
}

EnergyDrift energy_drift(const Material& material, const solver::Snapshot& s,
                         const ReferenceValues& reference) {
  const auto& exact = reference.points;
  const double h = spacing(s);
  return {
      drift(point_energy(material,
                         {s.solid.stress, s.fluid.stress, s.solid.velocity, s.fluid.velocity}, s),
            point_energy(material, {exact[0], exact[1], exact[2], exact[3]}, s)),
      drift(grid_energy(material, grid_fields(s), h),
            grid_energy(material, grid_fields(reference), h))};
}

}  // namespace porowave::verification
