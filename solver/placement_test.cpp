#include "solver/placement.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(placement)

namespace {

constexpr std::array all_placements = {Placement::uniform, Placement::jittered,
                                       Placement::stratified, Placement::random};

Discretization choice(Placement placement, int elements, int points_per_element,
                      std::uint64_t seed = 1) {
  Discretization d;
  d.placement = placement;
  d.elements = elements;
  d.points_per_element = points_per_element;
  d.seed = seed;
  return d;
}

std::size_t count_in(const std::vector<double>& x, double low, double high) {
  return static_cast<std::size_t>(
      std::count_if(x.begin(), x.end(), [&](double y) { return low <= y && y < high; }));
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Kolmogorov-Smirnov: sqrt(N) times the largest distance between the empirical distribution of the
// values and the uniform one on [0, 1]. Above 1.95 with probability 1e-3, above 2.7 with 1e-6.
double distance_from_uniform(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  double distance = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto rank = static_cast<double>(k);
    distance = std::max({distance, values[k] - rank / n, (rank + 1.0) / n - values[k]});
  }
  return std::sqrt(n) * distance;
}

// Correlation coefficient times sqrt(N): normal with variance 1 for independent values.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  const double mean_a = sum(a) / n;
  const double mean_b = sum(b) / n;
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  return std::sqrt(n) * ab / std::sqrt(aa * bb);
}

