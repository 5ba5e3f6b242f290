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

BOOST_AUTO_TEST_SUITE(store)

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

BOOST_AUTO_TEST_CASE(measures_are_known_by_name) {
  BOOST_TEST(measure_names().size() == 26U);
  BOOST_TEST(measure_names()[measure_index("pore_pressure_field_l2").value()] ==
             "pore_pressure_field_l2");
  BOOST_TEST(!measure_index("pore_pressure"));
}

BOOST_AUTO_TEST_SUITE_END()
