#include "verification/cluster/status.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "reference/problem/errors.hpp"
#include "verification/process/scratch_directory.hpp"
#include "verification/store/store.hpp"

BOOST_AUTO_TEST_SUITE(status)

using namespace porowave;
using namespace porowave::verification;

namespace {

constexpr std::int64_t noon = 1795262400;  // 2026-11-21T12:00:00Z

std::string id(char digit) {
  return std::string(32, digit);
}

Record record(char digit, CaseStatus status, const std::string& finished = "2026-11-21T11:00:00Z") {
  Record row;
  row.id = id(digit);
  row.status = status;
  row.finished = finished;
  return row;
}

/// Cases 0 to 7, of 1 to 8 seconds.
CaseList eight_cases() {
  CaseList list;
  for (int i = 0; i < 8; ++i) {
    CaseList::Entry entry{{}, static_cast<float>(i + 1)};
    entry.id.fill(static_cast<char>('0' + i));
    list.entries.push_back(entry);
  }
  return list;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_case_counts_once_whatever_stores_it_is_in) {
  const ScratchDirectory directory;
  Store::create_or_open(directory.file("s"))
      .add({record('0', CaseStatus::done), record('1', CaseStatus::failed),
            record('2', CaseStatus::failed), record('3', CaseStatus::broke_down),
            record('f', CaseStatus::done)});  // of another study
  Store::create_or_open(directory.file("1"), Store::Journal::rollback)
      .add({record('0', CaseStatus::done), record('1', CaseStatus::done),
            record('4', CaseStatus::refused)});
  Store::create_or_open(directory.file("2"), Store::Journal::rollback)
      .add({record('1', CaseStatus::failed), record('4', CaseStatus::refused),
            record('7', CaseStatus::done)});
  const auto status = study_status(eight_cases(), directory.file("s"),
                                   {directory.file("1"), directory.file("2")}, noon);
  BOOST_TEST(status.by_status == (std::array<std::size_t, 4>{3, 1, 1, 1}),
             boost::test_tools::per_element());
  BOOST_TEST(status.missing == 2U);
  std::string unfinished;
  for (const auto& entry : status.unfinished.entries) unfinished += entry.id[0];
  BOOST_TEST(unfinished == "256");
  BOOST_TEST(status.rate == 0.0);  // an hour ago
}

BOOST_AUTO_TEST_CASE(time_left_is_predicted_cost_at_the_rate_of_late) {
  const ScratchDirectory directory;
  Store::create_or_open(directory.file("s"))
      .add({record('0', CaseStatus::done, "2026-11-21T11:49:59Z"),      // too long ago
            record('1', CaseStatus::done, "2026-11-21T11:59:00Z"),      // 2 s of cost
            record('3', CaseStatus::done, "2026-11-21T11:58:20Z"),      // 4 s, 100 s ago
            record('2', CaseStatus::failed, "2026-11-21T11:57:00Z")});  // no progress
  const auto status = study_status(eight_cases(), directory.file("s"), {}, noon);
  BOOST_TEST(status.rate == 6.0 / 100.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(status.seconds_left() == (3.0 + 5 + 6 + 7 + 8) / 0.06,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(without_stores_all_is_missing_and_a_foreign_file_is_refused) {
  const ScratchDirectory directory;
  BOOST_TEST(study_status(eight_cases(), directory.file("none"), {}, noon).missing == 8U);
  std::ofstream(directory.file("text")) << "not a store, and long enough to be looked at as one";
  BOOST_CHECK_THROW(
      study_status(eight_cases(), directory.file("none"), {directory.file("text")}, noon),
      InputError);
}

BOOST_AUTO_TEST_SUITE_END()
