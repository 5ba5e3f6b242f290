#include "verification/field_errors.hpp"

#include <cmath>
#include <stdexcept>
#include <tuple>

namespace porowave::verification {

namespace {

double pick(const Fields& f, std::size_t field) {
  return std::array{f.effective_stress, f.pore_pressure, f.solid_velocity, f.fluid_velocity}[field];
}

}  // namespace

Norms compare_at(const reference::Profile& profile, std::size_t field, const std::vector<double>& x,
                 const std::vector<double>& values, const std::vector<double>& weights) {
  std::vector<double> reference(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) reference[i] = pick(profile.at(x[i]), field);
  return relative_norms(values, reference, weights);
}

FieldErrors field_errors(const solver::Snapshot& snapshot, const reference::Profile& profile) {
  if (std::abs(snapshot.time - profile.time()) > 1e-9 * profile.time()) {
    throw std::invalid_argument("field errors: solver and reference at different times");
  }
  const auto& [s, f] = std::tie(snapshot.solid, snapshot.fluid);
  const std::vector<double> cells(snapshot.cell_x.size(), 1.0);
  std::vector<double> nodes(snapshot.node_x.size(), 1.0);
  nodes.front() = nodes.back() = 0.5;
  FieldErrors errors;
  errors[0] = {compare_at(profile, 0, s.x, s.stress, s.volume),
               compare_at(profile, 0, snapshot.cell_x, snapshot.effective_stress, cells)};
  errors[1] = {compare_at(profile, 1, f.x, f.stress, f.volume),
               compare_at(profile, 1, snapshot.cell_x, snapshot.pore_pressure, cells)};
  errors[2] = {compare_at(profile, 2, s.x, s.velocity, s.volume),
               compare_at(profile, 2, snapshot.node_x, snapshot.solid_velocity, nodes)};
  errors[3] = {compare_at(profile, 3, f.x, f.velocity, f.volume),
               compare_at(profile, 3, snapshot.node_x, snapshot.fluid_velocity, nodes)};
  return errors;
}

}  // namespace porowave::verification
