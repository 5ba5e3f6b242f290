#pragma once

#include <string>
#include <string_view>

#include "solver/case.hpp"

namespace porowave::verification {

/// 32 hexadecimal digits: FNV-1a of 128 bits (Fowler, Noll & Vo). Not for secrets; among 10^9 texts
/// two are equal by chance with probability 2e-21.
std::string text_hash(std::string_view text);

/// Identity of a case: hash of its specification, of the content of the files it names (the table
/// of a load) and of the program's numerics (build_identity.hpp). Equal ids give equal results.
std::string case_id(std::string_view specification, const solver::Case& scene);

}  // namespace porowave::verification
