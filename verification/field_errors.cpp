#include "verification/field_errors.hpp"

#include <cmath>
#include <stdexcept>
#include <tuple>

namespace porowave::verification {

namespace {

double pick(const Fields& f, std::size_t field) {
  return std::array{f.effective_stress, f.pore_pressure, f.solid_velocity, f.fluid_velocity}[field];
}

/// Two fields (indices in field_names) at the same places: the profile gives all four at once.
void evaluate(const reference::Profile& profile, const std::vector<double>& x, std::size_t one,
              std::size_t other, std::array<std::vector<double>, 4>& values) {
  values[one].resize(x.size());
  values[other].resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Fields fields = profile.at(x[i]);
    values[one][i] = pick(fields, one);
    values[other][i] = pick(fields, other);
  }
}

}  // namespace

ReferenceValues reference_values(const solver::Snapshot& snapshot,
                                 const reference::Profile& profile) {
  if (std::abs(snapshot.time - profile.time()) > 1e-9 * profile.time()) {
    throw std::invalid_argument("field errors: solver and reference at different times");
  }
  ReferenceValues values;
  evaluate(profile, snapshot.solid.x, 0, 2, values.points);
  evaluate(profile, snapshot.fluid.x, 1, 3, values.points);
  evaluate(profile, snapshot.cell_x, 0, 1, values.field);
  evaluate(profile, snapshot.node_x, 2, 3, values.field);
  return values;
}

Norms compare_at(const reference::Profile& profile, std::size_t field, const std::vector<double>& x,
                 const std::vector<double>& values, const std::vector<double>& weights) {
  std::vector<double> reference(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) reference[i] = pick(profile.at(x[i]), field);
  return relative_norms(values, reference, weights);
}

FieldErrors field_errors(const solver::Snapshot& snapshot, const ReferenceValues& reference) {
  const auto& [s, f] = std::tie(snapshot.solid, snapshot.fluid);
  const std::vector<double> cells(snapshot.cell_x.size(), 1.0);
  std::vector<double> nodes(snapshot.node_x.size(), 1.0);
  nodes.front() = nodes.back() = 0.5;
  FieldErrors errors;
  errors[0].points = relative_norms(s.stress, reference.points[0], s.volume);
  errors[1].points = relative_norms(f.stress, reference.points[1], f.volume);
  errors[2].points = relative_norms(s.velocity, reference.points[2], s.volume);
  errors[3].points = relative_norms(f.velocity, reference.points[3], f.volume);
  errors[0].field = relative_norms(snapshot.effective_stress, reference.field[0], cells);
  errors[1].field = relative_norms(snapshot.pore_pressure, reference.field[1], cells);
  errors[2].field = relative_norms(snapshot.solid_velocity, reference.field[2], nodes);
  errors[3].field = relative_norms(snapshot.fluid_velocity, reference.field[3], nodes);
  return errors;
}

}  // namespace porowave::verification
