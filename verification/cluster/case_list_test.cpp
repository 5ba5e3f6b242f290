#include "verification/cluster/case_list.hpp"

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "reference/problem/errors.hpp"
#include "verification/process/scratch_directory.hpp"

BOOST_AUTO_TEST_SUITE(case_list)

using namespace porowave;
using namespace porowave::verification;

namespace {

CaseList::Entry entry(char digit, float seconds) {
  CaseList::Entry one{{}, seconds};
  one.id.fill(digit);
  return one;
}

/// What an InputError says of a file with this text.
std::string refusal(const std::string& text) {
  const ScratchDirectory directory;
  std::ofstream(directory.file("list")) << text;
  try {
    read_case_ids(directory.file("list"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_list_comes_back_as_it_was_under_its_key_only) {
  const ScratchDirectory directory;
  const std::string path = directory.file("cases");
  const CaseList list{{entry('1', 0.25F), entry('a', 1.5e-4F)}};
  write_case_list(path, list, "key");
  const auto read = read_case_list(path, "key");
  BOOST_REQUIRE(read.has_value());
  BOOST_REQUIRE(read->entries.size() == 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    BOOST_TEST(read->entries[i].id_text() == list.entries[i].id_text());
    BOOST_TEST(read->entries[i].seconds == list.entries[i].seconds);
  }
  BOOST_TEST(read->seconds() == 0.25 + 1.5e-4, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(!read_case_list(path, "other").has_value());
  BOOST_TEST(!read_case_list(directory.file("none"), "key").has_value());
  BOOST_TEST(
      read_case_ids(path) == (std::set<std::string>{std::string(32, '1'), std::string(32, 'a')}),
      boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_list_by_hand_may_have_comments_and_a_wrong_line_is_named) {
  const std::string id(32, 'b');
  BOOST_TEST(refusal("# mine\n\n" + id + "\r\n" + id) == "");
  for (const std::string& wrong : {std::string("bad"), id + "0", std::string(32, 'g')}) {
    const std::string said = refusal(id + "\n" + wrong + "\n");
    BOOST_TEST(said.find("list:2: " + wrong) != std::string::npos, said);
  }
  BOOST_CHECK_THROW(read_case_ids("/none/such"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
