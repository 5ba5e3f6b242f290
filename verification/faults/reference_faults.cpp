// Wrong references: pieces of the exact solution exchanged, judged by the truth table; a modal sum
// that lacks a mode and bounds that are too small; and wrong profiles, judged by what right solvers
// look like against them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/column_solution.hpp"
#include "reference/field_fixtures.hpp"
#include "reference/modal.hpp"
#include "reference/modal_modes.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/tables/truth.hpp"
#include "verification/faults/open_reference.hpp"
#include "verification/faults/study_slice.hpp"
#include "verification/faults/truth_check.hpp"

namespace porowave::verification::faults {

using reference::Complex;
using reference::ModeState;
using reference::Ray;
using reference::WaveModes;
using reference::WaveState;

namespace {

Fault in_reference(const std::string& what, const std::function<void(ReferenceParts&)>& exchange) {
  ReferenceParts parts;
  exchange(parts);
  return {"reference", what, "of the load", [parts] {
            return caught_by_truth([&](const Problem& problem, double x, double t) {
              return open_reference(problem, x, t, parts);
            });
          }};
}

void mode_faults(std::vector<Fault>& all) {
  all.push_back(in_reference("wrong branch of the slow mode's root", [](ReferenceParts& parts) {
    parts.modes = [](const WaveModes& modes, Complex s) {
      ModeState state = modes.at(s);
      const Complex frozen = s / modes.speed(1);
      state.excess[1] = -(state.excess[1] + frozen) - frozen;
      state.slowness[1] = -state.slowness[1];
      return state;
    };
  }));
  all.push_back(in_reference("modes exchanged beyond a branch cut", [](ReferenceParts& parts) {
    parts.modes = [](const WaveModes& modes, Complex s) {
      ModeState state = modes.at(s);
      if (s.imag() > 2.0 * s.real()) std::swap(state.slowness[0], state.slowness[1]);
      return state;
    };
  }));
  all.push_back(in_reference("modes without drag", [](ReferenceParts& parts) {
    parts.modes = [](const WaveModes& modes, Complex) { return modes.frozen(); };
  }));
  all.push_back(in_reference("modes of the conjugate variable", [](ReferenceParts& parts) {
    parts.modes = [](const WaveModes& modes, Complex s) { return modes.at(std::conj(s)); };
  }));
  all.push_back(in_reference("drag 0.01 % too large", [](ReferenceParts& parts) {
    parts.problem = [](Problem& p) { p.material.fluid_viscosity *= 1.0001; };
  }));
  all.push_back(in_reference("the slow mode dropped", [](ReferenceParts& parts) {
    parts.rays = [](std::vector<Ray>& rays) {
      std::erase_if(rays, [](const Ray& ray) { return ray.mode == 1; });
    };
  }));
}

void end_faults(std::vector<Fault>& all) {
  all.push_back(in_reference("one reflection lost: the second", [](ReferenceParts& parts) {
    parts.rays = [](std::vector<Ray>& rays) {
      std::erase_if(rays, [](const Ray& ray) { return ray.crossings == 2; });
    };
  }));
  all.push_back(in_reference("the wall reflects as a free end", [](ReferenceParts& parts) {
    parts.state = [](WaveState& state) {
      for (auto& row : state.ends.at_far) {
        for (Complex& r : row) r = -r;
      }
    };
  }));
  all.push_back(in_reference("the load acts on the fluid as well", [](ReferenceParts& parts) {
    parts.problem = [](Problem& p) { p.column.near = NearEnd::fluid_pressure; };
  }));
  all.push_back(in_reference("a wave arrives late by a thousandth", [](ReferenceParts& parts) {
    parts.rays = [](std::vector<Ray>& rays) {
      for (Ray& ray : rays) ray.arrival *= 1.001;
    };
  }));
  all.push_back(in_reference("pore pressure with the wrong sign", [](ReferenceParts& parts) {
    parts.state = [](WaveState& state) {
      for (auto* fields : {&state.fields.up, &state.fields.down}) {
        for (auto& mode : *fields) mode[1] = -mode[1];
      }
    };
  }));
  all.push_back(
      in_reference("velocities of waves going back as of those coming", [](ReferenceParts& parts) {
        parts.state = [](WaveState& state) {
          for (std::size_t mode = 0; mode < 2; ++mode) {
            state.fields.down[mode][0] = state.fields.up[mode][0];
            state.fields.down[mode][1] = state.fields.up[mode][1];
          }
        };
      }));
  all.push_back(in_reference("the contour's first node counts fully",
                             [](ReferenceParts& parts) { parts.first_weight = 1.0; }));
}

/// The modal sum without its mode n against the contour, as reference/routes_test.cpp compares
/// them.
Catch lost_mode(std::size_t n) {
  const Problem problem = fixtures::paper_problem(Load(LoadShape::sin4_pulse, 1.0, 1e-5));
  const double t = 4e-5;
  const double x = 0.3 * *problem.column.length;
  const reference::quarter_wave::Frame frame(problem);
  const double k = (static_cast<double>(n) + 0.5) * std::acos(-1.0) / *problem.column.length;
  auto mode = mode_amplitudes(frame, reference::quarter_wave::SmoothLoad(problem.load, t), t, k,
                              2.0 / (*problem.column.length * k));
  for (std::size_t i = 0; i < 4; ++i) mode[i] *= i < 2 ? std::sin(k * x) : std::cos(k * x);
  const auto lost = frame.fields(mode);
  Fields sum = reference::ModalSolution(problem, t).at(x).value;
  const Fields contour = reference::ColumnSolution(problem).at(x, t).value;
  if (fixtures::distance(problem, sum, contour) > 1e-10) return {"routes", ""};
  sum.effective_stress -= lost[0];
  sum.pore_pressure -= lost[1];
  sum.solid_velocity -= lost[2];
  sum.fluid_velocity -= lost[3];
  const double apart = fixtures::distance(problem, sum, contour);
  if (apart <= 1e-10) return {"routes", ""};
  return {"routes", fmt::format("modal sum and contour are {:.2g} of the load apart", apart)};
}

/// Bounds that are too small by a factor, against the truth rows.
Catch small_bounds(double factor) {
  int outside = 0;
  const auto rows =
      fixtures::read_truth(std::string(POROWAVE_SOURCE_DIR) + "/reference/tables/truth_step.csv");
  for (const fixtures::TruthRow& row : rows) {
    const auto fields = reference::ColumnSolution(row.problem).at(row.x, row.t);
    const auto value = fixtures::shares(row.problem, fields.value);
    const auto truth = fixtures::shares(row.problem, row.value);
    const auto bound = fixtures::shares(row.problem, fields.error);
    for (std::size_t f = 0; f < 4; ++f) {
      outside += std::abs(value[f] - truth[f]) > bound[f] / factor + row.uncertainty;
    }
  }
  if (outside == 0) return {"truth table", ""};
  return {"truth table", fmt::format("{} values are outside of their bounds", outside)};
}

using ProfilePointer = std::shared_ptr<const reference::Profile>;

/// A right solver against the profile of another problem or time.
Fault wrong_profile(const std::string& what, const std::string& named,
                    const std::function<void(solver::Case&)>& change) {
  return {"reference", what, named, [change] {
            return caught_by_study([&](const solver::Case& scene, const reference::Profile&) {
              solver::Case other = scene;
              change(other);
              const ProfilePointer wrong = reference_profile(
                  other.problem, other.time.end, solver::ColumnSolver::grid_length(scene));
              return run_case(scene, *wrong);
            });
          }};
}

}  // namespace

std::vector<Fault> reference_faults() {
  std::vector<Fault> all;
  mode_faults(all);
  end_faults(all);
  all.push_back(
      {"reference", "mode 3 of the modal sum dropped", "apart", [] { return lost_mode(3); }});
  all.push_back(
      {"reference", "mode 40 of the modal sum dropped", "apart", [] { return lost_mode(40); }});
  all.push_back({"reference", "error bounds 1,000 times too small", "outside of their bounds",
                 [] { return small_bounds(1e3); }});
  all.push_back(wrong_profile("profile of another time", "at different times",
                              [](solver::Case& scene) { scene.time.end *= 1.0001; }));
  all.push_back(wrong_profile("profile with a permeability 1 % too small", "fail", [](auto& scene) {
    scene.problem.material.intrinsic_permeability *= 0.99;
  }));
  return all;
}

}  // namespace porowave::verification::faults
