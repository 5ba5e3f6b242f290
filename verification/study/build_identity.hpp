#pragma once

#include <string_view>

namespace porowave::verification {

/// What the program was built from; set when it is built.
std::string_view program_version();  ///< "0.1.0"
std::string_view git_state();        ///< commit, with "-dirty" if files had changed; "unknown" else
std::string_view compiler();
std::string_view compiler_flags();
/// Hash of compiler, flags and the sources that decide numbers: those of reference, solver, and
/// norms. A change of anything else leaves results usable.
std::string_view numerics_hash();

}  // namespace porowave::verification
