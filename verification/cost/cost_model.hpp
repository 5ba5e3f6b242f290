#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "solver/case.hpp"

namespace porowave::verification {

/// How a case makes its steps, by which costs differ most.
enum class CostFamily {
  frozen,     ///< nodes only, the points eliminated
  points,     ///< compact form, points visited: time.path = "points"
  general,    ///< any shape functions, and XPIC
  affine,     ///< apic
  staggered,  ///< staggered4
};
inline constexpr std::array<std::string_view, 5> cost_family_names = {"frozen", "points", "general",
                                                                      "affine", "staggered"};

inline constexpr std::size_t cost_term_count = 6;
using CostTerms = std::array<double, cost_term_count>;

/// What a case's CPU time is a sum of, each times a constant of its family: the case itself;
/// points; points times reach of their weights, in elements; visits; visits times reach; visits
/// times XPIC's order. A visit is one of a node (frozen, staggered) or of a point (else) in one
/// step. Compact steps leave out what the fast wave has not reached by then.
struct CaseCost {
  CostFamily family;
  CostTerms terms;
  double points;  ///< of both phases
};
CaseCost case_cost(const solver::Case& scene);

/// Constants, s. `solver` by family; `judging`: reference values, errors and wave measures of a
/// case, and of each of its points.
struct CostConstants {
  std::array<CostTerms, cost_family_names.size()> solver;
  std::array<double, 2> judging;
};
/// Fitted by porowave-cost-fit (fit_main.cpp says how; ../cluster/scaling.md, how well).
const CostConstants& cost_constants();

double solver_seconds(const CaseCost& cost, const CostConstants& constants);
double judging_seconds(const CaseCost& cost, const CostConstants& constants);

/// CPU seconds that a case is predicted to take, without the profile of its reference: positive for
/// every case that can be read. On another machine they are to be multiplied by its speed
/// (cluster/machine_speed.hpp); their ratios hold as they are, and share cases out among tasks.
double predicted_seconds(const solver::Case& scene);
/// The same without errors, which is what Record::cpu_seconds measures.
double predicted_solver_seconds(const solver::Case& scene);

}  // namespace porowave::verification