BOOST_AUTO_TEST_CASE(points_are_in_the_column_and_fill_it) {
  const double h = 0.1 / 101;
  for (const Placement placement : all_placements) {
    for (const int n : {1, 3, 4}) {
      for (const Phase phase : {Phase::solid, Phase::fluid}) {
        const auto points = place_points(choice(placement, 101, n), h, phase);
        BOOST_TEST_CONTEXT(name(placement) << ", " << n << " per element") {
          BOOST_TEST(points.x.size() == static_cast<std::size_t>(101 * n));
          BOOST_TEST(points.volume.size() == points.x.size());
          BOOST_TEST(*std::min_element(points.x.begin(), points.x.end()) >= 0.0);
          BOOST_TEST(*std::max_element(points.x.begin(), points.x.end()) <= 0.1);
          BOOST_TEST(std::abs(sum(points.volume) - 0.1) < 1e-15);
          for (const double volume : points.volume) BOOST_TEST(std::abs(volume - h / n) < 1e-18);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(uniform_points_are_equally_spaced_from_half_a_spacing_on) {
  // 4 elements of 0.5 m, 2 points in each: exact in binary
  const auto points = place_points(choice(Placement::uniform, 4, 2), 0.5, Phase::solid);
  const std::vector<double> expected{0.125, 0.375, 0.625, 0.875, 1.125, 1.375, 1.625, 1.875};
  BOOST_TEST(points.x == expected, boost::test_tools::per_element());
  // no chance in it
  for (const std::uint64_t seed : {0U, 1U, 2U}) {
    const auto d = choice(Placement::uniform, 4, 2, seed);
    BOOST_TEST(place_points(d, 0.5, Phase::fluid).x == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(jittered_points_stay_within_their_share_of_the_spacing_and_use_it) {
  const double h = 0.5;
  for (const double jitter : {0.0, 0.25, 1.0}) {
    for (const int n : {1, 3}) {
      auto d = choice(Placement::jittered, 400, n, 7);
      d.jitter = jitter;
      const auto regular = place_points(choice(Placement::uniform, 400, n), h, Phase::solid).x;
      const auto x = place_points(d, h, Phase::solid).x;
      BOOST_TEST_REQUIRE(x.size() == regular.size());
      std::vector<double> share;  // of the way from the lowest to the highest allowed place
      for (std::size_t p = 0; p < x.size(); ++p) {
        const double offset = (x[p] - regular[p]) * n / h;  // in point spacings
        BOOST_TEST(std::abs(offset) <= 0.5 * jitter + 1e-12);
        if (jitter > 0.0) share.push_back(offset / jitter + 0.5);
      }
      if (jitter > 0.0) BOOST_TEST(distance_from_uniform(share) < 1.95);
    }
  }
}

BOOST_AUTO_TEST_CASE(stratified_points_are_uniform_within_each_element) {
  const double h = 0.25;
  for (const int n : {1, 2, 5}) {
    const auto x = place_points(choice(Placement::stratified, 500, n), h, Phase::fluid).x;
    std::vector<double> within;
    for (int cell = 0; cell < 500; ++cell) {
      BOOST_TEST(count_in(x, cell * h, (cell + 1) * h) == static_cast<std::size_t>(n));
    }
    for (const double y : x) within.push_back(y / h - std::floor(y / h));
    BOOST_TEST(distance_from_uniform(within) < 1.95);
    // points of one element are independent of each other
    if (n == 1) continue;
    std::vector<double> first;
    std::vector<double> second;
    for (std::size_t p = 0; p < within.size(); p += static_cast<std::size_t>(n)) {
      first.push_back(within[p]);
      second.push_back(within[p + 1]);
    }
    BOOST_TEST(std::abs(correlation(first, second)) < 4.0);
    // Both in the lower half of their element: a quarter of them, standard deviation 0.02. None if
    // each had its own part of the element.
    double both_low = 0.0;
    for (std::size_t k = 0; k < first.size(); ++k) {
      both_low += first[k] < 0.5 && second[k] < 0.5 ? 1.0 : 0.0;
    }
    BOOST_TEST(std::abs(both_low / 500.0 - 0.25) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(random_points_are_uniform_over_the_column) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const Phase phase : {Phase::solid, Phase::fluid}) {
      auto x = place_points(choice(Placement::random, 50, 100, seed), 0.02, phase).x;
      BOOST_TEST(distance_from_uniform(x) < 2.7);
      // Counts in the 50 elements: chi-square of 49 degrees of freedom, mean 49, variance 98.
      // Five standard deviations to either side; points that are too even fail as well.
      double chi_square = 0.0;
      for (int cell = 0; cell < 50; ++cell) {
        const auto count = static_cast<double>(count_in(x, cell * 0.02, (cell + 1) * 0.02));
        chi_square += (count - 100.0) * (count - 100.0) / 100.0;
      }
      BOOST_TEST(std::abs(chi_square - 49.0) < 5.0 * std::sqrt(98.0));
    }
  }
}

BOOST_AUTO_TEST_CASE(random_points_leave_elements_empty) {
  // One point an element in the mean: a share of 1/e of the elements stays empty (0.368; standard
  // deviation 0.01 for 1000 elements).
  const auto x = place_points(choice(Placement::random, 1000, 1), 1.0, Phase::solid).x;
  std::vector<bool> filled(1000, false);
  for (const double y : x) filled[static_cast<std::size_t>(y)] = true;
  const auto empty = static_cast<double>(std::count(filled.begin(), filled.end(), false));
  BOOST_TEST(std::abs(empty / 1000.0 - std::exp(-1.0)) < 0.05);
}

BOOST_AUTO_TEST_CASE(empty_elements_have_no_points_and_the_others_are_untouched) {
  const double h = 0.1 / 101;
  for (const Placement placement : all_placements) {
    for (const int n : {1, 4}) {
      auto d = choice(placement, 101, n);
      const auto all = place_points(d, h, Phase::solid);
      d.empty_elements = {0.05, 0.0123, 0.05 + 0.1 * h};  // two of them in the same element
      const auto some = place_points(d, h, Phase::solid);
      std::vector<double> expected;
      for (const double x : all.x) {
        const double element = std::floor(x / h);
        if (element != 50.0 && element != std::floor(0.0123 / h)) expected.push_back(x);
      }
      BOOST_TEST_CONTEXT(name(placement)) {
        BOOST_TEST(some.x == expected, boost::test_tools::per_element());
        BOOST_TEST(some.x.size() < all.x.size());
        if (placement != Placement::random) {
          BOOST_TEST(std::abs(sum(some.volume) - 99 * h) < 1e-15);
        }
        for (const double volume : some.volume) BOOST_TEST(std::abs(volume - h / n) < 1e-18);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_boundary_of_elements_belongs_to_the_upper_one_and_the_end_to_the_last_one) {
  const double h = 0.25;
  const std::vector<std::pair<double, int>> cases{
      {0.0, 0}, {0.25, 1}, {0.5, 2}, {0.75, 3}, {1.0, 3}};
  for (const Placement placement : all_placements) {
    for (const auto& [x, element] : cases) {
      auto d = choice(placement, 4, 16);
      d.empty_elements = {x};
      const auto points = place_points(d, h, Phase::fluid);
      for (int cell = 0; cell < 4; ++cell) {
        BOOST_TEST((count_in(points.x, cell * h, (cell + 1) * h) == 0U) == (cell == element));
      }
    }
  }
}

// With h not exact in binary a boundary may go to either side, but always to exactly one.
BOOST_AUTO_TEST_CASE(one_place_empties_one_element) {
  for (const int elements : {57, 101, 1000}) {
    const double h = 0.07 / elements;
    for (int boundary = 0; boundary <= elements; ++boundary) {
      auto d = choice(Placement::uniform, elements, 1);
      d.empty_elements = {boundary * h};
      const auto x = place_points(d, h, Phase::solid).x;
      BOOST_TEST_REQUIRE(x.size() == static_cast<std::size_t>(elements - 1));
      const double low = std::max(boundary - 1, 0) * h;
      const double high = std::min(boundary + 1, elements) * h;
      const bool at_an_end = boundary == 0 || boundary == elements;
      BOOST_TEST(count_in(x, low, high) == (at_an_end ? 0U : 1U));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_points_and_another_one_independent_points) {
  for (const Placement placement :
       {Placement::jittered, Placement::stratified, Placement::random}) {
    const auto of = [&](std::uint64_t seed, Phase phase) {
      return place_points(choice(placement, 500, 2, seed), 1.0, phase).x;
    };
    const auto one = of(1, Phase::solid);
    // chance alone, without the regular part that all of them share
    const auto regular = placement == Placement::jittered
                             ? place_points(choice(Placement::uniform, 500, 2), 1.0, Phase::solid).x
                             : std::vector<double>(one.size(), 0.0);
    const auto chance = [&](std::vector<double> x) {
      for (std::size_t p = 0; p < x.size(); ++p) {
        x[p] -= placement == Placement::stratified ? std::floor(x[p]) : regular[p];
      }
      return x;
    };
    BOOST_TEST(of(1, Phase::solid) == one, boost::test_tools::per_element());
    const std::uint64_t high_bits = 1U + (std::uint64_t{1} << 32);
    for (const auto& other : {of(1, Phase::fluid), of(2, Phase::solid), of(2, Phase::fluid),
                              of(0, Phase::solid), of(high_bits, Phase::solid)}) {
      BOOST_TEST_CONTEXT(name(placement)) {
        BOOST_TEST_REQUIRE(other.size() == one.size());
        std::size_t equal = 0;
        for (std::size_t p = 0; p < one.size(); ++p) equal += one[p] == other[p] ? 1U : 0U;
        BOOST_TEST(equal == 0U);
        BOOST_TEST(std::abs(correlation(chance(one), chance(other))) < 4.0);
      }
    }
  }
}

// The stored results of a study must be repeatable on every machine, so the positions are pinned.
// The values were computed by an independent implementation of the two algorithms that the C++
// standard fixes to the bit, [rand.util.seedseq] and mersenne_twister_engine (mt19937_64): seeds
// are the words {1, 0, phase}, a position is the upper 53 bits of a word over 2^53.
BOOST_AUTO_TEST_CASE(positions_are_the_same_on_every_machine) {
  const auto d = choice(Placement::random, 1, 3, 1);
  const std::vector<double> solid{0.7584376338251628, 0.5739414192236835, 0.8479995005496104};
  const std::vector<double> fluid{0.4154621945505894, 0.5470964917284165, 0.04453422715670874};
  BOOST_TEST(place_points(d, 1.0, Phase::solid).x == solid, boost::test_tools::per_element());
  BOOST_TEST(place_points(d, 1.0, Phase::fluid).x == fluid, boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
