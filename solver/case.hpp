#pragma once

// A case: a problem, and every choice of the method for one run.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reference/problem/problem.hpp"
#include "solver/kernel.hpp"

namespace porowave {
class TomlDocument;
}

namespace porowave::solver {

enum class TransferName {
  shape,  // the grid's linear shape functions (Sulsky, Chen & Schreyer 1994)
  mls,    // moving least squares (Sulsky & Gong 2016; Chmelnizkij 2023)
};

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

struct Discretization {
  int elements = 100;
  TransferName transfer = TransferName::mls;
  KernelName kernel = kernel_name<BSpline2>;
  double support_radius = natural_radius(kernel_name<BSpline2>);  // in element lengths
  int basis_order = 1;                                            // 0 to 2
  int points_per_element = 4;                                     // of each phase
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

struct TimeSettings {
  double end = 0.0;      // s
  double courant = 0.5;  // c_1 Δt/h
  double flip = 1.0;     // 1 FLIP ... 0 PIC
  StepPath path = StepPath::automatic;
};

struct Case {
  Problem problem;
  Discretization discretization;
  TimeSettings time;
};

// Reads a case. Throws InputError (file, line, key, value, what was expected) for wrong values, for
// keys that do not belong together and for choices that this version does not have.
Case read_case(const TomlDocument& document);
Case load_case(const std::string& path);

}  // namespace porowave::solver
