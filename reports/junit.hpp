#pragma once

#include <string>
#include <vector>

#include "verification/gate/verdict.hpp"

namespace porowave::reports {

/// Verdicts as JUnit XML, a test case each: fail and xpass are failures, inconclusive is an error,
/// xfail is skipped.
std::string junit_of(const std::string& study, const std::vector<verification::Verdict>& verdicts);

}  // namespace porowave::reports
