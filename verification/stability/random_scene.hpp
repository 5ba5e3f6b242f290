#pragma once

#include <cstdint>
#include <string>

#include "solver/case.hpp"

namespace porowave::verification {

/// A case drawn at random from nearly all that a case file may say: every scheme, transfer, kernel,
/// support, placement, velocity update and pair of ends, one to six points an element, sometimes a
/// gap; permeability 1e-16 to 1e-6 m^2, E_oed/K_f 1e-4 to 1e4, both even in the logarithm. 16 to 40
/// elements, no half-space, no load. The same number gives the same case everywhere.
solver::Case random_scene(std::uint64_t number);

/// The choices of a scene in one line.
std::string described(const solver::Case& scene);

}  // namespace porowave::verification
