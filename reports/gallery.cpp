// porowave-gallery DIRECTORY [NAME...]: draws the pictures of the READMEs from what it computes
// now, all or those named, and prints what the solver's methods cost.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reports/output_file.hpp"
#include "reports/reference_figures.hpp"
#include "reports/solver_figures.hpp"
#include "solver/case.hpp"

namespace {

using namespace porowave;
using Directory = std::filesystem::path;

/// The smooth load on the paper's column with uniform points, where every method converges.
solver::Case papers_column() {
  solver::Case scene;
  scene.problem.material = {0.4, 2650.0, 1000.0, 5.0e9, 2.2e9, 1.0e-11, 1.0e-3};
  scene.problem.column = {0.1, NearEnd::drained_traction, FarEnd::rigid_sealed};
  scene.problem.load = Load(LoadShape::smooth_ramp, 1.0, 1e-5);
  scene.time.end = 4e-5;
  return scene;
}

/// What the methods whose names begin with a word cost.
std::vector<verification::WorkPrecision> family(
    const std::vector<verification::WorkPrecision>& measured, std::string_view word) {
  std::vector<verification::WorkPrecision> members;
  std::copy_if(measured.begin(), measured.end(), std::back_inserter(members),
               [&](const auto& m) { return m.method.name.starts_with(word); });
  return members;
}

/// The figure; beside it the table, of which the best of every error level is printed, among all
/// methods and within every family.
reports::Figure solver_work_precision(const Directory& directory) {
  constexpr std::array<int, 5> elements = {50, 100, 200, 400, 800};
  constexpr int repetitions = 5;
  constexpr std::array<double, 8> levels = {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5};
  const auto measured =
      verification::measure(verification::every_method(papers_column()), elements, repetitions);
  const Directory table = directory / "solver_work_precision.csv";
  reports::write_file(
      table, [&](std::ostream& out) { verification::write_work_precision_csv(measured, out); });
  for (const char* word : {"", "shape", "apic", "mls", "staggered4"}) {
    fmt::print("{}\n", verification::best_of_levels(family(measured, word), levels));
  }
  fmt::print("wrote {}\n", table.string());
  return reports::solver_work_precision(measured);
}

const std::map<std::string, std::function<reports::Figure(const Directory&)>> figures = {
    {"reference_contours", [](const Directory&) { return reports::reference_contours(); }},
    {"reference_work_precision",
     [](const Directory&) { return reports::reference_work_precision(); }},
    {"solver_work_precision", solver_work_precision}};

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  std::vector<std::string> names(arguments.empty() ? arguments.end() : arguments.begin() + 1,
                                 arguments.end());
  for (const std::string& name : names) {
    if (figures.count(name) == 0) {
      fmt::print(stderr, "porowave-gallery: there is no figure {}\n", name);
      return 2;
    }
  }
  if (arguments.empty()) {
    fmt::print(stderr, "porowave-gallery: expected a directory, and names of figures or none\n");
    return 2;
  }
  if (names.empty()) {
    for (const auto& [name, make] : figures) names.push_back(name);
  }
  try {
    reports::require_gnuplot();
    std::filesystem::create_directories(arguments.front());
    for (const std::string& name : names) {
      for (const auto& path :
           reports::draw(figures.at(name)(arguments.front()), arguments.front())) {
        fmt::print("wrote {}\n", path.string());
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "porowave-gallery: {}\n", error.what());
    return 5;
  }
  return 0;
}
