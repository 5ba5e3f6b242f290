#pragma once

// A case: a problem, and every choice of the method for one run.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/problem/problem.hpp"
#include "solver/kernel.hpp"
#include "solver/shape_functions.hpp"

namespace porowave {
class TomlDocument;
}

namespace porowave::solver {

enum class TransferName {
  shape,  // the grid's shape functions (Sulsky, Chen & Schreyer 1994)
  mls,    // moving least squares (Sulsky & Gong 2016; Chmelnizkij 2023)
  apic,   // affine velocities and MLS-MPM forces on shape functions (Hu et al. 2018)
};
inline constexpr std::array<std::string_view, 3> transfer_names = {"shape", "mls", "apic"};

// Where the points of a phase start. n points a cell means n per cell and phase in the mean.
enum class Placement {
  uniform,     // regular, spacing h/n
  jittered,    // regular, each moved by up to jitter/2 spacings to either side
  stratified,  // n independent uniform ones within each cell
  random,      // independent uniform ones over the whole column; cells may be empty
};
inline constexpr std::array<std::string_view, 4> placement_names = {"uniform", "jittered",
                                                                    "stratified", "random"};
constexpr std::string_view name(Placement p) {
  return placement_names[static_cast<std::size_t>(p)];
}

// Strain rates at the points, with linear shape functions.
enum class Strain {
  cell,       // that of the cell (the paper's)
  recovered,  // interpolated between the middles of cells (strain_recovery.hpp)
};
inline constexpr std::array<std::string_view, 2> strain_names = {"cell", "recovered"};

enum class Scheme {
  galerkin,    // the weak form on the grid, by one of the transfers (the paper's)
  staggered4,  // collocation on a staggered grid, of fourth order (staggered/staggered_solver.hpp)
};

struct Discretization {
  Scheme scheme = Scheme::galerkin;
  int elements = 100;
  TransferName transfer = TransferName::mls;
  ShapeName shape = ShapeName{};              // for shape and apic; linear functions else
  KernelName kernel = kernel_name<BSpline2>;  // for mls
  double support_radius = natural_radius(kernel_name<BSpline2>);  // in element lengths
  bool adaptive_support = false;  // enlarge support_radius where points are too few for the basis
  int basis_order = 1;            // 0 to 2; 2 or 3 for Scheme::staggered4
  double max_condition = 1e4;     // of moments (mls.hpp), > 1; above it the basis loses an order
  Strain strain = Strain::cell;
  int points_per_element = 4;  // of each phase
  Placement placement = Placement::uniform;
  double jitter = 0.5;  // share of the point spacing; for Placement::jittered
  std::uint64_t seed = 1;
  std::vector<double> empty_elements;  // x in m; the elements around them have no points
};

// How a step is made; the results are the same to rounding.
enum class StepPath {
  automatic,  // frozen for as long as that is possible, then points
  points,     // every step visits the points
  frozen,     // points eliminated; a run in which they move too far for that is ended
};
inline constexpr std::array<std::string_view, 3> path_names = {"auto", "points", "frozen"};
constexpr std::string_view name(StepPath p) {
  return path_names[static_cast<std::size_t>(p)];
}

// How courant = "auto" was settled (stability/automatic_step.hpp).
enum class StepRule {
  critical_step,  // a share of the critical step of the scene
  window,         // a share of that of some of its elements
  formula,        // an estimate (time_step.hpp)
};
inline constexpr std::array<std::string_view, 3> step_rule_names = {"critical_step", "window",
                                                                    "formula"};
constexpr std::string_view name(StepRule rule) {
  return step_rule_names[static_cast<std::size_t>(rule)];
}

struct AutomaticStep {
  StepRule rule;
  double courant;   // that was chosen
  double critical;  // critical Courant number, 1 if it is that or more; 0 if none was looked for
  double noise_growth;  // factor of noise in the run, by eigenvalues; NaN if not looked for
  int elements;         // that were analysed
};

struct TimeSettings {
  double end = 0.0;                             // s
  double courant = 0.5;                         // c_1 Δt/h
  std::optional<AutomaticStep> automatic = {};  // of courant = "auto", which chose it
  double flip = 1.0;                            // 1 FLIP ... 0 PIC
  int xpic_order = 0;  // 1 to 10: XPIC of that order instead of flip (velocity_noise.hpp)
  int order = 2;       // of the time step: 2, or 4 with Scheme::staggered4
  StepPath path = StepPath::automatic;
};

// The word for the weighting in a case file, of whatever transfer.
std::string_view kernel_word(const Discretization& discretization);

// Whether a step has the compact form (column_operators.hpp), in which the points can also be
// eliminated: linear shape functions between nodes and points, and no XPIC, whose update needs the
// whole column several times.
bool compact_form_available(const Discretization& discretization, const TimeSettings& time);

struct Case {
  Problem problem;
  Discretization discretization;
  TimeSettings time;
};

// Reads a case. Throws InputError (file, line, key, value, what was expected) for wrong values, for
// keys that do not belong together, for choices that this version does not have, and with
// courant = "auto" for scenes without a stable time step.
Case read_case(const TomlDocument& document);
Case load_case(const std::string& path);

}  // namespace porowave::solver
