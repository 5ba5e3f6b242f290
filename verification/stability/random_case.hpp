#pragma once

#include <cstdint>
#include <string>

namespace porowave::verification {

/// A case file drawn at random from all that a case file may say but for tables of loads, with
/// courant = "auto": every scheme, transfer, kernel, support, basis order, strain, placement,
/// velocity update, pair of ends and shape of load; every choice is left to its default in a third
/// of the files. 1 to 8 points an element, in a quarter of them a gap of 1 to 3 elements;
/// permeability 1e-16 to 1e-6 m^2, E_oed/K_f 1e-4 to 1e4, loads that strain by 1e-14 to 1e-6, all
/// even in the logarithm. 12 to 32 elements, 200 to 3000 steps at courant 0.5. The same number
/// gives the same text everywhere.
std::string random_case(std::uint64_t number);

}  // namespace porowave::verification
