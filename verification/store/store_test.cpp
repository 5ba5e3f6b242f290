#include "verification/store/store.hpp"

#include <sys/resource.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>

#include "reference/problem/errors.hpp"
#include "verification/process/scratch_directory.hpp"

BOOST_AUTO_TEST_SUITE(store)

using namespace porowave;
using namespace porowave::verification;

namespace {

Record record(const std::string& id, CaseStatus status = CaseStatus::done) {
  Record r;
  r.id = id;
  r.study = "trial";
  r.specification = "[a]\nx = \"it's; DROP TABLE cases\"\n";
  r.status = status;
  r.reason = status == CaseStatus::done ? "" : "because";
  r.steps = 12;
  r.time_step = 0.1 + 0.2;
  r.points = 7;
  for (std::size_t m = 0; m < measure_names().size(); ++m) {
    r.measures.push_back(1.0 / (3.0 + static_cast<double>(m)));
  }
  r.measures[3] = std::numeric_limits<double>::quiet_NaN();
  r.cpu_seconds = 0.5;
  r.provenance = "p";
  return r;
}

void check_equal(const Record& a, const Record& b) {
  BOOST_TEST(a.id == b.id);
  BOOST_TEST(a.specification == b.specification);
  BOOST_CHECK(a.status == b.status);
  BOOST_TEST(a.reason == b.reason);
  BOOST_TEST(a.time_step == b.time_step);  // to the last bit
  for (std::size_t m = 0; m < a.measures.size(); ++m) {
    BOOST_TEST((a.measures[m] == b.measures[m] ||
                (std::isnan(a.measures[m]) && std::isnan(b.measures[m]))));
  }
}

/// The store of a program that knew only the 26 measures of norms and reference, with one row.
void make_old_store(const std::string& path) {
  Database old(path, Database::Mode::create);
  std::string names;
  for (std::size_t m = 0; m < 26; ++m) names += measure_names()[m] + " REAL, ";
  old.execute(
      "PRAGMA journal_mode = WAL; CREATE TABLE cases (id TEXT PRIMARY KEY, study TEXT NOT NULL, "
      "specification TEXT NOT NULL, status TEXT NOT NULL, reason TEXT NOT NULL, steps INTEGER NOT "
      "NULL, time_step REAL, points INTEGER NOT NULL, " +
      names +
      "cpu_seconds REAL, wall_seconds REAL, peak_rss_bytes INTEGER, finished TEXT NOT NULL, "
      "provenance TEXT NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE provenance (id TEXT PRIMARY KEY, version TEXT, git TEXT, numerics TEXT, "
      "compiler TEXT, flags TEXT, cpu TEXT, host TEXT) WITHOUT ROWID;"
      "PRAGMA application_id = 0x706f726f; PRAGMA user_version = 1;"
      "INSERT INTO cases (id, study, specification, status, reason, steps, time_step, points, "
      "effective_stress_field_l2, largest_strain, cpu_seconds, finished, provenance) "
      "VALUES ('old', 'trial', '[a]', 'done', '', 5, 0.25, 7, 0.0625, 1e-9, 0.5, '', 'p')");
}

void check_old_row(const Record& row) {
  BOOST_TEST(row.id == "old");
  BOOST_TEST(row.steps == 5);
  BOOST_TEST(row.measures[measure_index("effective_stress_field_l2").value()] == 0.0625);
  BOOST_TEST(row.measures[measure_index("largest_strain").value()] == 1e-9);
  BOOST_TEST(row.cpu_seconds == 0.5);
  BOOST_TEST(row.provenance == "p");
  BOOST_REQUIRE(row.measures.size() == measure_names().size());
  for (std::size_t m = 26; m < row.measures.size(); ++m) BOOST_TEST(std::isnan(row.measures[m]));
}

/// While it lives no file may grow beyond a size: to a program that is what a full disk is.
class NoLargeFiles {
 public:
  explicit NoLargeFiles(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~NoLargeFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }

 private:
  rlimit before_{};
};

}  // namespace

BOOST_AUTO_TEST_CASE(rows_come_back_as_they_were_in_the_order_of_their_ids) {
  const ScratchDirectory directory;
  Store store = Store::create_or_open(directory.file("results"));
  store.add({record("b"), record("a", CaseStatus::broke_down)});
  const auto rows = Store::open(directory.file("results")).all();
  BOOST_REQUIRE(rows.size() == 2U);
  check_equal(rows[0], record("a", CaseStatus::broke_down));
  check_equal(rows[1], record("b"));
  BOOST_TEST(store.all("trial").size() == 2U);
  BOOST_TEST(store.all("other").empty());
  BOOST_TEST(!store.find("c"));
  check_equal(store.find("b").value(), record("b"));
}

BOOST_AUTO_TEST_CASE(only_a_failed_row_is_replaced) {
  const ScratchDirectory directory;
  Store store = Store::create_or_open(directory.file("results"));
  store.add({record("a"), record("b", CaseStatus::failed), record("c", CaseStatus::broke_down)});
  BOOST_TEST(store.finished_ids() == (std::set<std::string>{"a", "c"}),
             boost::test_tools::per_element());
  BOOST_TEST(!store.finished("b"));
  Record changed = record("a");
  changed.steps = 99;
  store.add({changed, record("b")});
  BOOST_TEST(store.find("a")->steps == 12);
  BOOST_TEST(store.finished("b"));
}

