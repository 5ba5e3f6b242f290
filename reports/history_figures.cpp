#include "reports/history_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace porowave::reports {

namespace {

// More columns than pixels only make the picture heavy.
constexpr std::size_t most_cells_across = 250;

// Smaller errors have no colour of their own; the largest are at the fronts.
constexpr double least_error = 1e-6;

using Values = std::vector<std::pair<std::string, std::string>>;

// Numbers for gnuplot's real() keep their point (#): without one it cannot read "1e-05".
std::string real_text(double value) {
  return fmt::format("{:#.8g}", value);
}

double cell_length(const RunHistory& history) {
  return solver::ColumnSolver::grid_length(history.scene) / history.scene.discretization.elements;
}

/// Begin and end of every empty element, m.
std::string gap_text(const RunHistory& history) {
  const double h = cell_length(history);
  std::string text;
  for (const double inside : history.scene.discretization.empty_elements) {
    const double begin = h * std::floor(inside / h);
    text += real_text(begin) + " " + real_text(begin + h) + " ";
  }
  return text;
}

Values common_texts(const std::string& caption, const RunHistory& history) {
  return {{"caption", caption},
          {"x_end", real_text(solver::ColumnSolver::grid_length(history.scene))},
          {"t_end", real_text(history.frames.back().snapshot.time)},
          {"gaps", gap_text(history)}};
}

/// The largest size of a field of the reference over the load, at all frames; 1 at least.
template <class Member>
double largest(const RunHistory& history, Member field) {
  double found = history.scene.problem.stress_scale();
  for (const auto& frame : history.frames) {
    for (const Fields& fields : frame.reference) found = std::max(found, std::abs(fields.*field));
  }
  return found / history.scene.problem.stress_scale();
}

std::string way_block(const std::vector<Characteristic>& ways, bool fast) {
  std::string block = fmt::format("# {}: x (m), t (s)\n", fast ? "fast wave" : "slow wave");
  bool any = false;
  for (const Characteristic& way : ways) {
    if (way.fast != fast) continue;
    if (any) block += "\n";
    any = true;
    block += fmt::format("{:.8g} {:.8g}\n{:.8g} {:.8g}\n", way.x_begin, way.t_begin, way.x_end,
                         way.t_end);
  }
  return block;
}

std::string profile_block(const RunHistory::Frame& frame, double load) {
  std::string block = fmt::format(
      "# t = {:.6e} s: x (m), effective stress, pore pressure, both of the "
      "reference; over the load\n",
      frame.snapshot.time);
  for (std::size_t c = 0; c < frame.reference.size(); ++c) {
    block += fmt::format(
        "{:.8g} {:.6e} {:.6e} {:.6e} {:.6e}\n", frame.snapshot.cell_x[c],
        frame.snapshot.effective_stress[c] / load, frame.snapshot.pore_pressure[c] / load,
        frame.reference[c].effective_stress / load, frame.reference[c].pore_pressure / load);
  }
  return block;
}

std::string error_text(double value, double reference, double load) {
  return fmt::format("{:.4f}",
                     std::log10(std::max(std::abs(value - reference) / load, least_error)));
}

}  // namespace

Figure space_time_figure(const std::string& name, const std::string& caption,
                         const RunHistory& history) {
  const double load = history.scene.problem.stress_scale();
  Figure figure{name, "space_time", common_texts(caption, history), ""};
  figure.texts.emplace_back("stress_high", real_text(largest(history, &Fields::effective_stress)));
  figure.texts.emplace_back("pressure_high", real_text(largest(history, &Fields::pore_pressure)));
  figure.texts.emplace_back("error_low", real_text(std::log10(least_error)));
  figure.data =
      "# x (m), t (s), effective stress, pore pressure over the load, log10 of their errors over "
      "it\n";
  const std::size_t cells = history.frames.front().reference.size();
  const std::size_t stride = 1 + (cells - 1) / most_cells_across;
  for (const auto& frame : history.frames) {
    const solver::Snapshot& now = frame.snapshot;
    for (std::size_t c = stride / 2; c < cells; c += stride) {
      figure.data += fmt::format(
          "{:.8g} {:.8g} {:.4e} {:.4e} {} {}\n", now.cell_x[c], now.time,
          now.effective_stress[c] / load, now.pore_pressure[c] / load,
          error_text(now.effective_stress[c], frame.reference[c].effective_stress, load),
          error_text(now.pore_pressure[c], frame.reference[c].pore_pressure, load));
    }
    figure.data += "\n";
  }
  const auto ways = characteristics(history.scene.problem, history.frames.back().snapshot.time);
  for (const bool fast : {true, false}) figure.data += "\n" + way_block(ways, fast) + "\n";
  return figure;
}

Figure animation_figure(const std::string& name, const std::string& caption,
                        const RunHistory& history) {
  const double load = history.scene.problem.stress_scale();
  Figure figure{name, "animation", common_texts(caption, history), ""};
  figure.animated = true;
  figure.texts.emplace_back("high", real_text(std::max(largest(history, &Fields::effective_stress),
                                                       largest(history, &Fields::pore_pressure))));
  std::string times;
  for (const auto& frame : history.frames) {
    times += real_text(frame.snapshot.time) + " ";
    figure.data += (figure.data.empty() ? "" : "\n\n") + profile_block(frame, load);
  }
  figure.texts.emplace_back("times", times);
  return figure;
}

}  // namespace porowave::reports
