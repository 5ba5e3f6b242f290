#include "verification/cluster/machine_speed.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "verification/cost/cost_model.hpp"
#include "verification/process/scratch_directory.hpp"
#include "verification/store/store.hpp"

BOOST_AUTO_TEST_SUITE(machine_speed)

using namespace porowave;
using namespace porowave::verification;

namespace {

Study study_of(const std::string& elements, int seeds) {
  return read_study(TomlDocument::parse(
      "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
      "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\nintrinsic_permeability = 1.0e-11\n"
      "fluid_viscosity = 1.0e-3\n"
      "[column]\nlength = 0.1\nnear = \"drained_traction\"\nfar = \"rigid_sealed\"\n"
      "[load]\nshape = \"smooth_ramp\"\nmagnitude = 1.0\nduration = 1e-5\n"
      "[discretization]\nplacement = \"stratified\"\n[time]\nend = 2.0e-5\n"
      "[study]\nname = \"trial\"\n[axes]\n\"discretization.elements\" = " +
          elements + "\n\"discretization.seed\" = { first = 1, count = " + std::to_string(seeds) +
          " }\n",
      "study.toml"));
}

/// Rows as of a machine on which the solver takes `factor` times what is predicted.
std::vector<Record> rows_at(const Study& study, double factor) {
  std::vector<Record> rows;
  for (const StudyCase& one : study.cases) {
    Record row;
    row.id = one.id;
    row.finished = "2026-11-22T18:00:00Z";
    row.measures.assign(measure_names().size(), 0.0);
    row.cpu_seconds = factor * predicted_solver_seconds(one.scene);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_CASE(rows_tell_how_much_slower_their_machine_is) {
  const ScratchDirectory directory;
  const Study study = study_of("[1600, 3200]", 40);
  const CaseList all = verification::case_list(study);
  const std::vector<std::string> stores = {directory.file("none"), directory.file("s"),
                                           directory.file("1")};
  BOOST_TEST(!speed_of_rows(study, all, stores).has_value());
  auto rows = rows_at(study, 2.5);
  rows[0].status = CaseStatus::failed;  // will be run again
  rows[0].cpu_seconds = 1000.0;
  rows[1].status = CaseStatus::broke_down;
  rows[1].cpu_seconds *= 3.0;
  Store::create_or_open(directory.file("s")).add({rows.begin(), rows.begin() + 10});
  Store::create_or_open(directory.file("1")).add({rows.begin() + 10, rows.end()});
  const auto speed = speed_of_rows(study, all, stores);
  BOOST_REQUIRE(speed.has_value());
  double measured = 0.0;
  double predicted = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    measured += rows[i].cpu_seconds;
    predicted += predicted_solver_seconds(study.cases[i].scene);
  }
  BOOST_TEST(measured > 2.5 * predicted * 1.01);
  BOOST_TEST(speed->factor == measured / predicted, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(speed->cases == study.cases.size() - 1);
  BOOST_TEST(speed->stored);
}

BOOST_AUTO_TEST_CASE(too_little_work_in_the_rows_is_no_measurement) {
  const ScratchDirectory directory;
  const Study study = study_of("[20]", 3);
  Store::create_or_open(directory.file("s")).add(rows_at(study, 2.0));
  BOOST_TEST(
      !speed_of_rows(study, verification::case_list(study), {directory.file("s")}).has_value());
}

BOOST_AUTO_TEST_CASE(steps_of_equal_sums_take_cases_as_often_as_they_are_long) {
  // Works 1 and 3 in turn: of 40 steps over 40 pairs, 30 fall into the long ones.
  std::vector<double> works;
  for (int i = 0; i < 40; ++i) works.insert(works.end(), {1.0, 3.0});
  const auto taken = equal_steps(works, 160);
  BOOST_TEST(taken.size() == 160U);
  const auto is_long = [](std::size_t i) { return i % 2 == 1; };
  BOOST_TEST(std::count_if(taken.begin(), taken.end(), is_long) == 120);
  // The mean of ratios over them is then that of all, whatever the ratios of the two kinds are.
  double mean = 0.0;
  for (const std::size_t i : taken) mean += (is_long(i) ? 1.5 : 0.5) / 160.0;
  BOOST_TEST(mean == (40 * 1.0 * 0.5 + 40 * 3.0 * 1.5) / 160.0,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(equal_steps({}, 3).empty());
  BOOST_TEST(equal_steps({1.0, 3.0}, 1) == (std::vector<std::size_t>{1}),  // the middle
             boost::test_tools::per_element());
  BOOST_TEST(equal_steps({2.0}, 2) == (std::vector<std::size_t>{0, 0}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_trial_leaves_out_what_is_too_long_for_it) {
  const Study study = study_of("[20, 40]", 4);
  const CaseList all = verification::case_list(study);
  const MachineSpeed speed = speed_of_trial(study, all, 0.05);
  BOOST_TEST(speed.cases >= 1U);
  BOOST_TEST(speed.cases <= all.entries.size());
  BOOST_TEST(speed.factor > 0.0);
  BOOST_TEST(!speed.stored);
  CaseList longer = all;
  for (CaseList::Entry& entry : longer.entries) entry.seconds = 1.0F;
  const MachineSpeed none = speed_of_trial(study, longer, 0.05);
  BOOST_TEST(none.cases == 0U);
  BOOST_TEST(none.factor == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