BOOST_AUTO_TEST_CASE(merging_adds_what_is_missing_and_keeps_what_is_there) {
  const ScratchDirectory directory;
  Store store = Store::create_or_open(directory.file("one"));
  Record mine = record("a");
  mine.steps = 99;
  store.add({mine, record("b", CaseStatus::failed)});
  {
    Store other = Store::create_or_open(directory.file("it's other"));
    other.add({record("a"), record("b"), record("c", CaseStatus::failed)});
    other.add(current_provenance());
  }
  store.merge(directory.file("it's other"));
  store.merge(directory.file("it's other"));  // again changes nothing
  BOOST_TEST(store.all().size() == 3U);
  BOOST_TEST(store.find("a")->steps == 99);
  BOOST_TEST(store.finished("b"));
  BOOST_TEST(!store.finished("c"));
}

BOOST_AUTO_TEST_CASE(files_that_are_no_store_are_refused_and_left_as_they_are) {
  const ScratchDirectory directory;
  std::ofstream(directory.file("text")) << "this is not a database, but long enough to be one";
  BOOST_CHECK_THROW(Store::open(directory.file("text")), InputError);
  BOOST_CHECK_THROW(Store::create_or_open(directory.file("text")), InputError);
  BOOST_TEST(std::filesystem::file_size(directory.file("text")) == 49U);
  BOOST_CHECK_THROW(Store::open(directory.file("missing")), InputError);
  BOOST_TEST(!std::filesystem::exists(directory.file("missing")));
  BOOST_CHECK_THROW(Store::open(directory.path()), InputError);
  Database(directory.file("foreign"), Database::Mode::create).execute("CREATE TABLE t (x)");
  BOOST_CHECK_THROW(Store::create_or_open(directory.file("foreign")), InputError);
  BOOST_CHECK_THROW(Store::create_or_open(directory.file("no/such/directory")), EnvironmentError);
  Store::create_or_open(directory.file("newer"));
  Database(directory.file("newer"), Database::Mode::create).execute("PRAGMA user_version = 99");
  BOOST_CHECK_THROW(Store::open(directory.file("newer")), InputError);
}

BOOST_AUTO_TEST_CASE(a_store_whose_making_was_cut_short_is_made_again) {
  const ScratchDirectory directory;
  // What a kill leaves: a database in WAL mode, without a table and of nobody.
  Database(directory.file("results"), Database::Mode::create).execute("PRAGMA journal_mode = WAL");
  BOOST_REQUIRE(std::filesystem::file_size(directory.file("results")) > 0U);
  Store store = Store::create_or_open(directory.file("results"));
  store.add({record("a")});
  BOOST_TEST(store.all().size() == 1U);
}

BOOST_AUTO_TEST_CASE(on_a_full_disk_a_transaction_is_dropped_whole_and_the_store_goes_on) {
  const ScratchDirectory directory;
  Store store = Store::create_or_open(directory.file("results"));
  store.add({record("a")});
  std::vector<Record> many(2000, record("x"));
  for (std::size_t i = 0; i < many.size(); ++i) many[i].id += std::to_string(i);
  {
    const NoLargeFiles full(200'000);  // bytes; 2000 rows need more
    BOOST_CHECK_THROW(store.add(many), EnvironmentError);
  }
  BOOST_TEST(store.all().size() == 1U);
  store.add(many);
  BOOST_TEST(store.all().size() == 2001U);
}

BOOST_AUTO_TEST_CASE(a_store_that_knew_fewer_measures_is_read_as_it_is) {
  const ScratchDirectory directory;
  const std::string path = directory.file("old");
  make_old_store(path);
  const Store store = Store::open(path);
  BOOST_REQUIRE(store.all().size() == 1U);
  check_old_row(store.all("trial")[0]);
  check_old_row(store.find("old").value());
  check_old_row(store.beginning_with("o").at(0));
  BOOST_TEST(store.finished("old"));
}

BOOST_AUTO_TEST_CASE(a_store_that_knew_fewer_measures_is_added_to) {
  const ScratchDirectory directory;
  const std::string path = directory.file("old");
  make_old_store(path);
  for (int i = 0; i < 2; ++i) {  // again changes nothing
    Store store = Store::create_or_open(path);
    store.add({record("new")});
    BOOST_REQUIRE(store.count() == 2U);
    check_equal(store.find("new").value(), record("new"));
    check_old_row(store.find("old").value());
  }
}

BOOST_AUTO_TEST_CASE(stores_with_other_measures_are_merged_without_loss) {
  const ScratchDirectory directory;
  make_old_store(directory.file("old"));
  make_old_store(directory.file("other old"));
  Store mine = Store::create_or_open(directory.file("mine"));
  mine.add({record("new")});
  mine.merge(directory.file("old"));
  check_old_row(mine.find("old").value());
  check_equal(mine.find("new").value(), record("new"));

  // And the other way round, with a measure that this program does not know.
  Database later(directory.file("mine"), Database::Mode::create);
  later.execute("ALTER TABLE cases ADD COLUMN \"of \"\"tomorrow\"\"\" REAL");
  later.execute("UPDATE cases SET \"of \"\"tomorrow\"\"\" = 4.5 WHERE id = 'new'");
  Store old = Store::create_or_open(directory.file("other old"));
  old.merge(directory.file("mine"));
  BOOST_TEST(old.count() == 2U);
  check_equal(old.find("new").value(), record("new"));
  check_old_row(old.find("old").value());
  Database merged(directory.file("other old"), Database::Mode::read);
  Statement value = merged.prepare("SELECT \"of \"\"tomorrow\"\"\" FROM cases WHERE id = 'new'");
  BOOST_REQUIRE(value.step());
  BOOST_TEST(value.number(0).value() == 4.5);
}

BOOST_AUTO_TEST_CASE(measures_are_known_by_name) {
  BOOST_TEST(measure_names()[0] == "effective_stress_points_l1");
  BOOST_TEST(measure_names()[measure_index("pore_pressure_field_l2").value()] ==
             "pore_pressure_field_l2");
  BOOST_TEST(!measure_index("pore_pressure"));
}

BOOST_AUTO_TEST_SUITE_END()
