#include "reports/demo.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/problem/errors.hpp"
#include "reports/figures.hpp"
#include "reports/output_file.hpp"
#include "reports/progress.hpp"
#include "verification/run.hpp"

namespace porowave::reports {

namespace {

using solver::Case;
using solver::Placement;

/// The paper's column; its material values are typical of the published benchmark.
Problem papers_column(const Load& load) {
  const Material material{0.4, 2650.0, 1000.0, 5.0e9, 2.2e9, 1.0e-11, 1.0e-3};
  return {material, {0.1, NearEnd::drained_traction, FarEnd::rigid_sealed}, load};
}

template <class Kernel>
Case papers_case(double support_radius, int basis_order, double end, const Load& load) {
  Case scene;
  scene.problem = papers_column(load);
  scene.discretization.kernel = solver::kernel_name<Kernel>;
  scene.discretization.support_radius = support_radius;
  scene.discretization.basis_order = basis_order;
  scene.time.end = end;
  return scene;
}

struct PlannedRow {
  std::string title;
  Case scene;
};

struct PlannedFigure {
  std::string name;
  std::string caption;
  std::vector<PlannedRow> rows;
};

/// Random points, several weightings, the same polynomial basis (order 1) for all.
PlannedFigure figure_3() {
  PlannedFigure figure{"figure3_random_points",
                       "Randomly distributed points, four weightings, t = 4e-5 s: the linear one "
                       "oscillates most",
                       {}};
  const auto add = [&]<class Kernel>(Kernel, double radius) {
    Case scene = papers_case<Kernel>(radius, 1, 4e-5, Load(LoadShape::step, 1.0));
    scene.discretization.placement = Placement::random;
    figure.rows.push_back({fmt::format("{}, support radius {} h", Kernel::name, radius), scene});
  };
  add(solver::BSpline1{}, 1.0);
  add(solver::BSpline2{}, 1.5);
  add(solver::BSpline3{}, 2.0);
  add(solver::WendlandC2{}, 2.0);
  return figure;
}

/// The empty element at x = 0.05 m, at four times.
template <class Kernel>
PlannedFigure gap_figure(const std::string& name, const std::string& caption, double radius,
                         int points_per_element) {
  PlannedFigure figure{name, caption, {}};
  for (const double t : {1e-5, 2e-5, 3e-5, 4e-5}) {
    Case scene = papers_case<Kernel>(radius, 1, t, Load(LoadShape::step, 1.0));
    scene.discretization.elements = 101;  // the gap lies in the middle of one element
    scene.discretization.points_per_element = points_per_element;
    scene.discretization.empty_elements = {0.05};
    figure.rows.push_back({fmt::format("t = {:.0e} s", t), scene});
  }
  return figure;
}

std::vector<PlannedFigure> profile_figures() {
  return {figure_3(),
          gap_figure<solver::BSpline1>("figure4_gap_linear",
                                       "Linear B-spline, one point per cell: the empty element "
                                       "reflects the wave completely",
                                       1.0, 1),
          gap_figure<solver::WendlandC2>("figure5_gap_wendland",
                                         "Wendland C2, support of 10 elements: the wave passes the "
                                         "empty element",
                                         5.0, 4)};
}

struct PlannedCurve {
  std::string title;
  Case scene;
  int seeds;
};

constexpr std::array<int, 4> levels = {100, 200, 400, 800};

std::vector<PlannedCurve> convergence_curves() {
  constexpr int seeds = 5;
  const Load load(LoadShape::smooth_ramp, 1.0, 1e-5);
  std::vector<PlannedCurve> curves;
  const auto add = [&]<class Kernel>(Kernel, Placement placement, int count) {
    Case scene = papers_case<Kernel>(Kernel::natural_radius, 1, 4e-5, load);
    scene.discretization.placement = placement;
    curves.push_back({fmt::format("{}, {}", Kernel::name, name(placement)), scene, count});
  };
  add(solver::BSpline1{}, Placement::uniform, 1);
  add(solver::BSpline1{}, Placement::stratified, seeds);
  add(solver::BSpline2{}, Placement::stratified, seeds);
  add(solver::WendlandC2{}, Placement::stratified, seeds);
  return curves;
}

constexpr const char* table_header =
    "study,title,kernel,support_radius,basis_order,placement,seed,elements,points_per_element,end,"
    "effective_stress_l2_points,effective_stress_l2_field,pore_pressure_l2_points,"
    "pore_pressure_l2_field,solid_velocity_l2_points,solid_velocity_l2_field,"
    "fluid_velocity_l2_points,fluid_velocity_l2_field,steps,cpu_seconds,ns_per_point_step\n";

std::string table_row(const std::string& study, const std::string& title, const Case& scene,
                      const verification::RunResult& run) {
  const auto& d = scene.discretization;
  std::string row = fmt::format(
      "{},\"{}\",{},{},{},{},{},{},{},{}", study, title, to_string(d.kernel), d.support_radius,
      d.basis_order, name(d.placement), d.seed, d.elements, d.points_per_element, scene.time.end);
  for (const auto& error : run.errors) {
    row += fmt::format(",{:.6e},{:.6e}", error.points.l2, error.field.l2);
  }
  return row + fmt::format(",{},{:.4e},{:.2f}\n", run.steps, run.cost.cpu_seconds,
                           run.cost.ns_per_point_step);
}

/// A run of the demo that breaks down is a defect of the program, not a point of a figure.
verification::RunResult run_soundly(const Case& scene, const reference::Profile& profile) {
  auto run = verification::run_case(scene, profile);
  if (run.breakdown) throw BreakdownError("demo: " + run.breakdown->reason);
  return run;
}

void append(std::vector<std::filesystem::path>& files, std::vector<std::filesystem::path> more) {
  files.insert(files.end(), more.begin(), more.end());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One curve: at each level the median over the seeds; every run goes to the table.
ConvergenceCurve run_curve(const PlannedCurve& planned, std::string& table, Progress& progress) {
  ConvergenceCurve curve{planned.title, {}};
  const auto profile = verification::reference_profile(planned.scene);
  for (const int elements : levels) {
    std::vector<double> errors;
    std::vector<double> seconds;
    for (int seed = 1; seed <= planned.seeds; ++seed) {
      Case scene = planned.scene;
      scene.discretization.elements = elements;
      scene.discretization.seed = static_cast<std::uint64_t>(seed);
      const auto run = run_soundly(scene, *profile);
      errors.push_back(run.errors[0].field.l2);
      seconds.push_back(run.cost.cpu_seconds);
      table += table_row("convergence", planned.title, scene, run);
      progress.done_one();
    }
    curve.levels.push_back({elements, *planned.scene.problem.column.length / elements,
                            median(errors), median(seconds)});
  }
  return curve;
}

}  // namespace

std::vector<std::filesystem::path> run_demo(const std::filesystem::path& directory) {
  require_gnuplot();
  make_output_directory(directory);
  const auto figures = profile_figures();
  const auto curves = convergence_curves();
  std::size_t total = 0;
  for (const auto& figure : figures) total += figure.rows.size();
  for (const auto& curve : curves) total += levels.size() * static_cast<std::size_t>(curve.seeds);
  Progress progress("porowave demo", static_cast<int>(total));

  std::vector<std::filesystem::path> files;
  std::string table = table_header;
  for (const PlannedFigure& planned : figures) {
    std::vector<ProfileRow> rows;
    for (const PlannedRow& row : planned.rows) {
      const auto profile = verification::reference_profile(row.scene);
      const auto run = run_soundly(row.scene, *profile);
      rows.push_back({row.title, row.scene, run.snapshot});
      table += table_row(planned.name, row.title, row.scene, run);
      progress.done_one();
    }
    append(files, draw(profile_figure(planned.name, planned.caption, rows), directory));
  }
  std::vector<ConvergenceCurve> results;
  for (const PlannedCurve& planned : curves) {
    results.push_back(run_curve(planned, table, progress));
  }
  append(files,
         draw(convergence_figure("convergence",
                                 "Smooth load, basis order 1, 4 + 4 points per cell, t = 4e-5 s "
                                 "(median over seeds)",
                                 results),
              directory));
  files.push_back(directory / "runs.csv");
  write_file(files.back(), table);
  return files;
}

}  // namespace porowave::reports
