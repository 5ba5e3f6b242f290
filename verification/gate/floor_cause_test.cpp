#include "verification/gate/floor_cause.hpp"

#include <boost/test/unit_test.hpp>

#include "verification/gate/gate_fixtures.hpp"
#include "verification/sweep/sweep.hpp"

BOOST_AUTO_TEST_SUITE(floor_cause)

using namespace porowave;
using namespace porowave::verification;

namespace {

/// A small study refined by one key, with the rest as given.
Study study_by(const std::string& axis, const std::string& values,
               const std::string& discretization) {
  return read_study(TomlDocument::parse(
      "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
      "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\n"
      "intrinsic_permeability = 1.0e-11\nfluid_viscosity = 1.0e-3\n"
      "[column]\nlength = 0.1\nnear = \"drained_traction\"\nfar = \"rigid_sealed\"\n"
      "[load]\nshape = \"sin4_pulse\"\nmagnitude = 1.0\nduration = 2.0e-5\n"
      "[discretization]\n" +
          discretization + "\n[time]\nend = 4.0e-5\n[study]\nname = \"trial\"\n[axes]\n\"" + axis +
          "\" = " + values + "\n[refine]\nby = \"" + axis + "\"\n",
      "trial.toml"));
}

Verdict verdict_of(const Study& study, const RunFunction& run = run_case) {
  const ScratchDirectory directory;
  Store store = Store::create_or_open(directory.file("results"));
  SweepOptions options;
  options.run = run;
  sweep(study, store, options);
  GateRules rules;
  rules.measures = {*measure_index("effective_stress_field_l2")};
  rules.order = 2.0;
  CaseRunner runner(study.name, "", {}, run);
  return judge(groups_of(study, store), rules, std::nullopt, [&](const auto& group, auto measure) {
    return cause_of_floor(study, group, measure, runner);
  })[0];
}

void check_cause(const Verdict& verdict, const std::string& cause,
                 VerdictKind kind = VerdictKind::inconclusive) {
  BOOST_TEST(to_string(verdict.kind) == to_string(kind));
  BOOST_TEST(verdict.reason.find("made by " + cause) != std::string::npos, verdict.reason);
}

}  // namespace

BOOST_AUTO_TEST_CASE(shorter_steps_do_not_help_where_elements_are_long) {
  check_cause(verdict_of(study_by("time.courant", "[0.4, 0.2, 0.1, 0.05]", "elements = 60")),
              "the elements", VerdictKind::fail);
}

BOOST_AUTO_TEST_CASE(more_points_do_not_help_either) {
  check_cause(
      verdict_of(study_by("discretization.points_per_element", "[2, 4, 8, 16]", "elements = 60")),
      "the elements", VerdictKind::fail);
}

/// What a solver with a part of the error of a known size would give.
RunFunction with_error(const std::function<double(const solver::Case&)>& error) {
  return [error](const solver::Case& scene, const reference::Profile& profile) {
    RunResult result;
    result.steps = 1;
    result.reference_error = profile.error();
    for (FieldError& field : result.errors) {
      field.field.l2 = 0.1 * std::pow(10.0 / scene.discretization.elements, 2) + error(scene);
    }
    return result;
  };
}

BOOST_AUTO_TEST_CASE(a_part_of_the_error_of_known_origin_is_found) {
  const Study study = study_by("discretization.elements", "[20, 40, 80, 160]", "");
  check_cause(verdict_of(study, with_error([](const auto& s) { return 0.02 * s.time.courant; })),
              "the time step: half the time step changes it by -4");
  check_cause(verdict_of(study, with_error([](const auto& s) {
                           return 0.04 / s.discretization.points_per_element;
                         })),
              "the points in a cell");
  check_cause(verdict_of(study, with_error([](const auto&) { return 0.01; })),
              "something that none of these changes");
}

BOOST_AUTO_TEST_CASE(strains_that_are_not_small_are_named) {
  const Study study = study_by("discretization.elements", "[20, 40, 80, 160]", "");
  const auto strained = [](const solver::Case& scene, const reference::Profile& profile) {
    RunResult result = with_error([](const auto&) { return 0.01; })(scene, profile);
    result.largest_strain = 2e-3;
    return result;
  };
  check_cause(verdict_of(study, strained), "strains reach 0.002");
}

BOOST_AUTO_TEST_SUITE_END()
