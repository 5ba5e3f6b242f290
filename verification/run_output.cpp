#include "verification/run_output.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "verification/norms_json.hpp"

namespace porowave::verification {

namespace {

/// Strains above this may show beside the errors of a good run.
constexpr double noticeable_strain = 1e-5;

Json errors_json(const FieldErrors& errors) {
  Json json;
  for (std::size_t f = 0; f < errors.size(); ++f) {
    json[std::string(field_names[f])] = {{"points", norms_json(errors[f].points)},
                                         {"field", norms_json(errors[f].field)}};
  }
  return json;
}

Json measures_json(const WaveMeasures& m) {
  Json json;
  json["arrival_delay"] = {{"fast", number(m.arrival_delay[0])},
                           {"slow", number(m.arrival_delay[1])}};
  for (std::size_t f = 0; f < field_names.size(); ++f) {
    json[std::string(field_names[f])] = {
        {"overshoot", number(m.overshoot[f].excess)},
        {"total_variation", number(m.overshoot[f].total_variation)},
        {"ringing", number(m.ringing[f].amplitude)},
        {"ringing_share", number(m.ringing[f].share)}};
  }
  json["gap"] = {{"reflected", number(m.gap.reflected)},
                 {"transmitted", number(m.gap.transmitted)}};
  json["energy_drift"] = {{"points", number(m.energy.points)}, {"field", number(m.energy.field)}};
  return json;
}

Json automatic_json(const std::optional<solver::AutomaticStep>& step) {
  if (!step) return nullptr;
  Json json;
  json["rule"] = solver::name(step->rule);
  json["courant"] = number(step->courant);
  json["elements_analysed"] = step->elements;
  json["critical_courant"] = step->elements > 0 ? Json(number(step->critical)) : Json(nullptr);
  json["noise_growth"] = number(step->noise_growth);
  return json;
}

std::string automatic_text(const solver::AutomaticStep& step) {
  switch (step.rule) {
    case solver::StepRule::critical_step:
      return fmt::format("courant {:.4g}: critical step of this scene at {:.4g}{}\n", step.courant,
                         step.critical, step.critical < 1.0 ? "" : " or more");
    case solver::StepRule::window:
      return fmt::format("courant {:.4g}: critical step of {} of its elements at {:.4g}{}\n",
                         step.courant, step.elements, step.critical,
                         step.critical < 1.0 ? "" : " or more");
    case solver::StepRule::formula:
      break;
  }
  return fmt::format("courant {:.4g}: by formula\n", step.courant);
}

}  // namespace

void write_points_csv(const solver::Snapshot& snapshot, std::ostream& out) {
  out << "phase,x,volume,velocity,effective_stress,pore_pressure\n";
  const auto rows = [&](const solver::PhasePoints& points, const char* format) {
    for (std::size_t p = 0; p < points.x.size(); ++p) {
      fmt::print(out, fmt::runtime(format), points.x[p], points.volume[p], points.velocity[p],
                 points.stress[p]);
    }
  };
  rows(snapshot.solid, "solid,{:.17g},{:.17g},{:.17g},{:.17g},\n");
  rows(snapshot.fluid, "fluid,{:.17g},{:.17g},{:.17g},,{:.17g}\n");
}

std::string run_json(const RunResult& result) {
  Json json;
  json["errors"] = result.breakdown ? Json(nullptr) : errors_json(result.errors);
  json["measures"] = result.breakdown ? Json(nullptr) : measures_json(result.measures);
  json["path"] = solver::name(result.path);
  json["frozen_steps"] = result.frozen_steps;
  json["time"] = number(result.snapshot.time);
  json["time_step"] = number(result.time_step);
  json["courant"] = number(result.courant);
  json["automatic_courant"] = automatic_json(result.automatic);
  json["steps"] = result.steps;
  json["points"] = result.points;
  json["wall_seconds"] = number(result.cost.wall_seconds);
  json["cpu_seconds"] = number(result.cost.cpu_seconds);
  json["ns_per_point_step"] = number(result.cost.ns_per_point_step);
  json["peak_rss_bytes"] = result.cost.peak_rss_bytes;
  json["reference_error"] = number(result.reference_error);
  json["largest_strain"] = number(result.largest_strain);
  json["evaluations_of_reduced_order"] = result.reduced_rows;
  json["evaluations_without_points"] = result.empty_rows;
  json["diverged"] = result.breakdown.has_value();
  if (result.breakdown) json["reason"] = result.breakdown->reason;
  return json.dump(2) + "\n";
}

std::string run_summary(const RunResult& result) {
  std::string text = fmt::format(
      "{} points, {} steps of {:.4g} s, {:.1f} ns per point and step, {:.3g} s of CPU\n",
      result.points, result.steps, result.time_step, result.cost.ns_per_point_step,
      result.cost.cpu_seconds);
  if (result.automatic) text += automatic_text(*result.automatic);
  if (result.reduced_rows > 0) {
    text += fmt::format("{} evaluations had too few points for the basis and lowered its order\n",
                        result.reduced_rows);
  }
  if (result.empty_rows > 0) {
    text += fmt::format("{} nodes or cell middles are out of reach of every point\n",
                        result.empty_rows);
  }
  if (result.breakdown) return text;
  if (result.largest_strain > noticeable_strain) {
    text += fmt::format(
        "strains reach {:.1e}: points move, and the reference of small strains is off by as much\n",
        result.largest_strain);
  }
  text += fmt::format("{:<18}{:>14}{:>14}\n", "relative L2 error", "at points", "of the field");
  for (std::size_t f = 0; f < field_names.size(); ++f) {
    text += fmt::format("{:<18}{:>14.4e}{:>14.4e}\n", field_names[f], result.errors[f].points.l2,
                        result.errors[f].field.l2);
  }
  return text;
}

}  // namespace porowave::verification
