#include "solver/staggered/band_matrix.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(band_matrix)

namespace {

// A random matrix, mostly near the diagonals, in both forms.
struct Both {
  BandMatrix band;
  std::vector<std::vector<double>> full;
};

Both random_matrix(std::size_t rows, std::size_t columns, std::size_t shift,
                   std::size_t half_width) {
  Both m{BandMatrix(rows, columns, shift, half_width),
         std::vector<std::vector<double>>(rows, std::vector<double>(columns, 0.0))};
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::uniform_int_distribution<int> offset(-8, 8);
  for (std::size_t r = 0; r < rows; ++r) {
    for (int k = 0; k < 12; ++k) {
      const int c = static_cast<int>(r + shift) + offset(generator);
      if (c < 0 || c >= static_cast<int>(columns)) continue;
      const double a = value(generator);
      m.band.add(r, static_cast<std::size_t>(c), a);
      m.full[r][static_cast<std::size_t>(c)] += a;
    }
  }
  return m;
}

BOOST_AUTO_TEST_CASE(it_multiplies_like_the_full_matrix) {
  for (const std::size_t half_width : {2u, 3u, 4u, 5u}) {
    for (const auto& [rows, columns, shift] :
         {std::tuple{40u, 40u, 0u}, std::tuple{40u, 42u, 1u}, std::tuple{5u, 5u, 0u},
          std::tuple{3u, 3u, 0u}, std::tuple{8u, 10u, 1u}}) {
      const Both m = random_matrix(rows, columns, shift, half_width);
      std::vector<double> in;
      for (std::size_t c = 0; c < columns; ++c) in.push_back(std::cos(static_cast<double>(c)));
      for (std::size_t end = 0; end <= rows + 1; ++end) {
        std::vector<double> out(rows, 99.0);
        m.band.multiply(in, out, end);
        for (std::size_t r = 0; r < rows; ++r) {
          double expected = 0.0;
          for (std::size_t c = 0; c < columns; ++c) expected += m.full[r][c] * in[c];
          BOOST_TEST(std::abs(out[r] - (r < end ? expected : 99.0)) < 1e-13);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(only_what_leaves_the_diagonals_is_stray) {
  BandMatrix m(20, 20, 0, 2);
  for (std::size_t r = 2; r < 18; ++r) {
    for (std::size_t c = r - 2; c <= r + 2; ++c) m.add(r, c, 1.0);
  }
  BOOST_TEST(m.strays() == 0u);
  m.add(10, 13, 1.0);
  m.add(10, 13, 1.0);
  m.add(0, 0, 1.0);
  BOOST_TEST(m.strays() == 2u);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_refused) {
  BOOST_CHECK_THROW(BandMatrix(4, 4, 0, 1), std::invalid_argument);
  BOOST_CHECK_THROW(BandMatrix(4, 4, 0, 6), std::invalid_argument);
  BandMatrix m(4, 5, 0, 2);
  BOOST_CHECK_THROW(m.add(4, 0, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW(m.add(0, 5, 1.0), std::invalid_argument);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
