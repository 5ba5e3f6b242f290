#include "verification/run.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "solver/stability/automatic_step.hpp"
#include "verification/run_output.hpp"

BOOST_AUTO_TEST_SUITE(run)

using namespace porowave;
using namespace porowave::verification;
using solver::Case;

namespace {

Case small_case() {
  Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
  scene.discretization.elements = 50;
  scene.time.end = 4e-5;
  return scene;
}

Case exploding_case() {
  Case scene = small_case();
  scene.discretization.transfer = solver::TransferName::shape;
  scene.discretization.kernel = solver::kernel_name<solver::BSpline1>;
  scene.discretization.support_radius = 1.0;
  scene.discretization.basis_order = 0;
  scene.discretization.placement = solver::Placement::stratified;
  scene.time.courant = 1.0;
  scene.time.end = 1e-4;
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_has_errors_and_a_cost) {
  const Case scene = small_case();
  const RunResult result = run_case(scene, *reference_profile(scene));
  BOOST_TEST(!result.breakdown);
  BOOST_TEST(result.points == 400u);
  BOOST_TEST(result.snapshot.time == 4e-5);
  BOOST_TEST(result.errors[0].field.l2 > 1e-4);
  BOOST_TEST(result.errors[0].field.l2 < 0.1);
  BOOST_TEST(result.cost.cpu_seconds > 0.0);
  BOOST_TEST(result.cost.peak_rss_bytes > 1000000);
  BOOST_TEST(result.reference_error < 1e-12);
}

BOOST_AUTO_TEST_CASE(json_holds_every_norm_of_every_field) {
  const Case scene = small_case();
  const RunResult result = run_case(scene, *reference_profile(scene));
  const auto json = nlohmann::json::parse(run_json(result));
  for (std::size_t f = 0; f < 4; ++f) {
    const auto& field = json.at("errors").at(std::string(field_names[f]));
    BOOST_TEST(field.at("points").at("l1").get<double>() == result.errors[f].points.l1);
    BOOST_TEST(field.at("points").at("l2").get<double>() == result.errors[f].points.l2);
    BOOST_TEST(field.at("field").at("l2").get<double>() == result.errors[f].field.l2);
    BOOST_TEST(field.at("field").at("linf").get<double>() == result.errors[f].field.linf);
  }
  BOOST_TEST(json.at("path") == "frozen");
  BOOST_TEST(json.at("frozen_steps").get<long>() == result.steps);
  BOOST_TEST(json.at("steps").get<long>() == result.steps);
  // The step is shortened so that the run ends at time.end, by less than one step in all.
  const double courant = json.at("courant").get<double>();
  BOOST_TEST(courant <= scene.time.courant * (1.0 + 1e-12));
  BOOST_TEST(courant > scene.time.courant * (1.0 - 1.0 / static_cast<double>(result.steps)));
  BOOST_TEST(json.at("diverged") == false);
  for (const char* key : {"wall_seconds", "cpu_seconds", "ns_per_point_step", "peak_rss_bytes"}) {
    BOOST_TEST(json.at(key).is_number());
  }
}

BOOST_AUTO_TEST_CASE(json_holds_what_a_run_does_to_waves) {
  Case scene = small_case();
  const auto profile = reference_profile(scene);
  const auto measures_of = [&](const RunResult& result) {
    return nlohmann::json::parse(run_json(result)).at("measures");
  };
  RunResult result = run_case(scene, *profile);
  auto json = measures_of(result);
  BOOST_TEST(json.at("arrival_delay").at("fast").get<double>() == result.measures.arrival_delay[0]);
  BOOST_TEST(json.at("arrival_delay").at("slow").get<double>() == result.measures.arrival_delay[1]);
  for (std::size_t f = 0; f < 4; ++f) {
    const auto& field = json.at(std::string(field_names[f]));
    BOOST_TEST(field.at("overshoot").get<double>() == result.measures.overshoot[f].excess);
    BOOST_TEST(field.at("total_variation").get<double>() ==
               result.measures.overshoot[f].total_variation);
    BOOST_TEST(field.at("ringing").get<double>() == result.measures.ringing[f].amplitude);
    BOOST_TEST(field.at("ringing_share").get<double>() == result.measures.ringing[f].share);
  }
  BOOST_TEST(json.at("energy_drift").at("points").get<double>() == result.measures.energy.points);
  BOOST_TEST(json.at("energy_drift").at("field").get<double>() == result.measures.energy.field);
  BOOST_TEST(json.at("gap").at("reflected").is_null());
  BOOST_TEST(json.at("gap").at("transmitted").is_null());

  scene.discretization.empty_elements = {0.05};
  result = run_case(scene, *profile);
  json = measures_of(result);
  BOOST_TEST(json.at("gap").at("reflected").get<double>() == result.measures.gap.reflected);
  BOOST_TEST(json.at("gap").at("transmitted").get<double>() == result.measures.gap.transmitted);
}

BOOST_AUTO_TEST_CASE(json_says_which_path_ran) {
  Case scene = small_case();
  scene.time.path = solver::StepPath::points;
  const RunResult result = run_case(scene, *reference_profile(scene));
  const auto json = nlohmann::json::parse(run_json(result));
  BOOST_TEST(json.at("path") == "points");
  BOOST_TEST(json.at("frozen_steps") == 0);
}

BOOST_AUTO_TEST_CASE(json_says_how_the_step_was_chosen) {
  Case scene = small_case();
  const auto profile = reference_profile(scene);
  const auto chosen_in = [&] {
    return nlohmann::json::parse(run_json(run_case(scene, *profile))).at("automatic_courant");
  };
  BOOST_TEST(chosen_in().is_null());
  scene.time.automatic = solver::automatic_step(scene);
  scene.time.courant = scene.time.automatic->courant;
  const auto of_window = chosen_in();
  BOOST_TEST(of_window.at("rule") == "window");
  BOOST_TEST(of_window.at("elements_analysed") == 48);
  BOOST_TEST(of_window.at("courant").get<double>() == scene.time.courant);
  BOOST_TEST(of_window.at("critical_courant").get<double>() > scene.time.courant);
  BOOST_TEST(run_summary(run_case(scene, *profile)).find("critical step of 48 of its elements") !=
             std::string::npos);
  scene.time.automatic = solver::AutomaticStep{solver::StepRule::formula, 0.5, 0.0, NAN, 0};
  BOOST_TEST(chosen_in().at("rule") == "formula");
  BOOST_TEST(chosen_in().at("critical_courant").is_null());
  BOOST_TEST(chosen_in().at("noise_growth").is_null());
}

BOOST_AUTO_TEST_CASE(json_says_that_staggered4_visits_no_points) {
  Case scene = small_case();
  scene.discretization.scheme = solver::Scheme::staggered4;
  scene.discretization.kernel = solver::kernel_name<solver::WendlandC2>;
  scene.discretization.basis_order = 2;
  scene.discretization.support_radius = 2.0;
  const RunResult result = run_case(scene, *reference_profile(scene));
  const auto json = nlohmann::json::parse(run_json(result));
  BOOST_TEST(json.at("path") == "frozen");
  BOOST_TEST(json.at("frozen_steps").get<long>() == result.steps);
}

BOOST_AUTO_TEST_CASE(an_explosion_is_reported_with_step_and_quantity) {
  const Case scene = exploding_case();
  const RunResult result = run_case(scene, *reference_profile(scene));
  BOOST_REQUIRE(result.breakdown);
  BOOST_TEST(result.breakdown->reason.find("step ") == 0u);
  BOOST_TEST(result.breakdown->reason.find(" m, solid point ") != std::string::npos);
  BOOST_TEST(result.breakdown->reason.find(" at x = ") != std::string::npos);
  BOOST_TEST(result.steps < result.breakdown->step + 1);
  const auto json = nlohmann::json::parse(run_json(result));
  BOOST_TEST(json.at("diverged") == true);
  BOOST_TEST(json.at("errors").is_null());
  BOOST_TEST(json.at("measures").is_null());
  BOOST_TEST(json.at("reason") == result.breakdown->reason);
}

BOOST_AUTO_TEST_CASE(points_are_written_with_all_their_digits) {
  const Case scene = small_case();
  const RunResult result = run_case(scene, *reference_profile(scene));
  std::ostringstream out;
  write_points_csv(result.snapshot, out);
  std::istringstream lines(out.str());
  std::string line;
  std::getline(lines, line);
  BOOST_TEST(line == "phase,x,volume,velocity,effective_stress,pore_pressure");
  std::getline(lines, line);
  BOOST_TEST(line.rfind("solid,", 0) == 0u);
  BOOST_TEST(line.back() == ',');
  const double x = std::stod(line.substr(6));
  BOOST_TEST(x == result.snapshot.solid.x[0]);
  std::size_t rows = 1;
  while (std::getline(lines, line)) ++rows;
  BOOST_TEST(rows == result.points);
}

BOOST_AUTO_TEST_CASE(strains_that_are_not_small_are_said) {
  Case scene = small_case();
  const RunResult small = run_case(scene, *reference_profile(scene));
  BOOST_TEST(run_summary(small).find("strains reach") == std::string::npos);
  scene.problem.load = Load(LoadShape::smooth_ramp, 1e6, 1e-5);
  const RunResult large = run_case(scene, *reference_profile(scene));
  BOOST_TEST(large.largest_strain == 1e6 * small.largest_strain,
             boost::test_tools::tolerance(0.01));
  BOOST_TEST(run_summary(large).find("strains reach 2") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(without_a_reference_there_is_no_error) {
  Case scene = small_case();
  // Modes convert at both ends, and there are more images than the reference follows.
  scene.problem.column.near = NearEnd::sealed_traction;
  scene.problem.column.far = FarEnd::rigid_drained;
  scene.time.end = 1.0;
  BOOST_CHECK_THROW(reference_profile(scene), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
