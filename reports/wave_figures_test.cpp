#include "reports/wave_figures.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "reference/problem/problem_fixtures.hpp"
#include "reports/test_pictures.hpp"
#include "verification/run.hpp"

BOOST_AUTO_TEST_SUITE(wave_figures)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;

namespace {

std::vector<verification::Method> methods(solver::Placement placement) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem();
  scene.problem.load = Load(LoadShape::smooth_ramp, 1.0, 1e-5);
  scene.discretization.elements = 50;
  scene.discretization.placement = placement;
  scene.time.end = 3e-5;
  verification::Method hat{"<hat> \"1\"", scene};
  hat.scene.discretization.kernel = solver::kernel_name<solver::BSpline1>;
  hat.scene.discretization.support_radius = 1.0;
  return {hat, {"quadratic's", scene}};
}

std::vector<std::vector<double>> rows_of(const std::string& data) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(data);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<double> row;
    std::istringstream words(line);
    for (std::string word; words >> word;) row.push_back(std::stod(word));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_CASE(waves_of_many_cells_are_right) {
  const Figure figure =
      dispersion_figure("dispersion", "caption", methods(solver::Placement::uniform));
  const auto rows = rows_of(figure.data);
  BOOST_TEST_REQUIRE(rows.size() == 2u * 161u);
  BOOST_TEST(rows[0][0] == 2.5);
  BOOST_TEST(rows[160][0] == 100.0);
  for (const std::size_t last : {160u, 321u}) {
    BOOST_TEST(std::abs(rows[last][1]) < 1e-3);
    BOOST_TEST(std::abs(rows[last][1]) < std::abs(rows[last - 80][1]));
  }
  const TestDirectory folder;
  draw(figure, folder.path());
  check_pictures(folder.path(), "dispersion");
}

// Parseval: the amplitudes of the error are those of its L2 norm.
BOOST_AUTO_TEST_CASE(amplitudes_add_up_to_the_error) {
  const auto all = methods(solver::Placement::stratified);
  const Figure figure = error_spectrum_figure("spectrum", "caption", all);
  const auto rows = rows_of(figure.data);
  BOOST_TEST_REQUIRE(rows.size() == 2u * 49u);
  const auto profile = verification::reference_profile(all[0].scene);
  const auto run = verification::run_case(all[0].scene, *profile);
  double squares = 0.0, mean = 0.0;
  for (std::size_t c = 0; c < 50; ++c) {
    const double error =
        run.snapshot.effective_stress[c] - profile->at(run.snapshot.cell_x[c]).effective_stress;
    squares += error * error / 50.0;
    mean += error / 50.0;
  }
  double amplitudes = mean * mean;
  for (std::size_t k = 0; k < 49; ++k) amplitudes += 0.5 * rows[k][2] * rows[k][2];
  BOOST_TEST(amplitudes == squares, boost::test_tools::tolerance(1e-4));
  const TestDirectory folder;
  draw(figure, folder.path());
  check_pictures(folder.path(), "spectrum");
}

// cos(pi k x/L) at the middles of n cells is one wave of 2 n/k cells.
BOOST_AUTO_TEST_CASE(half_of_the_error_of_two_cosines) {
  constexpr int n = 64;
  const auto panel_of = [](double mean, double of_long, double of_short) {
    SpectrumPanel panel{"two", std::vector<double>(n, 0.0), {}};
    for (int c = 0; c < n; ++c) {
      const double x = (c + 0.5) / n;
      panel.error.push_back(mean + of_long * std::cos(8.0 * std::numbers::pi * x) +
                            of_short * std::cos(32.0 * std::numbers::pi * x));
    }
    return panel;
  };
  BOOST_TEST(median_wavelength(panel_of(0.0, 1.1, 1.0)) == 16.0);
  BOOST_TEST(median_wavelength(panel_of(0.0, 0.9, 1.0)) == 4.0);
  // The mean counts twice as much as a wave of its amplitude, which is half of the time smaller.
  BOOST_TEST(median_wavelength(panel_of(0.7, 1.05, 1.0)) == 16.0);
  BOOST_TEST(std::isinf(median_wavelength(panel_of(2.0, 1.0, 1.0))));
  BOOST_TEST(std::isnan(median_wavelength(panel_of(0.0, 0.0, 0.0))));
}

BOOST_AUTO_TEST_SUITE_END()
