#pragma once

// Faults planted on purpose: each is the right thing with one piece replaced by a wrong one, and
// says what must catch it. What catches nothing proves nothing; this proves that the checks catch.

#include <functional>
#include <string>
#include <vector>

namespace porowave::verification::faults {

/// What noticed a fault. Empty `how` if nothing did.
struct Catch {
  std::string by;   ///< the study or the check
  std::string how;  ///< verdict or message
};

struct Fault {
  std::string where;  ///< solver, kernel, reference, norm, order, gate
  std::string what;   ///< in words
  std::string named;  ///< what the verdict or message must contain
  std::function<Catch()> plant;
};

std::vector<Fault> solver_faults();
std::vector<Fault> point_faults();
std::vector<Fault> kernel_faults();
std::vector<Fault> reference_faults();
std::vector<Fault> norm_faults();
std::vector<Fault> order_faults();
std::vector<Fault> gate_faults();

}  // namespace porowave::verification::faults
