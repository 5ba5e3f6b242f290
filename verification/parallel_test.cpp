#include "verification/parallel.hpp"

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(parallel)

using porowave::verification::parallel_for;

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

// Which of two fails earlier is chance; a message to a user must not depend on it.
BOOST_AUTO_TEST_CASE(the_first_index_that_fails_is_told) {
  for (const std::size_t earlier : {3U, 4U}) {
    std::atomic<bool> one_failed = false;
    std::atomic<int> begun = 0;
    const auto work = [&](std::size_t i) {
      if (i != 3 && i != 4) return;
      ++begun;
      // Both are under way before either fails.
      while (begun < 2 || (i != earlier && !one_failed)) std::this_thread::yield();
      if (i == earlier) one_failed = true;
      if (i != earlier) std::this_thread::sleep_for(std::chrono::milliseconds(20));
      throw std::runtime_error(i == 3 ? "three" : "four");
    };
    BOOST_CHECK_EXCEPTION(parallel_for(100, work, 2), std::runtime_error,
                          [](const auto& error) { return std::string(error.what()) == "three"; });
  }
}

BOOST_AUTO_TEST_CASE(no_more_threads_than_asked_for) {
  std::set<std::thread::id> seen;
  parallel_for(
      100, [&](std::size_t) { seen.insert(std::this_thread::get_id()); }, 1);
  BOOST_TEST(seen.size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
