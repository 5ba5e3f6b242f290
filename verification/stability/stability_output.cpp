#include "verification/stability/stability_output.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>

namespace porowave::verification {

namespace {

std::string growth_text(const solver::Growth& growth, double limit) {
  const double rate = growth.per_step - 1.0;
  if (!growth.settled) return fmt::format("less than {:g} a step", std::max(rate, limit));
  if (rate < 1e-9) return rate < -1e-9 ? "none, all decays" : "none";
  return fmt::format("{:.3g} a step", rate);
}

/// Noise of rounding times this by the end of the run.
std::string noise_text(const solver::Growth& growth, long steps) {
  const double tens = static_cast<double>(steps) * std::log10(growth.per_step);
  return tens < 4.0 ? fmt::format("{:.3g}", std::pow(10.0, tens)) : fmt::format("1e{:.0f}", tens);
}

std::string critical_text(const SceneStability& found) {
  const auto& critical = found.critical;
  if (critical.courant == 0.0) {
    return fmt::format("none: unstable at every courant from {:.3g} to {:.3g}\n",
                       critical.scan.back().courant, critical.scan.front().courant);
  }
  if (critical.unstable == 0.0) {
    return fmt::format("{:.4g} or more: stable up to the highest that was tried\n",
                       critical.courant);
  }
  return fmt::format("{:.4g} ({:.4g} s); {:.4g} is unstable\n", critical.courant,
                     critical.courant * found.fast_crossing, critical.unstable);
}

std::string below_text(const solver::CriticalStep& critical) {
  const auto below = critical.unstable_below();
  if (below.empty()) return "";
  double worst = 0.0;
  std::string places;
  for (auto sample = below.rbegin(); sample != below.rend(); ++sample) {
    worst = std::max(worst, sample->growth - 1.0);
    places += fmt::format("{}{:.3g}", places.empty() ? "" : ", ", sample->courant);
  }
  return fmt::format("unstable below it  at courant {} (growth up to {:.2g} a step)\n", places,
                     worst);
}

}  // namespace

std::string stability_summary(const SceneStability& found, double limit) {
  std::string text = fmt::format("time step          {:.4g} s, courant {:.4g}, {} steps\n",
                                 found.time_step, found.courant, found.steps);
  text += fmt::format("growth             {}", growth_text(found.at_requested, limit));
  if (!found.stable(limit)) {
    text += fmt::format(": noise is multiplied by {} in this run",
                        noise_text(found.at_requested, found.steps));
  }
  text += fmt::format("\nverdict            {}: growth {} {:g} a step\n",
                      found.stable(limit) ? "stable" : "unstable",
                      found.stable(limit) ? "of at most" : "above", limit);
  text += "critical courant   " + critical_text(found) + below_text(found.critical);
  text += fmt::format("\n{:<34}{:>10}{:>14}\n", "estimates", "courant", "time step, s");
  const auto estimate = [&](const char* what, double time_step) {
    text +=
        fmt::format("{:<34}{:>10.4g}{:>14.4g}\n", what, time_step / found.fast_crossing, time_step);
  };
  estimate("fast wave, h/c_1", found.estimates.fast_wave);
  estimate("undrained wave, h/c", found.estimates.undrained_wave);
  if (found.estimates.linear_shape) {
    estimate("linear shape functions", *found.estimates.linear_shape);
  }
  estimate("if drag were explicit (Mieremet)", found.estimates.explicit_drag);
  if (found.mode) {
    text += fmt::format(
        "\nfastest mode       courant {:.4g}: {:.3g} a step, turning by {:.3g} "
        "degrees a step\n",
        found.mode->courant, found.mode->growth - 1.0,
        found.mode->angle * 180.0 / 3.14159265358979323846);
  }
  return text;
}

void write_growth_csv(const SceneStability& found, std::ostream& out) {
  out << "courant,time_step,growth,stable\n";
  for (auto sample = found.critical.scan.rbegin(); sample != found.critical.scan.rend(); ++sample) {
    fmt::print(out, "{:.12g},{:.12g},{:.12g},{}\n", sample->courant,
               sample->courant * found.fast_crossing, sample->growth - 1.0,
               sample->stable ? "true" : "false");
  }
}

void write_mode_csv(const GrowingMode& mode, std::ostream& out) {
  out << "x,effective_stress,pore_pressure,solid_velocity,fluid_velocity,"
         "effective_stress_amplitude,pore_pressure_amplitude,solid_velocity_amplitude,"
         "fluid_velocity_amplitude\n";
  const solver::CarriedFields& now = mode.fields;
  const solver::CarriedFields& later = mode.quarter_later;
  for (std::size_t i = 0; i < now.node_x.size(); ++i) {
    fmt::print(out, "{:.17g},,,{:.17g},{:.17g},,,{:.17g},{:.17g}\n", now.node_x[i],
               now.solid_velocity[i], now.fluid_velocity[i],
               std::hypot(now.solid_velocity[i], later.solid_velocity[i]),
               std::hypot(now.fluid_velocity[i], later.fluid_velocity[i]));
    if (i >= now.cell_x.size()) continue;
    fmt::print(out, "{:.17g},{:.17g},{:.17g},,,{:.17g},{:.17g},,\n", now.cell_x[i],
               now.effective_stress[i], now.pore_pressure[i],
               std::hypot(now.effective_stress[i], later.effective_stress[i]),
               std::hypot(now.pore_pressure[i], later.pore_pressure[i]));
  }
}

}  // namespace porowave::verification
