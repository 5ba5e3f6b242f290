#include "verification/adapters/adapter_run.hpp"

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "reference/problem/errors.hpp"
#include "verification/process/scratch_directory.hpp"
#include "verification/run_output.hpp"

BOOST_AUTO_TEST_SUITE(adapter_run)

using namespace porowave;
using namespace porowave::verification;
namespace fs = std::filesystem;

namespace {

const std::string specification =
    "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
    "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\nintrinsic_permeability = 1.0e-11\n"
    "fluid_viscosity = 1.0e-3\n"
    "[column]\nlength = 0.1\nnear = \"drained_traction\"\nfar = \"rigid_sealed\"\n"
    "[load]\nshape = \"smooth_ramp\"\nmagnitude = 1.0\nduration = 1e-5\n"
    "[discretization]\nelements = 20\nkernel = \"bspline2\"\n[time]\nend = 2.0e-5\n";

const solver::Case& scene() {
  static const solver::Case one =
      solver::read_case(TomlDocument::parse(specification, "case.toml"));
  return one;
}

const reference::Profile& reference_of_scene() {
  static const auto profile = reference_profile(scene());
  return *profile;
}

/// A folder in which shell scripts run as adapters: $0 is the case, $1 the output.
class Folder {
 public:
  AdapterRun run(const std::string& script, double time_limit = 60.0) const {
    return run_adapter({{"sh", "-c", script}, time_limit, directory_.path(), ""}, specification,
                       scene(), reference_of_scene());
  }
  std::string text_of(const std::string& name) const {
    std::ifstream file(directory_.file(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.file(name), std::ios::binary) << text;
  }
  const std::string& path() const { return directory_.path(); }

 private:
  ScratchDirectory directory_;
};

void check_failure(const AdapterRun& run, const std::string& expected) {
  BOOST_TEST_REQUIRE(run.failure.has_value());
  BOOST_TEST(run.failure->find(expected) == 0U, "<" << *run.failure << "> is not " << expected);
  BOOST_TEST(run.failure->find('\n') == std::string::npos);
  for (const auto& error : run.errors) BOOST_TEST(!error.has_value());
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_program_gets_the_case_and_runs_in_the_folder) {
  const Folder folder;
  folder.run(
      "cp \"$0\" seen.toml; pwd > place; echo $# > count; ls \"${0%/*}\" > beside; cat >> "
      "seen.toml");
  BOOST_TEST(folder.text_of("seen.toml") == specification);
  BOOST_TEST(folder.text_of("count") == "1\n");
  BOOST_TEST(folder.text_of("beside") == "case.toml\n");
  std::string place = folder.text_of("place");
  place.pop_back();
  BOOST_TEST(fs::equivalent(place, folder.path()));
}

BOOST_AUTO_TEST_CASE(points_of_our_solver_have_their_errors) {
  const Folder folder;
  const RunResult ours = run_case(scene(), reference_of_scene());
  std::ostringstream points;
  write_points_csv(ours.snapshot, points);
  folder.write("points.csv", points.str());
  const AdapterRun run = folder.run("cp points.csv \"$1\"");
  BOOST_TEST(!run.failure.has_value());
  BOOST_TEST(run.points == ours.points);
  BOOST_TEST(run.reference_error == ours.reference_error);
  for (std::size_t f = 0; f < 4; ++f) {
    BOOST_TEST_REQUIRE(run.errors[f].has_value());
    BOOST_TEST(run.errors[f]->l1 == ours.errors[f].points.l1, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(run.errors[f]->l2 == ours.errors[f].points.l2, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(run.errors[f]->linf == ours.errors[f].points.linf,
               boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(what_it_costs_is_that_of_the_program) {
  const Folder folder;
  const AdapterRun run = folder.run(
      "i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done; sleep 0.1\n"
      "printf 'x,pore_pressure\\n0.01,0\\n' > \"$1\"");
  BOOST_TEST(!run.failure.has_value());
  BOOST_TEST(run.points == 1U);
  BOOST_TEST(run.cost.cpu_seconds > 0.01);
  BOOST_TEST(run.cost.wall_seconds > 0.1);
  BOOST_TEST(run.cost.peak_rss_bytes > 100'000);
}

BOOST_AUTO_TEST_CASE(a_time_in_the_output_is_that_of_the_case) {
  const Folder folder;
  const auto written = [&](const std::string& rows) {
    return folder.run("printf 'x,t,pore_pressure\\n" + rows + "' > \"$1\"");
  };
  BOOST_TEST(!written("0.01,2.000001e-5,0\\n").failure.has_value());
  check_failure(written("0.01,2.1e-5,0\\n"), "output.csv: t 2.1e-05: expected 2e-05");
  check_failure(written("0.01,1e-5,0\\n0.01,2e-5,0\\n"), "output.csv: t 1e-05: expected 2e-05");
  check_failure(written("0.01,2.000001e-5,0\\n0.01,2e-5,0\\n"), "output.csv: several times");
}

BOOST_AUTO_TEST_CASE(failures_say_why) {
  const Folder folder;
  check_failure(folder.run("exit 3"), "exit code 3");
  check_failure(folder.run("echo out; exit 3"), "exit code 3: out");
  check_failure(folder.run("echo out; printf 'first\\nsec\\tond\\033\\303\\n\\n' >&2; exit 4"),
                "exit code 4: first | sec ond??");
  check_failure(folder.run("for i in 1 2 3 4 5 6 7 8; do echo $i >&2; done; exit 1"),
                "exit code 1: 4 | 5 | 6 | 7 | 8");
  check_failure(folder.run("kill -11 $$"), "exit code 139");
  check_failure(folder.run("exit 0"), "output.csv was not written: expected");
  check_failure(folder.run("mkdir \"$1\""), "output.csv was not written: expected");
  check_failure(folder.run("mkfifo \"$1\""), "output.csv was not written: expected");
  check_failure(folder.run(": > \"$1\""), "output.csv: no header: expected");
  check_failure(folder.run("printf 'x,pore_pressure\\n0.01,nan\\n' > \"$1\""),
                "output.csv:2: pore_pressure nan: expected a number");
  check_failure(folder.run("printf 'x,pore_pressure\\n0.2,0\\n' > \"$1\""),
                "output.csv:2: x 0.2: ");
  const AdapterRun chatty = folder.run("head -c 10000000 /dev/zero | tr '\\0' a >&2; exit 1");
  check_failure(chatty, "exit code 1: aaa");
  BOOST_TEST(chatty.failure->size() < 600U);
  // An output does not excuse the exit code.
  check_failure(folder.run("printf 'x,pore_pressure\\n0.01,0\\n' > \"$1\"; exit 1"), "exit code 1");
}

BOOST_AUTO_TEST_CASE(a_program_that_does_not_end_is_ended) {
  const Folder folder;
  const AdapterRun run =
      folder.run("printf 'x,pore_pressure\\n0.01,0\\n' > \"$1\"; echo step 7 >&2; sleep 600", 0.5);
  check_failure(run, "no end within 0.5 s: step 7");
  BOOST_TEST(run.cost.wall_seconds < 30.0);
}

BOOST_AUTO_TEST_CASE(a_program_that_is_gone_is_no_result) {
  const Adapter gone{{"./gone"}, 60.0, ".", ""};
  BOOST_CHECK_THROW(run_adapter(gone, specification, scene(), reference_of_scene()),
                    EnvironmentError);
}

BOOST_AUTO_TEST_CASE(a_load_table_stands_beside_the_case) {
  const Folder folder;
  folder.write("far away.csv", "t,value\n0,0\n1e-5,0.1\n2e-5,0.30000000000000004\n");
  std::string text = specification;
  const std::string ramp = "shape = \"smooth_ramp\"\nmagnitude = 1.0\nduration = 1e-5\n";
  text.replace(text.find(ramp), ramp.size(),
               "shape = \"table\"\nmagnitude = 3.0\nfile = \"far away.csv\"\n");
  const auto document = TomlDocument::parse(text, folder.path() + "/study.toml");
  const solver::Case with_table = solver::read_case(document);
  const std::string canonical =
      document.canonical({"material", "column", "load", "discretization", "time"});
  run_adapter({{"sh", "-c", "cp \"${0%/*}\"/* ."}, 60.0, folder.path(), ""}, canonical, with_table,
              reference_of_scene());
  fs::remove(folder.path() + "/far away.csv");
  const Problem seen = load_problem(folder.path() + "/case.toml");
  BOOST_TEST(seen.load.magnitude() == 3.0);
  BOOST_TEST((seen.load.times() == with_table.problem.load.times()));
  BOOST_TEST((seen.load.values() == with_table.problem.load.values()));
}

BOOST_AUTO_TEST_CASE(nothing_is_left_behind) {
  const Folder folder;
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  setenv("TMPDIR", folder.path().c_str(), 1);
  folder.run("echo scratch > \"${1%/*}\"/more; exit 1");
  folder.run("printf 'x,pore_pressure\\n0.01,0\\n' > \"$1\"");
  before != nullptr ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
  BOOST_TEST(fs::is_empty(folder.path()));
}

BOOST_AUTO_TEST_SUITE_END()
