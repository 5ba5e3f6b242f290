#include "solver/moving/filled_grid.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

BOOST_AUTO_TEST_SUITE(filled_grid)

using namespace porowave::solver;

namespace {

constexpr double h = 0.25;

/// Ends on nodes, in the middle of cells, and with filled parts of 1e-12 h and less.
const std::vector<FilledGrid>& bodies() {
  static const std::vector<FilledGrid> all = [] {
    std::vector<FilledGrid> some;
    for (const double near : {-1.0, -1.0 + 1e-13, -1.0 - 1e-13, -0.87, 40.1}) {
      for (const double length : {1.0, 1.0 + 1e-13, 1.13, 1.25 - 1e-12}) {
        some.emplace_back(h, near, near + length);
      }
    }
    return some;
  }();
  return all;
}

std::vector<double> at_nodes(const FilledGrid& grid, double constant, double slope) {
  std::vector<double> values;
  for (long i = grid.first_node(); i <= grid.last_node(); ++i) {
    values.push_back(constant + slope * grid.node_position(i));
  }
  return values;
}

std::vector<double> in_cells(const FilledGrid& grid, double constant, double slope) {
  std::vector<double> values;
  for (long c = grid.first_cell(); c < grid.last_node(); ++c) {
    values.push_back(constant + slope * grid.filled_middle(c));
  }
  return values;
}

double work(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_filled_parts_make_up_the_body) {
  for (const FilledGrid& grid : bodies()) {
    double length = 0.0;
    for (long c = grid.first_cell(); c < grid.last_node(); ++c) {
      BOOST_TEST(grid.filled_length(c) > 0.0);
      BOOST_TEST(grid.filled_length(c) <= h * (1.0 + 1e-12));
      length += grid.filled_length(c);
    }
    BOOST_TEST(std::abs(length - (grid.far() - grid.near())) < 1e-13);
    BOOST_TEST(grid.node_position(grid.first_inner()) >= grid.near());
    BOOST_TEST(grid.node_position(grid.last_inner()) <= grid.far());
    BOOST_TEST(grid.first_inner() - grid.first_node() <= 1);
    BOOST_TEST(grid.last_node() - grid.last_inner() <= 1);
  }
}

BOOST_AUTO_TEST_CASE(volumes_are_those_of_the_body_and_never_small) {
  for (const FilledGrid& grid : bodies()) {
    const std::vector<double> volume = grid.nodal_volume();
    const double length = grid.far() - grid.near();
    BOOST_TEST(std::abs(work(volume, at_nodes(grid, 1.0, 0.0)) - length) < 1e-13);
    // ∫ x dx: linear functions are integrated exactly.
    BOOST_TEST(std::abs(work(volume, at_nodes(grid, 0.0, 1.0)) -
                        0.5 * length * (grid.far() + grid.near())) < 1e-11);
    for (long i = grid.first_node(); i <= grid.last_node(); ++i) {
      const double v = volume[static_cast<std::size_t>(i - grid.first_node())];
      const bool inner = i >= grid.first_inner() && i <= grid.last_inner();
      BOOST_TEST((inner ? v > 0.49 * h : v == 0.0));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_uniform_stress_held_by_its_ends_pushes_nothing) {
  for (const FilledGrid& grid : bodies()) {
    std::vector<double> force(grid.node_count(), 0.0);
    grid.internal_force(in_cells(grid, 7.0, 0.0), 7.0, 7.0, force);
    for (const double f : force) BOOST_TEST(std::abs(f) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(forces_do_the_work_of_the_stress) {
  // Σ v_i f_i = ∫ v ∂σ/∂x dx for constant and linear v and linear σ.
  for (const FilledGrid& grid : bodies()) {
    const double slope = 3.0;
    std::vector<double> force(grid.node_count(), 0.0);
    grid.internal_force(in_cells(grid, 7.0, slope), 7.0 + slope * grid.near(),
                        7.0 + slope * grid.far(), force);
    const double length = grid.far() - grid.near();
    BOOST_TEST(std::abs(work(force, at_nodes(grid, 1.0, 0.0)) - slope * length) < 1e-10);
    BOOST_TEST(std::abs(work(force, at_nodes(grid, 0.0, 1.0)) -
                        slope * 0.5 * length * (grid.far() + grid.near())) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(outer_nodes_continue_the_line_of_the_inner_ones) {
  for (const FilledGrid& grid : bodies()) {
    const std::vector<double> line = at_nodes(grid, 2.0, -3.0);
    std::vector<double> field = line;
    if (grid.first_node() < grid.first_inner()) field.front() = 99.0;
    if (grid.last_node() > grid.last_inner()) field.back() = 99.0;
    grid.extend(field);
    for (std::size_t k = 0; k < line.size(); ++k) BOOST_TEST(std::abs(field[k] - line[k]) < 1e-12);
    for (const double x : {grid.near(), grid.near() + 0.4, grid.far()}) {
      BOOST_TEST(std::abs(grid.value(field, x) - (2.0 - 3.0 * x)) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(bodies_that_are_none_are_refused) {
  BOOST_CHECK_THROW(FilledGrid(0.0, 0.0, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW(FilledGrid(h, 1.0, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW(FilledGrid(h, 0.0, std::nan("")), std::invalid_argument);
  BOOST_CHECK_THROW(FilledGrid(h, 0.01, 0.74), std::invalid_argument);  // two nodes inside
  BOOST_CHECK_NO_THROW(FilledGrid(h, 0.01, 0.76));
}

BOOST_AUTO_TEST_SUITE_END()
