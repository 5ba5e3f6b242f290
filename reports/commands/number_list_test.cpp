#include "reports/commands/number_list.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/errors.hpp"
#include "reports/test_directory.hpp"

BOOST_AUTO_TEST_SUITE(number_list)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;
using Numbers = std::vector<double>;

namespace {

Numbers parsed(const std::string& text) {
  return parse_number_list(text, "--x");
}

}  // namespace

BOOST_AUTO_TEST_CASE(lists_are_taken_as_they_are) {
  BOOST_TEST(parsed("4e-5") == Numbers({4e-5}));
  BOOST_TEST(parsed("0,0.1,-3,1e-5") == Numbers({0.0, 0.1, -3.0, 1e-5}),
             boost::test_tools::per_element());
  BOOST_TEST(parsed("2,1,2") == Numbers({2.0, 1.0, 2.0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(ranges_are_even_and_their_ends_exact) {
  BOOST_TEST(parsed("0:1:5") == Numbers({0.0, 0.25, 0.5, 0.75, 1.0}),
             boost::test_tools::per_element());
  BOOST_TEST(parsed("1:0:3") == Numbers({1.0, 0.5, 0.0}), boost::test_tools::per_element());
  BOOST_TEST(parsed("-1:1:2") == Numbers({-1.0, 1.0}), boost::test_tools::per_element());
  for (const std::string last : {"0.1", "0.3", "0.7", "1e-5", "123.456"}) {
    for (const std::string count : {"2", "3", "7", "101", "1000"}) {
      const Numbers numbers = parsed("0.01:" + last + ":" + count);
      BOOST_TEST(numbers.size() == std::stoul(count));
      BOOST_TEST(numbers.front() == 0.01);
      BOOST_TEST(numbers.back() == std::stod(last));
      const double spacing = (numbers.back() - 0.01) / static_cast<double>(numbers.size() - 1);
      for (std::size_t i = 1; i < numbers.size(); ++i) {
        BOOST_TEST(numbers[i] - numbers[i - 1] == spacing, boost::test_tools::tolerance(1e-9));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_range_of_one_number_is_its_first) {
  BOOST_TEST(parsed("0.2:0.9:1") == Numbers({0.2}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(everything_else_is_refused) {
  for (const std::string text :
       {"",      "1:2",    "1,,2",    ",1",      "1,",       "a",       "1a",    "1 2",   "1;2",
        "0:1:0", "0:1:-3", "0:1:1.5", "0:1:2:3", "0:1:",     ":1:2",    "::",    "1e999", "-1e999",
        "nan",   "inf",    "0:inf:3", "0:nan:3", "0:1:1e12", "0:1:nan", "0:1,2", "0x10",  "+-1"}) {
    const auto message = message_of<InputError>([&] { parsed(text); });
    BOOST_TEST(message ==
               "--x " + text + ": expected numbers as FIRST:LAST:COUNT or as a comma list");
  }
}

BOOST_AUTO_TEST_CASE(positive_ranges_are_even_in_the_logarithm) {
  const auto positive = [](const std::string& text) {
    return parse_positive_list(text, "--frequency");
  };
  BOOST_TEST(positive("1:1e4:5") == Numbers({1, 10, 100, 1e3, 1e4}),
             boost::test_tools::tolerance(1e-14) << boost::test_tools::per_element());
  BOOST_TEST(positive("0.3:70:9").front() == 0.3);
  BOOST_TEST(positive("0.3:70:9").back() == 70.0);
  BOOST_TEST(positive("1e4:1:2") == Numbers({1e4, 1}), boost::test_tools::per_element());
  BOOST_TEST(positive("3:9:1") == Numbers({3}), boost::test_tools::per_element());
  BOOST_TEST(positive("5,1,2") == Numbers({5, 1, 2}), boost::test_tools::per_element());
  for (const std::string text : {"0", "-1", "1,0", "0:1:3", "-1:1:3", "1:-1:4"}) {
    BOOST_TEST(message_of<InputError>([&] { positive(text); }) ==
               "--frequency " + text + ": expected numbers > 0");
  }
  BOOST_TEST(message_of<InputError>([&] { positive("1:2"); }) ==
             "--frequency 1:2: expected numbers as FIRST:LAST:COUNT or as a comma list");
}

BOOST_AUTO_TEST_SUITE_END()
