// porowave-gallery DIRECTORY [NAME...]: draws the pictures of the READMEs from what it computes
// now, all or those named, and prints what the solver's methods cost.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reports/demo.hpp"
#include "reports/history_figures.hpp"
#include "reports/output_file.hpp"
#include "reports/reference_figures.hpp"
#include "reports/solver_figures.hpp"
#include "reports/stability_map_figure.hpp"
#include "reports/wave_figures.hpp"
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

/// A smooth wave meets an empty element in the middle, with the support enlarged there.
const reports::RunHistory& past_the_gap() {
  static const reports::RunHistory history = [] {
    solver::Case scene = papers_column();
    scene.problem.load = Load(LoadShape::smooth_ramp, 1.0, 4e-6);
    scene.discretization.elements = 201;
    scene.discretization.placement = solver::Placement::stratified;
    scene.discretization.adaptive_support = true;
    scene.discretization.empty_elements = {0.05};
    scene.time.end = 8e-5;
    return reports::run_history(scene, 160);
  }();
  return history;
}

verification::Method method(const std::string& name, const std::string& kernel,
                            solver::Scheme scheme, solver::Placement placement) {
  solver::Case scene = papers_column();
  scene.discretization.elements = 200;
  scene.discretization.placement = placement;
  scene.discretization.kernel = solver::kernel_from_name(kernel).value();
  scene.discretization.support_radius = solver::natural_radius(scene.discretization.kernel);
  scene.discretization.scheme = scheme;
  if (scheme == solver::Scheme::staggered4) scene.discretization.basis_order = 3;
  return {name, scene};
}

std::vector<verification::Method> compared_methods(solver::Placement placement) {
  using solver::Scheme;
  return {method("mls, bspline1", "bspline1", Scheme::galerkin, placement),
          method("mls, bspline2", "bspline2", Scheme::galerkin, placement),
          method("mls, wendland_c2", "wendland_c2", Scheme::galerkin, placement),
          method("staggered4", "bspline2", Scheme::staggered4, placement)};
}

reports::Figure stability_map(const Directory& directory) {
  const auto study =
      verification::load_study(POROWAVE_SOURCE_DIR "/verification/studies/stability_map.toml");
  const auto map = verification::stability_map(study, {});
  reports::write_file(directory / "stability_map.csv",
                      [&](std::ostream& out) { verification::write_map_csv(study, map, out); });
  return reports::stability_map_figure(study, map);
}

using Files = std::vector<std::filesystem::path>;

Files draw_one(const reports::Figure& figure, const Directory& directory) {
  return reports::draw(figure, directory);
}

const std::map<std::string, std::function<Files(const Directory&)>> figures = {
    {"paper", [](const Directory& to) { return reports::run_demo(to); }},
    {"dispersion",
     [](const Directory& to) {
       return draw_one(
           reports::dispersion_figure(
               "dispersion",
               "Waves of the scheme against the exact ones, uniform points, courant 0.5",
               compared_methods(solver::Placement::uniform)),
           to);
     }},
    {"error_spectrum",
     [](const Directory& to) {
       return draw_one(reports::error_spectrum_figure(
                           "error_spectrum",
                           "Smooth load, stratified points, 200 cells: where the error stands",
                           compared_methods(solver::Placement::stratified)),
                       to);
     }},
    {"space_time",
     [](const Directory& to) {
       return draw_one(reports::space_time_figure(
                           "space_time", "The wave passes an empty element under adaptive support",
                           past_the_gap()),
                       to);
     }},
    {"wave_past_the_gap",
     [](const Directory& to) {
       return draw_one(
           reports::animation_figure("wave_past_the_gap",
                                     "The wave passes an empty element under adaptive support",
                                     past_the_gap()),
           to);
     }},
    {"stability_map", [](const Directory& to) { return draw_one(stability_map(to), to); }},
    {"reference_contours",
     [](const Directory& to) { return draw_one(reports::reference_contours(), to); }},
    {"reference_work_precision",
     [](const Directory& to) { return draw_one(reports::reference_work_precision(), to); }},
    {"solver_work_precision",
     [](const Directory& to) { return draw_one(solver_work_precision(to), to); }}};

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("The project's own figures: porowave-gallery DIRECTORY [NAME...]");
  std::string directory;
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const auto& [name, make] : figures) known.insert(name);
  program.add_option("directory", directory, "Where they are written; made if absent")->required();
  program.add_option("names", names, "Which ones; all if absent")->check(CLI::IsMember(known));
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  if (names.empty()) names.assign(known.begin(), known.end());
  try {
    reports::require_gnuplot();
    std::filesystem::create_directories(directory);
    for (const std::string& name : names) {
      for (const auto& path : figures.at(name)(directory)) {
        fmt::print("wrote {}\n", path.string());
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "porowave-gallery: {}\n", error.what());
    return 5;
  }
  return 0;
}
