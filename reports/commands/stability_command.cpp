#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "reference/problem/errors.hpp"
#include "reference/problem/toml_document.hpp"
#include "reports/commands/commands.hpp"
#include "reports/output_file.hpp"
#include "reports/progress.hpp"
#include "reports/seed_figure.hpp"
#include "reports/stability_figures.hpp"
#include "reports/stability_map_figure.hpp"
#include "verification/stability/seed_distribution.hpp"
#include "verification/stability/stability_map.hpp"
#include "verification/stability/stability_output.hpp"

namespace porowave::reports {

namespace {

constexpr int verdict_fail = 1;

struct StabilityOptions {
  std::string scene;
  std::string output;
  double limit = solver::CriticalSettings{}.limit;
  double highest = solver::CriticalSettings{}.highest;
  int jobs = 0;
  bool check = false;

  solver::CriticalSettings settings() const {
    solver::CriticalSettings settings;
    settings.limit = limit;
    settings.highest = highest;
    return settings;
  }
};

void write_files(const verification::SceneStability& found, const StabilityOptions& options) {
  const std::filesystem::path directory = options.output;
  std::vector<std::filesystem::path> files = {directory / "growth.csv"};
  write_file(files[0], [&](std::ostream& out) { verification::write_growth_csv(found, out); });
  if (found.mode) {
    files.push_back(directory / "mode.csv");
    write_file(files[1],
               [&](std::ostream& out) { verification::write_mode_csv(*found.mode, out); });
  }
  const std::string caption =
      "Growth of noise in " + std::filesystem::path(options.scene).filename().string();
  for (const auto& file : draw(stability_figure(found, caption, options.limit), directory)) {
    files.push_back(file);
  }
  for (const auto& file : files) fmt::print("wrote {}\n", file.string());
}

void print_counts(const std::vector<verification::MappedStability>& map, double highest,
                  double seconds) {
  int refused = 0, unstable = 0, stable = 0, below = 0;
  for (const auto& one : map) {
    refused += one.refused.empty() ? 0 : 1;
    if (!one.refused.empty()) continue;
    unstable += one.critical.courant == 0.0 ? 1 : 0;
    stable += one.critical.unstable == 0.0 ? 1 : 0;
    below += one.critical.unstable_below().empty() ? 0 : 1;
  }
  fmt::print(
      "{} cases in {:.1f} s: {} stable up to courant {:g}, {} unstable at every step, {} with "
      "unstable steps below the critical one, {} refused\n",
      map.size(), seconds, stable, highest, unstable, below, refused);
}

/// What the map of a study with seeds becomes: their distribution.
void write_seeds(const verification::Study& study,
                 const std::vector<verification::MappedStability>& map,
                 const StabilityOptions& options) {
  const auto found = verification::seed_distributions(study, map);
  const auto table = std::filesystem::path(options.output) / "stability_seeds.csv";
  write_file(table, [&](std::ostream& out) { verification::write_seed_csv(study, found, out); });
  fmt::print("wrote {}\n", table.string());
  if (found.size() > most_seed_curves) {
    fmt::print(
        "no picture: {} combinations of the other axes, more than the {} curves that can be "
        "told apart\n",
        found.size(), most_seed_curves);
    return;
  }
  for (const auto& file : draw(seed_figure(study, found, options.highest), options.output)) {
    fmt::print("wrote {}\n", file.string());
  }
}

int run_map(const StabilityOptions& options) {
  if (options.output.empty() || options.check) {
    throw InputError("stability: a study needs --output DIR, and has no --check");
  }
  const verification::Study study = verification::load_study(options.scene);
  make_output_directory(options.output);
  require_gnuplot();
  Progress progress(study.name, static_cast<int>(study.cases.size()));
  const auto start = std::chrono::steady_clock::now();
  const auto map = verification::stability_map(study, options.settings(), options.jobs,
                                               [&](std::size_t) { progress.done_one(); });
  progress.end();
  print_counts(map, options.highest,
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  const auto table = std::filesystem::path(options.output) / "stability_map.csv";
  write_file(table, [&](std::ostream& out) { verification::write_map_csv(study, map, out); });
  fmt::print("wrote {}\n", table.string());
  if (study.seed && study.axes[*study.seed].values.size() > 1) {
    write_seeds(study, map, options);
    return 0;
  }
  for (const auto& file : draw(stability_map_figure(study, map), options.output)) {
    fmt::print("wrote {}\n", file.string());
  }
  return 0;
}

int run_case(const StabilityOptions& options) {
  const solver::Case scene = solver::load_case(options.scene);
  if (!options.output.empty()) {
    make_output_directory(options.output);
    require_gnuplot();
  }
  const auto settings = options.settings();
  // The scan, and some five steps to close in.
  const double scan = (settings.highest - settings.lowest) / settings.spacing;
  Progress progress("time steps", static_cast<int>(scan) + 6);
  const auto found = verification::scene_stability(scene, settings, [&] { progress.done_one(); });
  progress.end();
  fmt::print("{}", verification::stability_summary(found, options.limit));
  if (!options.output.empty()) write_files(found, options);
  return options.check && !found.stable(options.limit) ? verdict_fail : 0;
}

int run_stability(const StabilityOptions& options) {
  const bool study = TomlDocument::load(options.scene).section("axes").present();
  return study ? run_map(options) : run_case(options);
}

}  // namespace

void add_stability_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* command = program.add_subcommand(
      "stability",
      "Critical time step of a case and how fast noise grows at its own, or a map of a study");
  command->add_option("case", options->scene, "Case file (TOML), or a study")->required();
  command->add_option(
      "--output", options->output,
      "Directory for growth.csv, mode.csv (the fastest-growing mode against x) "
      "and a figure of both; of a study, stability_map.csv and a figure, with an axis of "
      "seeds stability_seeds.csv, the distribution over them");
  command
      ->add_option("--growth", options->limit,
                   "Growth a step from which on a time step counts as unstable (0.001: noise "
                   "grows tenfold in 2,300 steps)")
      ->check(CLI::Range(1e-6, 1.0));
  command
      ->add_option("--highest", options->highest,
                   "Largest Courant number of the search (1 is the largest of a case)")
      ->check(CLI::Range(0.05, 4.0));
  command->add_option("--jobs", options->jobs, "Cases of a study at a time; one a core if absent")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--check", options->check, "Exit code 1 if the case's own step is unstable");
  command->footer(
      "Growth is the largest eigenvalue (its modulus less 1) of one step of this case, with these\n"
      "points, ends and drag. The critical step is the largest stable one; with moving least\n"
      "squares some shorter ones may be unstable, which is said. A study gives a table and a "
      "picture\n"
      "of critical steps: porowave stability verification/studies/stability_map.toml --output map\n"
      "Example: porowave stability verification/studies/paper_case.toml --output stability");
  command->callback([options, &run] { run = [options] { return run_stability(*options); }; });
}

}  // namespace porowave::reports
