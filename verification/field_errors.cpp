#include "verification/field_errors.hpp"

#include <cmath>
#include <stdexcept>
#include <tuple>

namespace porowave::verification {

namespace {

double pick(const Fields& f, std::size_t field) {
  return std::array{f.effective_stress, f.pore_pressure, f.solid_velocity, f.fluid_velocity}[field];
}

Norms compare(const std::vector<double>& x, const std::vector<double>& values,
              const std::vector<double>& weights, const reference::Profile& profile,
              std::size_t field) {
  std::vector<double> reference(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) reference[i] = pick(profile.at(x[i]), field);
  return relative_norms(values, reference, weights);
}

}  // namespace

FieldErrors field_errors(const solver::Snapshot& snapshot, const reference::Profile& profile) {
  if (std::abs(snapshot.time - profile.time()) > 1e-9 * profile.time()) {
    throw std::invalid_argument("field errors: solver and reference at different times");
  }
  const auto& [s, f] = std::tie(snapshot.solid, snapshot.fluid);
  const std::vector<double> cells(snapshot.cell_x.size(), 1.0);
  std::vector<double> nodes(snapshot.node_x.size(), 1.0);
  nodes.front() = nodes.back() = 0.5;
  FieldErrors errors;
  errors[0] = {compare(s.x, s.stress, s.volume, profile, 0),
               compare(snapshot.cell_x, snapshot.effective_stress, cells, profile, 0)};
  errors[1] = {compare(f.x, f.stress, f.volume, profile, 1),
               compare(snapshot.cell_x, snapshot.pore_pressure, cells, profile, 1)};
  errors[2] = {compare(s.x, s.velocity, s.volume, profile, 2),
               compare(snapshot.node_x, snapshot.solid_velocity, nodes, profile, 2)};
  errors[3] = {compare(f.x, f.velocity, f.volume, profile, 3),
               compare(snapshot.node_x, snapshot.fluid_velocity, nodes, profile, 3)};
  return errors;
}

}  // namespace porowave::verification
