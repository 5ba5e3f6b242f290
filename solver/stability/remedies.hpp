#pragma once

// What a person can change in a case that has no stable time step.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case.hpp"

namespace porowave::solver {

struct Remedy {
  std::string text;  // as in a case file
  Case scene;        // with it
};

// Changes that the case's method allows, those that cost least accuracy and time first.
std::vector<Remedy> remedies(const Case& scene);

// The first two of them with which noise grows less than tenfold in a run up to `end` (s) at one
// of the Courant numbers 0.8, 0.6, 0.4, 0.2, as text: a or b. Empty if none helps. For up to some
// 50 elements.
std::string remedies_that_help(const Case& scene, double end);

}  // namespace porowave::solver
