#include "reports/solver_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace porowave::reports {

namespace {

using verification::WorkPrecision;

int panel_of(const WorkPrecision& m) {
  if (m.method.scene.discretization.scheme == solver::Scheme::staggered4) return 3;
  return m.method.scene.discretization.transfer == solver::TransferName::mls ? 2 : 1;
}

std::string row(const WorkPrecision& m) {
  return fmt::format("{:.4e} {:.4e}\n", m.cpu_seconds, m.error());
}

}  // namespace

Figure solver_work_precision(std::span<const WorkPrecision> measured) {
  Figure figure{"solver_work_precision",
                "solver_work_precision",
                {{"caption",
                  "Error against CPU time: smooth load, uniform points, courant = \"auto\" (grey: "
                  "the best of all)"}},
                "# best of all: CPU seconds, largest relative L2 error of the four fields\n"};
  double fastest = HUGE_VAL;
  double slowest = 0.0;
  double lowest = HUGE_VAL;
  double highest = 0.0;
  for (const std::size_t i : verification::pareto_front(measured)) figure.data += row(measured[i]);
  int curves = 0;
  std::string titles;
  std::string panels;
  std::string dashes;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const WorkPrecision& m = measured[i];
    if (i == 0 || m.method.name != measured[i - 1].method.name) {
      figure.data += fmt::format("\n\n# {}: CPU seconds, error\n", m.method.name);
      figure.texts.emplace_back(fmt::format("title{}", ++curves), m.method.name);
      panels += fmt::format("{} ", panel_of(m));
      const bool recovered = m.method.scene.discretization.strain == solver::Strain::recovered;
      dashes += fmt::format("{} ", recovered ? 2 : 1);
    }
    figure.data += row(m);
    fastest = std::min(fastest, m.cpu_seconds);
    slowest = std::max(slowest, m.cpu_seconds);
    lowest = std::min(lowest, m.error());
    highest = std::max(highest, m.error());
  }
  figure.texts.emplace_back("curves", fmt::format("{}", curves));
  figure.texts.emplace_back("panels", panels);
  figure.texts.emplace_back("dashes", dashes);
  figure.texts.emplace_back("fastest", fmt::format("{:#.3g}", 0.7 * fastest));
  figure.texts.emplace_back("slowest", fmt::format("{:#.3g}", 1.5 * slowest));
  figure.texts.emplace_back("lowest", fmt::format("{:#.3g}", 0.6 * lowest));
  figure.texts.emplace_back("highest", fmt::format("{:#.3g}", 1.5 * highest));
  return figure;
}

}  // namespace porowave::reports
