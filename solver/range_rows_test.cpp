#include "solver/range_rows.hpp"

#include <boost/test/unit_test.hpp>
#include <utility>

#include "solver/transfer_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(range_rows)

using namespace porowave::solver;

namespace {

// `widest` columns at most a row, every third one missing if there are gaps; some rows empty.
SparseRows rows_with(std::size_t widest, bool gaps) {
  SparseRows rows;
  rows.column_count = 100;
  const auto values = test::noise(10'000, 3);
  for (std::size_t r = 0; r < 60; ++r) {
    for (std::size_t k = 0; k < r % (widest + 1); ++k) {
      if (gaps && k % 3 == 1) continue;
      rows.columns.push_back(static_cast<std::int32_t>(r + k));
      rows.values.push_back(values[rows.values.size()]);
    }
    rows.row_offsets.push_back(rows.columns.size());
  }
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_CASE(products_are_those_of_the_sparse_rows) {
  const auto in = test::noise(100, 5);
  for (const bool gaps : {false, true}) {
    for (const std::size_t widest : {1u, 3u, 4u, 17u, 40u}) {
      SparseRows sparse = rows_with(widest, gaps);
      std::vector<double> expected(60);
      multiply(sparse, in, expected);
      const RangeRows rows = porowave::solver::range_rows(std::move(sparse));
      std::vector<double> found(60);
      multiply(rows, {0, 60}, in.data(), found.data());
      BOOST_TEST(test::largest_difference(found, expected) < 1e-14);
      // A part of the rows gives the same bits.
      std::vector<double> part(20);
      multiply(rows, {25, 45}, in.data(), part.data());
      for (std::size_t k = 0; k < part.size(); ++k) BOOST_TEST(part[k] == found[25 + k]);
    }
  }
}

BOOST_AUTO_TEST_CASE(columns_of_a_row) {
  const RangeRows rows = porowave::solver::range_rows(rows_with(4, false));
  BOOST_TEST(rows.row_count() == 60u);
  BOOST_TEST(rows.columns(3).first == 3u);
  BOOST_TEST(rows.columns(3).last == 6u);
  BOOST_TEST(rows.columns(5).size() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
