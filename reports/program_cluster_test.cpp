#include <boost/test/unit_test.hpp>
#include <filesystem>

#include "reports/test_program.hpp"
#include "verification/store/store.hpp"

BOOST_AUTO_TEST_SUITE(program_cluster)

using namespace porowave::tests;
using porowave::verification::CaseStatus;
using porowave::verification::Record;
using porowave::verification::Store;

namespace {

namespace fs = std::filesystem;

/// sbatch and squeue that write down what they are given; nothing of Slurm is there.
class FakeSlurm {
 public:
  explicit FakeSlurm(const TestDirectory& folder) : log_(folder / "log"), queue_(folder / "queue") {
    const fs::path bin = folder / "bin";
    fs::create_directory(bin);
    write_script(bin / "sbatch",
                 "if [ \"$1\" = --version ]; then exit 0; fi\n"
                 "for word; do printf '%s\\n' \"$word\"; done >> '" +
                     log_.string() +
                     "'\n"
                     "echo 'end' >> '" +
                     log_.string() +
                     "'\n"
                     "echo \"4$(grep -c '^end$' '" +
                     log_.string() + "');cluster\"\n");
    write_script(bin / "squeue", "cat '" + queue_.string() + "'\n");
    write_text(queue_, "");
    path_ = bin.string() + ":/usr/bin:/bin";
  }
  const std::string& path() const { return path_; }
  std::string submitted() const { return fs::exists(log_) ? text_of(log_) : ""; }
  void set_queue(const std::string& states) const { write_text(queue_, states); }

