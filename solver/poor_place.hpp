#pragma once

// Places where points are too few for the transfer.

#include <string>

#include "solver/case.hpp"

namespace porowave::solver {

// What is poor within `reach` of x (both m) where the points of the case start, as words that
// follow a place; empty if nothing is:
//
//   mls          a node or the middle of a cell whose moment matrix does not carry the basis order
//   shape, apic  a node that has less than 0.45 of the mass of the column around it
//   staggered4   nothing is looked at
//
// The worst of both phases is named. Throws as ColumnSolver.
std::string poor_place(const Case& scene, double x, double reach);

}  // namespace porowave::solver
