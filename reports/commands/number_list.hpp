#pragma once

#include <string>
#include <vector>

namespace porowave::reports {

/// "a:b:n" (n evenly spaced numbers from a to b, ends included) or "a,b,c". Throws InputError that
/// names `option` and what was expected.
std::vector<double> parse_number_list(const std::string& text, const std::string& option);

}  // namespace porowave::reports
