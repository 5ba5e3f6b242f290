#include "reports/seed_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace porowave::reports {

namespace {

std::string legend_of(const verification::Study& study,
                      const verification::SeedDistribution& distribution) {
  std::string legend;
  std::size_t at = 0;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    if (a == study.seed.value()) continue;
    const TomlValue& value = distribution.coordinates[at++];
    if (study.axes[a].values.size() < 2) continue;
    legend += fmt::format("{}{} {}", legend.empty() ? "" : ", ", study.axes[a].key,
                          verification::plain_text(value));
  }
  const auto unstable = std::count(distribution.courant.begin(), distribution.courant.end(), 0.0);
  return fmt::format("{}{}least {:.3g}, median {:.3g}; {} of {} unstable at every step", legend,
                     legend.empty() ? "" : ": ", distribution.quantile(0.0),
                     distribution.quantile(0.5), unstable, distribution.courant.size());
}

/// From no seed to all, a step at every limit.
std::string curve_of(const verification::SeedDistribution& distribution) {
  std::string lines = "# critical courant, share of the seeds (%)\n-1 0\n";
  const auto count = static_cast<double>(distribution.courant.size());
  for (std::size_t k = 0; k < distribution.courant.size(); ++k) {
    const bool last_of_equals = k + 1 == distribution.courant.size() ||
                                distribution.courant[k + 1] != distribution.courant[k];
    if (!last_of_equals) continue;
    lines += fmt::format("{:.6g} {:.6g}\n", distribution.courant[k],
                         100.0 * static_cast<double>(k + 1) / count);
  }
  return lines;
}

/// The tenth below the least limit above zero: what is zero reaches into the picture from the left.
double lowest_shown(const std::vector<verification::SeedDistribution>& distributions,
                    double highest) {
  double least = highest;
  for (const auto& one : distributions) {
    for (const double courant : one.courant) {
      if (courant > 0.0) least = std::min(least, courant);
    }
  }
  return std::min(std::floor(10.0 * least) / 10.0, highest - 0.1);
}

}  // namespace

Figure seed_figure(const verification::Study& study,
                   const std::vector<verification::SeedDistribution>& distributions,
                   double highest) {
  if (distributions.empty() || distributions.size() > most_seed_curves) {
    throw std::invalid_argument("seed figure: 1 to 16 curves");
  }
  Figure figure{"stability_seeds", "stability_seeds", {}, {}};
  const auto text = [&](const std::string& variable, const std::string& value) {
    figure.texts.emplace_back(variable, value);
  };
  for (std::size_t k = 0; k < distributions.size(); ++k) {
    figure.data += (k == 0 ? "" : "\n\n") + curve_of(distributions[k]);
    text(fmt::format("curve{}", k + 1), legend_of(study, distributions[k]));
  }
  text("caption", fmt::format("Critical courant over seeds: {}", study.name));
  const std::size_t seeds = study.axes[study.seed.value()].values.size();
  text("subcaption", fmt::format("{} seeds a curve; curves that enter from the left have seeds "
                                 "without a stable step",
                                 seeds));
  text("least", fmt::format("{:.3g}", 100.0 / static_cast<double>(seeds)));
  text("lowest", fmt::format("{:.3g}", lowest_shown(distributions, highest)));
  text("count", std::to_string(distributions.size()));
  text("highest", fmt::format("{}", highest));
  return figure;
}

}  // namespace porowave::reports
