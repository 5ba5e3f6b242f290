#include "verification/sweep/shares.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <functional>
#include <numeric>
#include <random>

BOOST_AUTO_TEST_SUITE(shares)

using porowave::verification::share_sums;
using porowave::verification::shared_out;

BOOST_AUTO_TEST_CASE(each_goes_to_the_least_so_far) {
  const std::vector<double> works = {5.0, 4.0, 3.0, 3.0, 1.0};
  const std::vector<int> share_of = shared_out(works, 2);
  BOOST_TEST(share_of == (std::vector<int>{0, 1, 1, 0, 1}), boost::test_tools::per_element());
  BOOST_TEST(share_sums(works, share_of, 2) == (std::vector<double>{8.0, 8.0}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_largest_share_keeps_grahams_bounds) {
  std::mt19937 random(7);
  std::exponential_distribution<double> work;
  for (const int shares : {1, 2, 7, 40}) {
    for (int trial = 0; trial < 50; ++trial) {
      std::vector<double> works(60);
      for (double& w : works) w = work(random);
      const double all = std::accumulate(works.begin(), works.end(), 0.0);
      const double least = std::max(all / shares, *std::max_element(works.begin(), works.end()));
      const auto largest = [&] {
        const auto sums = share_sums(works, shared_out(works, shares), shares);
        BOOST_TEST(std::accumulate(sums.begin(), sums.end(), 0.0) == all,
                   boost::test_tools::tolerance(1e-12));
        return *std::max_element(sums.begin(), sums.end());
      };
      const double as_they_stand = largest();
      BOOST_TEST(as_they_stand >= least * (1.0 - 1e-12));
      BOOST_TEST(as_they_stand <= (2.0 - 1.0 / shares) * least * (1.0 + 1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(falling_order_meets_its_worst_case_and_no_more) {
  // Graham's example for two shares: 7/6 of the best, 3+3 and 2+2+2.
  const std::vector<double> works = {3.0, 3.0, 2.0, 2.0, 2.0};
  const auto sums = share_sums(works, shared_out(works, 2), 2);
  BOOST_TEST(*std::max_element(sums.begin(), sums.end()) == 7.0);
}

BOOST_AUTO_TEST_SUITE_END()
