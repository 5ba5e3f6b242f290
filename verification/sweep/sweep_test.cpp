#include "verification/sweep/sweep.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <thread>

#include "reference/problem/errors.hpp"
#include "verification/cost/cost_model.hpp"
#include "verification/process/scratch_directory.hpp"
#include "verification/sweep/repeat.hpp"

BOOST_AUTO_TEST_SUITE(sweep)

using namespace porowave;
using namespace porowave::verification;

namespace {

Study small_study(const std::string& axes) {
  return read_study(TomlDocument::parse(
      "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
      "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\nintrinsic_permeability = 1.0e-11\n"
      "fluid_viscosity = 1.0e-3\n"
      "[column]\nlength = 0.1\nnear = \"drained_traction\"\nfar = \"rigid_sealed\"\n"
      "[load]\nshape = \"smooth_ramp\"\nmagnitude = 1.0\nduration = 1e-5\n"
      "[discretization]\nelements = 10\nkernel = \"bspline2\"\nplacement = \"stratified\"\n"
      "[time]\nend = 2.0e-5\n[study]\nname = \"trial\"\n[axes]\n" +
          axes,
      "study.toml"));
}

const std::string twelve =
    "\"discretization.elements\" = [10, 20]\n"
    "\"discretization.seed\" = { first = 1, count = 6 }\n";

/// What must be equal in every repetition, row for row.
bool same_rows(const std::vector<Record>& a, const std::vector<Record>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].id != b[i].id || a[i].status != b[i].status || a[i].steps != b[i].steps) return false;
    for (std::size_t m = 0; m < a[i].measures.size(); ++m) {
      const bool equal = a[i].measures[m] == b[i].measures[m];
      if (!equal && !(std::isnan(a[i].measures[m]) && std::isnan(b[i].measures[m]))) return false;
    }
  }
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_case_becomes_a_row_and_a_second_sweep_has_nothing_to_do) {
  const ScratchDirectory directory;
  const Study study = small_study(twelve);
  Store store = Store::create_or_open(directory.file("results"));
  const SweepSummary first = porowave::verification::sweep(study, store, {.jobs = 2});
  BOOST_TEST(first.by_status[0] == 12U);
  BOOST_TEST(first.reused == 0U);
  BOOST_TEST(!first.stopped);
  std::set<double> errors;
  for (const Record& row : store.all()) {
    const double error = row.measures[*measure_index("effective_stress_field_l2")];
    BOOST_TEST(error > 1e-3);
    BOOST_TEST(error < 0.5);
    errors.insert(error);
  }
  BOOST_TEST(errors.size() == 12U);
  const SweepSummary second = porowave::verification::sweep(study, store, {.jobs = 2});
  BOOST_TEST(second.reused == 12U);
  BOOST_TEST(second.by_status[0] == 0U);
}

BOOST_AUTO_TEST_CASE(rows_do_not_depend_on_the_number_of_threads_or_shards) {
  const ScratchDirectory directory;
  const Study study = small_study(twelve);
  Store one = Store::create_or_open(directory.file("one"));
  Store many = Store::create_or_open(directory.file("many"));
  Store merged = Store::create_or_open(directory.file("merged"));
  porowave::verification::sweep(study, one, {.jobs = 1});
  porowave::verification::sweep(study, many, {.jobs = 5});
  BOOST_TEST(same_rows(one.all(), many.all()));
  for (int i = 1; i <= 3; ++i) {
    const std::string path = directory.file("shard" + std::to_string(i));
    Store shard = Store::create_or_open(path);
    SweepOptions options;
    options.jobs = 1;
    options.shard = Shard{i, 3};
    BOOST_TEST(porowave::verification::sweep(study, shard, options).cases == 4U);
    merged.merge(path);
  }
  BOOST_TEST(same_rows(one.all(), merged.all()));
}

