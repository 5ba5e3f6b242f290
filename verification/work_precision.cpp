#include "verification/work_precision.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/problem/errors.hpp"
#include "solver/stability/automatic_step.hpp"

namespace porowave::verification {

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

double WorkPrecision::error() const {
  double largest = 0.0;
  for (const FieldError& field : run.errors) {
    if (std::isnan(field.field.l2)) return field.field.l2;
    largest = std::max(largest, field.field.l2);
  }
  return largest;
}

std::vector<WorkPrecision> measure(std::span<const Method> methods, std::span<const int> elements,
                                   int repetitions) {
  if (repetitions < 1) throw std::invalid_argument("measure: fewer than one repetition");
  std::vector<WorkPrecision> measured;
  for (const Method& method : methods) {
    for (const int count : elements) {
      measured.push_back({method, {}, 0.0});
      solver::Case& scene = measured.back().method.scene;
      scene.discretization.elements = count;
      scene.time.courant = solver::automatic_courant(scene);
    }
  }
  if (measured.empty()) return measured;
  const auto profile = reference_profile(measured.front().method.scene);
  std::vector<std::vector<double>> seconds(measured.size());
  for (int k = 0; k < repetitions; ++k) {
    for (std::size_t i = 0; i < measured.size(); ++i) {
      measured[i].run = run_case(measured[i].method.scene, *profile);
      if (measured[i].run.breakdown) {
        throw BreakdownError(measured[i].method.name + ": " + measured[i].run.breakdown->reason);
      }
      seconds[i].push_back(measured[i].run.cost.cpu_seconds);
    }
  }
  for (std::size_t i = 0; i < measured.size(); ++i) measured[i].cpu_seconds = median(seconds[i]);
  return measured;
}

std::vector<std::size_t> pareto_front(std::span<const WorkPrecision> measured) {
  std::vector<std::size_t> by_cost;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (std::isfinite(measured[i].error())) by_cost.push_back(i);
  }
  std::sort(by_cost.begin(), by_cost.end(), [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t i) {
      return std::pair(measured[i].cpu_seconds, measured[i].error());
    };
    return key(a) < key(b);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : by_cost) {
    if (front.empty() || measured[i].error() < measured[front.back()].error()) front.push_back(i);
  }
  return front;
}

std::size_t cheapest_within(std::span<const WorkPrecision> measured, double level) {
  std::size_t best = measured.size();
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!(measured[i].error() <= level)) continue;  // NaN is never within
    if (best == measured.size() || measured[i].cpu_seconds < measured[best].cpu_seconds) best = i;
  }
  return best;
}

void write_work_precision_csv(std::span<const WorkPrecision> measured, std::ostream& out) {
  out << "transfer,kernel,support_radius,basis_order,strain,scheme,time_order,placement,"
         "points_per_element,elements,courant,steps";
  for (const auto field : field_names) out << ',' << field << "_l2_points," << field << "_l2_field";
  out << ",cpu_seconds,ns_per_point_step\n";
  for (const WorkPrecision& m : measured) {
    const solver::Discretization& d = m.method.scene.discretization;
    fmt::print(out, "{},{},{},{},{},{},{},{},{},{},{:.4g},{}",
               solver::transfer_names[static_cast<std::size_t>(d.transfer)], kernel_word(d),
               d.support_radius, d.basis_order,
               solver::strain_names[static_cast<std::size_t>(d.strain)],
               d.scheme == solver::Scheme::staggered4 ? "staggered4" : "galerkin",
               m.method.scene.time.order, name(d.placement), d.points_per_element, d.elements,
               m.run.courant, m.run.steps);
    for (const FieldError& error : m.run.errors) {
      fmt::print(out, ",{:.4e},{:.4e}", error.points.l2, error.field.l2);
    }
    const double updates = static_cast<double>(m.run.points) * static_cast<double>(m.run.steps);
    fmt::print(out, ",{:.4e},{:.2f}\n", m.cpu_seconds, 1e9 * m.cpu_seconds / updates);
  }
}

std::string best_of_levels(std::span<const WorkPrecision> measured,
                           std::span<const double> error_levels) {
  std::string text = fmt::format("{:<14}{:<32}{:>9}{:>12}{:>10}\n", "error at most",
                                 "cheapest method", "elements", "error", "CPU ms");
  for (const double level : error_levels) {
    const std::size_t best = cheapest_within(measured, level);
    if (best == measured.size()) {
      text += fmt::format("{:<14.0e}none\n", level);
      continue;
    }
    const WorkPrecision& m = measured[best];
    text += fmt::format("{:<14.0e}{:<32}{:>9}{:>12.2e}{:>10.3g}\n", level, m.method.name,
                        m.method.scene.discretization.elements, m.error(), 1e3 * m.cpu_seconds);
  }
  return text;
}

}  // namespace porowave::verification
