#include "reports/reference_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>

#include "reference/bromwich.hpp"
#include "reference/explanation.hpp"
#include "reference/modal.hpp"
#include "reports/contour_figure.hpp"

namespace porowave::reports {

namespace {

using reference::BoundedFields;
using reference::ColumnSolution;

constexpr double time_shown = 4e-5;

Problem column(double permeability, const Load& load) {
  const Material material{0.4, 2650.0, 1000.0, 5.0e9, 2.2e9, permeability, 1.0e-3};
  return {material, {0.1, NearEnd::drained_traction, FarEnd::rigid_sealed}, load};
}

/// A softer skeleton, whose undrained front lies well behind the frozen one.
Problem soft_column(double permeability) {
  Problem problem = column(permeability, Load(LoadShape::step, 1.0));
  problem.material.constrained_modulus = 2.0e8;
  problem.material.grain_density = 4000.0;
  return problem;
}

struct Sample {
  double microseconds;
  double error;
};

std::vector<double> places() {
  std::vector<double> x;
  for (int i = 0; i < 24; ++i) x.push_back(0.003 + 0.0038 * i);
  return x;
}

double largest_share(const Problem& problem, const Fields& a, const Fields& b) {
  const double stress = problem.stress_scale();
  const double velocity = problem.velocity_scale();
  return std::max({std::abs(a.effective_stress - b.effective_stress) / stress,
                   std::abs(a.pore_pressure - b.pore_pressure) / stress,
                   std::abs(a.solid_velocity - b.solid_velocity) / velocity,
                   std::abs(a.fluid_velocity - b.fluid_velocity) / velocity});
}

/// Repeats work that is too short to time.
double microseconds_of(const std::function<void()>& work) {
  constexpr double shortest = 2e-3 * CLOCKS_PER_SEC;
  long repeats = 0;
  const std::clock_t start = std::clock();
  do {
    work();
    ++repeats;
  } while (static_cast<double>(std::clock() - start) < shortest);
  return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC /
         static_cast<double>(repeats);
}

/// A route that gives values at x, against the exact ones.
Sample measured(const Problem& problem, const std::vector<Fields>& exact,
                const std::function<Fields(double)>& value) {
  const auto x = places();
  std::vector<Fields> found(x.size());
  const double time = microseconds_of([&] {
    for (std::size_t i = 0; i < x.size(); ++i) found[i] = value(x[i]);
  });
  double worst = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    worst = std::max(worst, largest_share(problem, found[i], exact[i]));
  }
  return {time / static_cast<double>(x.size()), worst};
}

/// The contour route with the nodes of level 1, 2, ... only: its time without the last doublings.
std::vector<Sample> contour_samples(const ColumnSolution& solution,
                                    const std::vector<Fields>& exact) {
  std::vector<Sample> samples;
  const auto x = places();
  const Sample full = measured(solution.problem(), exact,
                               [&](double place) { return solution.at(place, time_shown).value; });
  for (std::size_t level = 1; level <= 5; ++level) {
    double worst = 0.0;
    double nodes = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      reference::FourSums sum{};
      for (const auto& group : reference::explain(solution, x[i], time_shown)) {
        if (group.by_level.size() <= level) continue;
        for (std::size_t f = 0; f < 4; ++f) sum[f] += group.by_level[level][f];
        nodes += static_cast<double>(group.nodes_by_level[level]);
        all += static_cast<double>(group.nodes_by_level[4]);
      }
      worst = std::max(
          worst, largest_share(solution.problem(), {sum[0], sum[1], sum[2], sum[3]}, exact[i]));
    }
    samples.push_back({full.microseconds * nodes / std::max(all, 1.0), worst});
  }
  return samples;
}

std::vector<Sample> bromwich_samples(const Problem& problem, const std::vector<Fields>& exact) {
  std::vector<Sample> samples;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const reference::BromwichSolution route(problem, tolerance);
    const Sample sample =
        measured(problem, exact, [&](double x) { return route.at(x, time_shown).value; });
    if (std::isfinite(sample.error)) samples.push_back(sample);
  }
  return samples;
}

std::vector<Sample> modal_samples(const Problem& problem, const std::vector<Fields>& exact) {
  std::vector<Sample> samples;
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-12}) {
    const auto x = places();
    std::vector<Fields> found(x.size());
    // A profile is the unit of this route: its modes are found once for all points.
    const double time = microseconds_of([&] {
      const reference::ModalSolution route(problem, time_shown, tolerance);
      for (std::size_t i = 0; i < x.size(); ++i) found[i] = route.at(x[i]).value;
    });
    double worst = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      worst = std::max(worst, largest_share(problem, found[i], exact[i]));
    }
    samples.push_back({time / static_cast<double>(x.size()), worst});
  }
  return samples;
}

std::string block(const std::string& route, const std::vector<Sample>& samples) {
  std::string text =
      fmt::format("# {}: microseconds a value, error as a share of the load\n", route);
  for (const Sample& s : samples) text += fmt::format("{:.4g} {:.3g}\n", s.microseconds, s.error);
  return text + "\n\n";
}

}  // namespace

Figure reference_contours() {
  const double behind = 0.02;
  const Problem soft = soft_column(1.5e-13);
  const double front = soft.material.undrained_speed() * time_shown;
  return contour_figure(
      "reference_contours", "The s plane of three values: the contour follows the low integrand",
      {{"little drag", column(1e-11, Load(LoadShape::step, 1.0)), behind, time_shown},
       {"stiff drag, behind the undrained front", soft, behind, time_shown},
       {"stiff drag, at the undrained front", soft, front, time_shown}});
}

Figure reference_work_precision() {
  Figure figure{"reference_work_precision",
                "work_precision",
                {{"caption", "Three routes to the same values, smooth_ramp, paper's column"}},
                ""};
  int number = 0;
  double fastest = HUGE_VAL;
  double slowest = 0.0;
  for (const double permeability : {1e-11, 1e-13, 1e-15}) {
    const Problem problem = column(permeability, Load(LoadShape::smooth_ramp, 1.0, 1e-5));
    const ColumnSolution solution(problem);
    std::vector<Fields> exact;
    for (const double x : places()) exact.push_back(solution.at(x, time_shown).value);
    const std::vector<std::vector<Sample>> routes = {contour_samples(solution, exact),
                                                     bromwich_samples(problem, exact),
                                                     modal_samples(problem, exact)};
    const std::array<const char*, 3> names = {"contour", "bromwich", "modal"};
    for (std::size_t i = 0; i < routes.size(); ++i) {
      figure.data += block(names[i], routes[i]);
      for (const Sample& s : routes[i]) {
        fastest = std::min(fastest, s.microseconds);
        slowest = std::max(slowest, s.microseconds);
      }
    }
    figure.texts.emplace_back(
        fmt::format("title{}", ++number),
        fmt::format("drag rate × time = {:.2g}", problem.material.relaxation_rate() * time_shown));
  }
  figure.texts.emplace_back("panels", fmt::format("{}", number));
  figure.texts.emplace_back("fastest", fmt::format("{:#.3g}", 0.5 * fastest));
  figure.texts.emplace_back("slowest", fmt::format("{:#.3g}", 2.0 * slowest));
  return figure;
}

}  // namespace porowave::reports
