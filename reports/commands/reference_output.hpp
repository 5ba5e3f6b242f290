#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "reference/column_solution.hpp"
#include "reference/energy.hpp"

namespace porowave::reports {

/// Header of the columns that --derived appends, beginning with a comma.
extern const char* const derived_header;
/// Their cells for one point and time; the values first, then their errors.
std::string derived_cells(const reference::DerivedFields& derived);

/// The table of --energy: a row for each time.
void write_energy_csv(std::span<const reference::EnergyBalance> balances, std::ostream& out);

/// What `porowave reference --energy` does: balances of a problem at the times, to a file or (if
/// `output` is empty) to standard output. Returns the exit code.
int run_energy(const Problem& problem, const std::vector<double>& times, const std::string& output);

}  // namespace porowave::reports
