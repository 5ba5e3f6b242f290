#include "reports/stability_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace porowave::reports {

namespace {

/// Growth that cannot be told from none: what is less is drawn there.
constexpr double least_growth = 1e-7;

std::string growth_block(const verification::SceneStability& found) {
  std::vector<std::pair<double, double>> rows;
  for (const auto& sample : found.critical.scan) rows.emplace_back(sample.courant, sample.growth);
  rows.emplace_back(found.courant, found.at_requested.per_step);
  std::sort(rows.begin(), rows.end());
  std::string block = "# courant, growth a step less 1\n";
  for (const auto& [courant, growth] : rows) {
    block += fmt::format("{:.10g} {:.6e}\n", courant, std::max(growth - 1.0, least_growth));
  }
  return block;
}

std::string velocity_block(const solver::CarriedFields& fields) {
  std::string block = "# x (m), solid velocity, fluid velocity\n";
  for (std::size_t i = 0; i < fields.node_x.size(); ++i) {
    block += fmt::format("{:.10g} {:.6e} {:.6e}\n", fields.node_x[i], fields.solid_velocity[i],
                         fields.fluid_velocity[i]);
  }
  return block;
}

std::string stress_block(const solver::CarriedFields& fields) {
  double size = 0.0;
  for (const auto* values : {&fields.effective_stress, &fields.pore_pressure}) {
    for (const double value : *values) size = std::max(size, std::abs(value));
  }
  std::string block = "# x (m), effective stress, pore pressure, both over the largest\n";
  for (std::size_t c = 0; c < fields.cell_x.size(); ++c) {
    block += fmt::format("{:.10g} {:.6e} {:.6e}\n", fields.cell_x[c],
                         fields.effective_stress[c] / size, fields.pore_pressure[c] / size);
  }
  return block;
}

}  // namespace

// Numbers for gnuplot's real() keep their point (#): without one it cannot read "1e-05".
Figure stability_figure(const verification::SceneStability& found, const std::string& caption,
                        double limit) {
  Figure figure{"stability", "stability", {{"caption", caption}}, growth_block(found)};
  figure.texts.emplace_back("limit", fmt::format("{:#.6g}", limit));
  figure.texts.emplace_back("requested", fmt::format("{:#.6g}", found.courant));
  figure.texts.emplace_back("critical", fmt::format("{:#.6g}", found.critical.courant));
  figure.texts.emplace_back(
      "highest",
      fmt::format("{:#.6g}", std::max(found.critical.scan.front().courant, found.courant)));
  figure.texts.emplace_back("mode", found.mode
                                        ? fmt::format("Fastest mode at courant {:.4g}: "
                                                      "grows by {:.3g} a step",
                                                      found.mode->courant, found.mode->growth - 1.0)
                                        : "");
  if (!found.mode) return figure;
  figure.texts.emplace_back("x_end", fmt::format("{:#.10g}", found.mode->fields.node_x.back()));
  figure.data += "\n\n" + velocity_block(found.mode->fields);
  figure.data += "\n\n" + stress_block(found.mode->fields);
  return figure;
}

}  // namespace porowave::reports