BOOST_AUTO_TEST_CASE(shards_are_balanced_by_predicted_work_and_leave_out_nothing) {
  const Study study = small_study(
      "\"discretization.elements\" = [10, 13, 17, 25, 34, 50, 70, 100, 130, 170, 230, 300, 400]\n");
  std::set<std::string> only;
  for (std::size_t i = 0; i < study.cases.size(); i += 2) only.insert(study.cases[i].id);
  for (const auto& ids : {std::optional<std::set<std::string>>(), std::optional(only)}) {
    std::multiset<std::string> seen;
    std::vector<double> work;      // of a shard
    std::vector<double> shortest;  // case in it
    for (int i = 1; i <= 3; ++i) {
      work.push_back(0.0);
      shortest.push_back(std::numeric_limits<double>::infinity());
      for (const auto* one : cases_of(study, Shard{i, 3}, ids)) {
        seen.insert(one->id);
        work.back() += predicted_seconds(one->scene);
        shortest.back() = std::min(shortest.back(), predicted_seconds(one->scene));
      }
    }
    // When a shard got its last case, its shortest, no other had less.
    const double least = *std::min_element(work.begin(), work.end());
    for (std::size_t i = 0; i < 3; ++i) BOOST_TEST(work[i] - shortest[i] <= least * (1.0 + 1e-12));
    BOOST_TEST(seen.size() == (ids ? only.size() : study.cases.size()));
    for (const auto& one : study.cases) {
      BOOST_TEST(seen.count(one.id) == (!ids || ids->contains(one.id) ? 1U : 0U));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_stopped_sweep_keeps_what_it_has_and_continues) {
  const ScratchDirectory directory;
  const Study study = small_study(twelve);
  Store store = Store::create_or_open(directory.file("results"));
  std::atomic<bool> stop = true;
  SweepOptions options;
  options.jobs = 2;
  options.stop = &stop;
  BOOST_TEST(porowave::verification::sweep(study, store, options).stopped);
  BOOST_TEST(store.all().empty());
  stop = false;
  options.progress = [&](std::size_t done, std::size_t) { stop = done > 0; };
  const auto part = porowave::verification::sweep(study, store, options);
  BOOST_TEST(store.all().size() == part.by_status[0]);
  options.stop = nullptr;
  const auto rest = porowave::verification::sweep(study, store, options);
  BOOST_TEST(rest.reused == part.by_status[0]);
  BOOST_TEST(store.all().size() == 12U);
}

BOOST_AUTO_TEST_CASE(two_sweeps_at_once_fill_one_store) {
  const ScratchDirectory directory;
  const Study study = small_study(twelve);
  Store first = Store::create_or_open(directory.file("results"));
  Store second = Store::create_or_open(directory.file("results"));
  Store alone = Store::create_or_open(directory.file("alone"));
  {
    const std::jthread other([&] { porowave::verification::sweep(study, second, {.jobs = 1}); });
    porowave::verification::sweep(study, first, {.jobs = 1});
  }
  porowave::verification::sweep(study, alone, {.jobs = 1});
  BOOST_TEST(same_rows(first.all(), alone.all()));
}

BOOST_AUTO_TEST_CASE(cases_that_cannot_be_run_are_rows_with_their_reason) {
  const ScratchDirectory directory;
  const Study study = small_study(
      "\"time.courant\" = [0.5, 1.0]\n\"discretization.elements\" = [400]\n"
      "\"discretization.transfer\" = [\"shape\"]\n"
      "\"discretization.kernel\" = [\"bspline1\"]\n"
      "\"column.length\" = [0.1, 1e-8]\n");
  Store store = Store::create_or_open(directory.file("results"));
  const auto summary = porowave::verification::sweep(study, store, {.jobs = 2});
  BOOST_TEST(summary.by_status[static_cast<std::size_t>(CaseStatus::done)] == 1U);
  BOOST_TEST(summary.by_status[static_cast<std::size_t>(CaseStatus::broke_down)] == 1U);
  BOOST_TEST(summary.by_status[static_cast<std::size_t>(CaseStatus::refused)] == 2U);
  for (const Record& row : store.all()) {
    BOOST_TEST((row.status == CaseStatus::done) == row.reason.empty());
    BOOST_TEST((row.status == CaseStatus::done) == std::isfinite(row.measures[0]));
    if (row.status != CaseStatus::broke_down) continue;
    BOOST_TEST(row.steps > 0);
    BOOST_TEST(row.reason.starts_with("step " + std::to_string(row.steps) + ", t = "), row.reason);
    const std::string explained = repeat(store, row.id).now.reason;
    BOOST_TEST(explained.starts_with(row.reason + "; "), explained);
    for (const char* words : {" = ", " at x = ", " m, solid point ",
                              "likely cause: the time step is ", "try a smaller courant: 0."}) {
      BOOST_TEST(explained.find(words) != std::string::npos, explained);
    }
  }
}

BOOST_AUTO_TEST_CASE(rows_have_the_measures_of_waves) {
  const ScratchDirectory directory;
  const Study study = small_study("\"discretization.elements\" = [40, 60]\n");
  Store store = Store::create_or_open(directory.file("results"));
  porowave::verification::sweep(study, store, {.jobs = 2});
  for (const Record& row : store.all()) {
    BOOST_REQUIRE(row.measures.size() == measure_names().size());
    for (std::size_t m = 0; m < row.measures.size(); ++m) {
      const std::string& name = measure_names()[m];
      BOOST_TEST(std::isfinite(row.measures[m]) != name.starts_with("gap_"), name);
    }
    // The same number twice, once as a share of the error and once of the reference.
    const double l2 = row.measures[*measure_index("pore_pressure_field_l2")];
    const double share = row.measures[*measure_index("pore_pressure_ringing_share")];
    BOOST_TEST(row.measures[*measure_index("pore_pressure_ringing")] == l2 * std::sqrt(share),
               boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(a_row_of_a_program_that_measured_less_is_repeated_as_far_as_it_goes) {
  const ScratchDirectory directory;
  const Study study = small_study("\"discretization.seed\" = [1]\n");
  Store store = Store::create_or_open(directory.file("results"));
  porowave::verification::sweep(study, store, {.jobs = 1});
  Record row = store.all().at(0);
  BOOST_TEST(repeat(store, row.id).same);
  const auto late = *measure_index("fast_arrival_delay");
  const std::string now = row.id;
  const auto stored_as = [&](const std::string& id) {
    row.id = id;
    store.add({row});
    return repeat(store, id);
  };
  row.measures[late] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(stored_as("of another program").same);
  BOOST_TEST(comparison(stored_as("of yet another program")).find("differs") == std::string::npos);
  row.measures[0] *= 1.001;
  BOOST_TEST(!stored_as("with another error").same);
  // The same program measures what it measured.
  row = repeat(store, now).now;
  row.measures[late] = std::numeric_limits<double>::quiet_NaN();
  Store same = Store::create_or_open(directory.file("same"));
  same.add({row});
  BOOST_TEST(!repeat(same, now).same);
}

BOOST_AUTO_TEST_CASE(another_solver_runs_the_cases) {
  const ScratchDirectory directory;
  // Good for seed 1, broken for seed 2; the case is $0, the output $1.
  const auto with_adapter = [](const std::string& pressure) {
    return small_study(
        "\"discretization.seed\" = [1, 2]\n[adapter]\ncommand = [\"sh\", \"-c\", "
        "\"grep -q 'seed = 1' $0 || exit 7; printf 'x,pore_pressure\\\\n0.01," +
        pressure + "\\\\n' > $1\"]\n");
  };
  const Study study = with_adapter("0.0");
  Store store = Store::create_or_open(directory.file("results"));
  const auto first = porowave::verification::sweep(study, store, {.jobs = 2});
  BOOST_TEST(first.by_status[static_cast<std::size_t>(CaseStatus::done)] == 1U);
  BOOST_TEST(first.by_status[static_cast<std::size_t>(CaseStatus::broke_down)] == 1U);
  for (const Record& row : store.all()) {
    BOOST_TEST(row.specification.find("[adapter]\ncommand = [\"sh\"") != std::string::npos);
    BOOST_TEST(row.cpu_seconds > 0.0);
    if (row.status == CaseStatus::broke_down) {
      BOOST_TEST(row.reason == "exit code 7");
      BOOST_TEST(row.specification.find("seed = 2") != std::string::npos);
      BOOST_TEST(std::isnan(row.measures[*measure_index("pore_pressure_points_l1")]));
      continue;
    }
    BOOST_TEST(row.points == 1);
    for (const std::string& name : measure_names()) {
      const bool known = name.starts_with("pore_pressure_points") || name == "reference_error";
      BOOST_TEST(std::isfinite(row.measures[*measure_index(name)]) == known, name);
    }
    // A value of zero is wrong by all there is.
    BOOST_TEST(row.measures[*measure_index("pore_pressure_points_l2")] == 1.0);
    BOOST_CHECK_THROW(repeat(store, row.id), InputError);
  }
  BOOST_TEST(porowave::verification::sweep(study, store, {.jobs = 2}).reused == 2U);
  // Another program, and ours, are other cases.
  BOOST_TEST(porowave::verification::sweep(with_adapter("0.1"), store, {.jobs = 2}).reused == 0U);
  const Study ours = small_study("\"discretization.seed\" = [1, 2]\n");
  BOOST_TEST(porowave::verification::sweep(ours, store, {.jobs = 2}).reused == 0U);
  BOOST_TEST(store.all().size() == 6U);
}

BOOST_AUTO_TEST_SUITE_END()
