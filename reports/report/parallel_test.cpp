#include "reports/report/parallel.hpp"

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(parallel)

using porowave::reports::parallel_for;

BOOST_AUTO_TEST_CASE(every_index_once) {
  std::vector<std::atomic<int>> calls(1000);
  parallel_for(calls.size(), [&](std::size_t i) { ++calls[i]; });
  for (const auto& count : calls) BOOST_TEST(count == 1);
  parallel_for(0, [](std::size_t) { BOOST_TEST(false); });
}

BOOST_AUTO_TEST_CASE(an_exception_ends_it_and_comes_out) {
  std::atomic<int> calls = 0;
  const auto work = [&](std::size_t i) {
    ++calls;
    if (i == 5) throw std::runtime_error("five");
  };
  BOOST_CHECK_EXCEPTION(parallel_for(1000000, work), std::runtime_error,
                        [](const auto& error) { return std::string(error.what()) == "five"; });
  BOOST_TEST(calls < 1000000);
}

BOOST_AUTO_TEST_SUITE_END()
