#include "reference/energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "reference/adaptive_integral.hpp"
#include "reference/profile.hpp"
#include "reference/smooth_pieces.hpp"

namespace porowave::reference {

namespace {

/// With more pieces of time the work is not integrated.
constexpr std::size_t most_pieces = 4000;

/// Power of the tractions on both phases at the loaded end, W/m^2.
Bounded power(const ColumnSolution& solution, double t) {
  const BoundedFields fields = solution.at(0.0, t);
  const Fields& f = fields.value;
  const Fields& e = fields.error;
  const double nf = solution.problem().material.porosity;
  const double ns = 1.0 - nf;
  const double on_solid = ns * f.pore_pressure - f.effective_stress;
  const double on_fluid = nf * f.pore_pressure;
  return {on_solid * f.solid_velocity + on_fluid * f.fluid_velocity,
          std::abs(on_solid) * e.solid_velocity + std::abs(on_fluid) * e.fluid_velocity +
              (ns * e.pore_pressure + e.effective_stress) * std::abs(f.solid_velocity) +
              nf * e.pore_pressure * std::abs(f.fluid_velocity)};
}

/// An energy 1/2 int (weights . fields^2) dx whose fields are wrong by up to `error`; `weight` is
/// the sum of the weights times the length (Cauchy and Schwarz).
Bounded with_error(double energy, double weight, double error) {
  constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
  if (!std::isfinite(energy)) return {energy, std::numeric_limits<double>::infinity()};
  return {energy, (std::sqrt(2.0 * std::abs(energy) * weight) + 0.5 * weight * error) * error +
                      rounding * std::abs(energy)};
}

void add_energies(const ColumnSolution& solution, EnergyBalance& balance) {
  const Problem& problem = solution.problem();
  const Material& m = problem.material;
  const double end = problem.column.length.value_or(solution.modes().speed(0) * balance.t);
  const Profile profile(solution, balance.t, end);
  const double kinetic = 0.5 * profile.integral([&](const Fields& f) {
    return m.solid_partial_density() * f.solid_velocity * f.solid_velocity +
           m.fluid_partial_density() * f.fluid_velocity * f.fluid_velocity;
  });
  const double elastic = 0.5 * profile.integral([&](const Fields& f) {
    return f.effective_stress * f.effective_stress / m.constrained_modulus +
           f.pore_pressure * f.pore_pressure / m.storage_modulus();
  });
  balance.kinetic =
      with_error(kinetic, m.mixture_density() * end, profile.error() * problem.velocity_scale());
  balance.elastic =
      with_error(elastic, (1.0 / m.constrained_modulus + 1.0 / m.storage_modulus()) * end,
                 profile.error() * problem.stress_scale());
}

/// Work between two times; `breaks` as given by smooth_times.
Bounded work_between(const ColumnSolution& solution, const std::vector<double>& breaks, double from,
                     double to) {
  std::vector<double> ends = {from};
  for (const double t : breaks) {
    if (t > from && t < to) ends.push_back(t);
  }
  ends.push_back(to);
  if (ends.size() > most_pieces) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  }
  return adaptive_integral([&](double t) { return power(solution, t); }, ends);
}

}  // namespace

EnergyBalance energy_balance(const ColumnSolution& solution, double t) {
  return energy_balances(solution, std::span(&t, 1)).front();
}

std::vector<EnergyBalance> energy_balances(const ColumnSolution& solution,
                                           std::span<const double> times) {
  std::vector<EnergyBalance> balances(times.size());
  if (times.empty()) return balances;
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  std::vector<double> breaks;
  Bounded work;
  double before = 0.0;
  for (const std::size_t i : order) {
    EnergyBalance& balance = balances[i];
    balance.t = times[i];
    balance.settlement = settlement(solution, balance.t);
    if (balance.t <= 0.0) continue;
    if (breaks.empty()) breaks = smooth_times(solution, times[order.back()]);
    const Bounded added = work_between(solution, breaks, before, balance.t);
    work = {work.value + added.value, work.error + added.error};
    before = balance.t;
    balance.work = work;
    add_energies(solution, balance);
    balance.dissipated = {balance.work.value - balance.kinetic.value - balance.elastic.value,
                          balance.work.error + balance.kinetic.error + balance.elastic.error};
  }
  return balances;
}

}  // namespace porowave::reference