 private:
  static void write_script(const fs::path& file, const std::string& text) {
    write_text(file, "#!/bin/sh\n" + text);
    fs::permissions(file, fs::perms::owner_all);
  }
  fs::path log_;
  fs::path queue_;
  std::string path_;
};

std::string study_text() {
  return CaseText().set("elements", "20").text() +
         "[study]\nname = \"trial\"\n[axes]\n\"discretization.seed\" = { first = 1, count = 6 }\n"
         "\"discretization.elements\" = [20, 30]\n";
}

std::string lines(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + "\n";
  return text;
}

std::size_t lines_in(const fs::path& file) {
  const std::string text = text_of(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

BOOST_AUTO_TEST_CASE(tasks_and_merge_are_submitted_and_again_only_what_is_missing) {
  const TestDirectory folder;
  const FakeSlurm slurm(folder);
  const TestVariable path("PATH", slurm.path());
  const fs::path work = folder / "it's \"mine\" $HOME";
  fs::create_directory(work);
  write_text(work / "a study.toml", study_text());
  const auto submit = [&] {
    return run_porowave({"sweep", "a study.toml", "--store", "s", "--slurm", "--tasks", "3",
                         "--nodes", "2", "--partition", "p q", "--time", "1:00"},
                        work);
  };
  const auto status = [&] {
    return run_porowave({"status", "a study.toml", "--store", "s"}, work).output;
  };
  const auto run_task = [&](const std::string& submission, const std::string& shard) {
    const TestVariable index("SLURM_ARRAY_TASK_ID", shard.substr(0, 1));
    const std::string store = (work / "s").string();
    return porowave::reports::run_process(
        {"sh", store + ".slurm/" + submission + "/sweep.sh", POROWAVE_PROGRAM,
         (work / "a study.toml").string(), store + ".shards/" + submission + "-", shard.substr(2),
         store + ".slurm/" + submission + "/cases", "1"},
        folder.path());
  };

  const auto first = submit();
  BOOST_TEST(first.exit_code == 0, first.errors);
  BOOST_TEST(contains(first.output, "12 of 12 cases are missing"), first.output);
  const std::string sent = slurm.submitted();
  const std::string store = (work / "s").string();
  BOOST_TEST(contains(sent, lines({"--partition=p q", "--time=1:00", "--array=1-3%2"})), sent);
  BOOST_TEST(contains(sent, lines({"--output=" + store + ".slurm/1/task-%a.out",
                                   store + ".slurm/1/sweep.sh", POROWAVE_PROGRAM,
                                   (work / "a study.toml").string(), store + ".shards/1-", "3",
                                   store + ".slurm/1/cases", "1", "end"})),
             sent);
  BOOST_TEST(contains(sent, "--dependency=afterany:41\n"), sent);

  slurm.set_queue("RUNNING\nPENDING\nPENDING\n");
  BOOST_TEST(contains(submit().output, "nothing submitted"));
  BOOST_TEST(slurm.submitted() == sent);
  BOOST_TEST(contains(status(), "Slurm: 1 running, 2 waiting"));
  slurm.set_queue("");

  const auto task = run_task("1", "2/3");
  BOOST_TEST(task.exit_code == 0, task.errors);
  BOOST_TEST(contains(task.output, "4 cases: 0 were in the store"), task.output);
  BOOST_TEST(contains(status(), "12 cases: 4 done, 0 broke down, 0 refused, 0 failed, 8 missing"));
  run_porowave({"merge", "s", "s.shards/1-2"}, work);
  BOOST_TEST(contains(submit().output, "8 of 12 cases are missing"));
  BOOST_TEST(lines_in(work / "s.slurm/2/cases") == 9U);  // and its key
  fs::remove(work / "s.shards/1-2");                     // what is in the store is not run again
  for (const std::string shard : {"1/3", "2/3", "3/3"}) {
    BOOST_TEST(run_task("2", shard).exit_code == 0);
  }
  BOOST_TEST(contains(status(), "12 done"));
  const std::string before = slurm.submitted();
  BOOST_TEST(contains(submit().output, "rows of 8 cases are in shards only"));
  const std::string merge = slurm.submitted().substr(before.size());
  BOOST_TEST(contains(merge, store + ".slurm/3/merge.sh\n"), merge);
  BOOST_TEST(!contains(merge, "--dependency"), merge);
  for (const char* shard : {"s.shards/2-1", "s.shards/2-2", "s.shards/2-3"}) {
    BOOST_TEST(run_porowave({"merge", "s", shard}, work).exit_code == 0);
  }
  const std::string merged = slurm.submitted();
  BOOST_TEST(contains(submit().output, "nothing to run, and all rows are in"));
  BOOST_TEST(slurm.submitted() == merged);
}

BOOST_AUTO_TEST_CASE(a_dry_run_prints_both_scripts_and_leaves_nothing) {
  const TestDirectory folder;
  const FakeSlurm slurm(folder);
  const TestVariable path("PATH", slurm.path());
  write_text(folder / "study.toml", study_text());
  const std::string before = folder.contents();
  const auto dry =
      run_porowave({"sweep", "study.toml", "--store", "s", "--slurm", "--dry-run"}, folder.path());
  BOOST_TEST(dry.exit_code == 0);
  for (const char* part :
       {"12 of 12 cases", ": 1 tasks", "exec \"$1\" sweep \"$2\"", "exec \"$program\" merge",
        "# sbatch --parsable", "--dependency=afterany:JOB"}) {
    BOOST_TEST(contains(dry.output, part), dry.output << " lacks " << part);
  }
  BOOST_TEST(folder.contents() == before);
  BOOST_TEST(slurm.submitted() == "");
}

BOOST_AUTO_TEST_CASE(without_slurm_there_is_one_message_and_a_status) {
  const TestDirectory folder;
  write_text(folder / "study.toml", study_text());
  const TestVariable path("PATH", folder.path().string());
  const auto submit =
      run_porowave({"sweep", "study.toml", "--store", "s", "--slurm"}, folder.path());
  BOOST_TEST(submit.exit_code == 5);
  BOOST_TEST(is_one_line(submit.errors), submit.errors);
  BOOST_TEST(contains(submit.errors, "sbatch: cannot be started"), submit.errors);
  BOOST_TEST(folder.contents() == "study.toml");
  const auto status = run_porowave({"status", "study.toml", "--store", "s"}, folder.path());
  BOOST_TEST(status.exit_code == 0);
  BOOST_TEST(contains(status.output, "12 missing"));
  BOOST_TEST(contains(status.output, "no queue to ask: 0 of 0 shards"));
  BOOST_TEST(contains(status.output, "time left: unknown"));
  check_failure(run_porowave({"status", "none.toml", "--store", "s"}), 2, {"none.toml"});
  check_failure(
      run_porowave({"sweep", "study.toml", "--store", "s", "--nodes", "2"}, folder.path()), 2,
      {"--nodes", "--slurm"});
}

BOOST_AUTO_TEST_SUITE_END()
