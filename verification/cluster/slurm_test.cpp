#include "verification/cluster/slurm.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "verification/process/process.hpp"
#include "verification/process/scratch_directory.hpp"

BOOST_AUTO_TEST_SUITE(slurm)

using namespace porowave::verification;

namespace {

bool has(const SlurmJob& job, const std::string& word) {
  return std::find(job.command.begin(), job.command.end(), word) != job.command.end();
}

}  // namespace

BOOST_AUTO_TEST_CASE(tasks_are_worth_their_overhead) {
  const auto tasks = [](double seconds, std::size_t study, int nodes, int cpus) {
    return task_count(seconds, study, study, {.nodes = nodes, .cpus = cpus});
  };
  BOOST_TEST(task_count(0.0, 100, 0, {}) == 0);
  BOOST_TEST(tasks(1.0, 100, 2, 1) == 1);
  // One a node has at least 3.2 s of its own to do, more than these at least 32 s.
  for (const double seconds : {50.0, 200.0, 1000.0, 1e5}) {
    for (const int nodes : {1, 2, 10, 100}) {
      for (const int cpus : {1, 8}) {
        const int count = tasks(seconds, 1000, nodes, cpus);
        BOOST_TEST((count == 1 || seconds / cpus / count >= (count <= nodes ? 3.2 : 32.0)));
        BOOST_TEST((count >= nodes || seconds / cpus / (count + 1) < 3.4));
        BOOST_TEST((count <= nodes || count % nodes == 0));
      }
    }
  }
  BOOST_TEST(tasks(1e4, 1000, 2, 1) == 16);          // eight a node
  BOOST_TEST(tasks(1e4, 1'000'000, 2, 1) == 6);      // 40.8 s before a task begins
  BOOST_TEST(tasks(3.6e5, 1000, 2, 1) == 100);       // an hour each
  BOOST_TEST(tasks(1e9, 1'000'000, 10, 1) == 1000);  // MaxArraySize
  BOOST_TEST(task_count(1e4, 1000, 3, {.nodes = 2}) == 3);
  BOOST_TEST(task_count(1.0, 1000, 900, {.tasks = 7}) == 7);
}

BOOST_AUTO_TEST_CASE(what_a_user_typed_is_an_argument_and_no_part_of_a_script) {
  const ClusterFiles files("/data/it's 100% \"$(rm)\"");
  const SlurmJob sweep = sweep_job(files, 3, 8, "/bin/p w", "/s t'.toml",
                                   {.partition = "long; x", .time = "2:00", .nodes = 2, .cpus = 4});
  for (const std::string word :
       {"--array=1-8%2", "--cpus-per-task=4", "--partition=long; x", "--time=2:00", "/bin/p w",
        "/s t'.toml", "/data/it's 100% \"$(rm)\".shards/3-",
        "--output=/data/it's 100%% \"$(rm)\".slurm/3/task-%a.out",
        "/data/it's 100% \"$(rm)\".slurm/3/cases"}) {
    BOOST_TEST(has(sweep, word), word);
  }
  const SlurmJob merge = merge_job(files, 3, "/bin/p w", {}, "42");
  BOOST_TEST(has(merge, "--dependency=afterany:42"));
  for (const std::string& word : merge_job(files, 3, "/bin/p w", {}, "").command) {
    BOOST_TEST(!word.starts_with("--dependency"), word);
  }
  for (const SlurmJob& job : {sweep, merge}) {
    BOOST_TEST(job.script.find("data") == std::string::npos);
    BOOST_TEST(job.script.find("p w") == std::string::npos);
  }
  BOOST_TEST(shell_line({"a", "it's", ""}) == "a 'it'\\''s' ''");
}

BOOST_AUTO_TEST_CASE(the_merging_script_takes_shards_and_leaves_their_journals) {
  const ScratchDirectory directory;
  const ClusterFiles files(directory.file("it's mine"));
  const std::string script = directory.file("merge.sh");
  std::ofstream(script) << merge_job(files, 1, "echo", {}, "1").script;
  const auto run = [&] {
    return run_process({"sh", script, "echo", files.store, files.shard_folder}, directory.path());
  };
  BOOST_TEST(run().exit_code == 5);
  std::filesystem::create_directory(files.shard_folder);
  BOOST_TEST(run().exit_code == 5);
  for (const char* name : {"1-1", "1-10", "1-10-journal", "2-1-wal"}) {
    std::ofstream(files.shard_folder + "/" + name) << "x";
  }
  const std::string shard = files.shard_folder + "/1-1";
  BOOST_TEST(run().output == "merge " + files.store + " " + shard + " " + shard + "0\n");
  BOOST_TEST(files.shards() == (std::vector<std::string>{shard, shard + "0"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
