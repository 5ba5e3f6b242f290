#include "verification/field_errors.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(field_errors)

using namespace porowave;
using namespace porowave::verification;

namespace {

const reference::Profile& papers_profile() {
  static const reference::Profile profile(
      reference::ColumnSolution(fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-5))),
      4e-5, 0.1);
  return profile;
}

/// What a perfect solver would hand over.
solver::Snapshot perfect_snapshot() {
  const reference::Profile& profile = papers_profile();
  solver::Snapshot s;
  s.time = profile.time();
  for (int i = 0; i < 40; ++i) {
    const double x = 0.1 * (i + 0.37) / 40;
    s.solid.x.push_back(x);
    s.solid.volume.push_back(0.1 / 40);
    s.solid.stress.push_back(profile.at(x).effective_stress);
    s.solid.velocity.push_back(profile.at(x).solid_velocity);
    s.fluid.x.push_back(x);
    s.fluid.volume.push_back(0.1 / 40);
    s.fluid.stress.push_back(profile.at(x).pore_pressure);
    s.fluid.velocity.push_back(profile.at(x).fluid_velocity);
  }
  for (int c = 0; c < 10; ++c) {
    s.cell_x.push_back(0.1 * (c + 0.5) / 10);
    s.effective_stress.push_back(profile.at(s.cell_x.back()).effective_stress);
    s.pore_pressure.push_back(profile.at(s.cell_x.back()).pore_pressure);
  }
  for (int i = 0; i <= 10; ++i) {
    s.node_x.push_back(0.1 * i / 10);
    s.solid_velocity.push_back(profile.at(s.node_x.back()).solid_velocity);
    s.fluid_velocity.push_back(profile.at(s.node_x.back()).fluid_velocity);
  }
  return s;
}

FieldErrors errors_of(const solver::Snapshot& snapshot) {
  return verification::field_errors(snapshot, reference_values(snapshot, papers_profile()));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_perfect_snapshot_has_no_error) {
  for (const FieldError& e : errors_of(perfect_snapshot())) {
    BOOST_TEST(e.points.l2 == 0.0);
    BOOST_TEST(e.field.linf == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(each_error_is_seen_in_its_own_field_and_place) {
  // A field that is ten per cent too large has a relative error of 0.1 in every norm.
  const auto spoil = [](std::vector<double>& values) {
    for (double& v : values) v *= 1.1;
  };
  for (std::size_t target = 0; target < 8; ++target) {
    solver::Snapshot s = perfect_snapshot();
    const std::array<std::vector<double>*, 8> places = {
        &s.solid.stress,     &s.fluid.stress,  &s.solid.velocity, &s.fluid.velocity,
        &s.effective_stress, &s.pore_pressure, &s.solid_velocity, &s.fluid_velocity};
    spoil(*places[target]);
    const FieldErrors errors = errors_of(s);
    for (std::size_t f = 0; f < 4; ++f) {
      const double at_points = target == f ? 0.1 : 0.0;
      const double of_field = target == f + 4 ? 0.1 : 0.0;
      BOOST_TEST(std::abs(errors[f].points.l1 - at_points) < 1e-14);
      BOOST_TEST(std::abs(errors[f].points.l2 - at_points) < 1e-14);
      BOOST_TEST(std::abs(errors[f].field.l2 - of_field) < 1e-14);
      BOOST_TEST(std::abs(errors[f].field.linf - of_field) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(fields_of_another_time_are_not_compared) {
  solver::Snapshot s = perfect_snapshot();
  s.time *= 1.01;
  BOOST_CHECK_THROW(reference_values(s, papers_profile()), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
