#pragma once

#include <string>
#include <vector>

namespace porowave::reports {

/// "a:b:n" (n evenly spaced numbers from a to b, ends included) or "a,b,c". Throws InputError that
/// names `option` and what was expected.
std::vector<double> parse_number_list(const std::string& text, const std::string& option);

/// The same for numbers > 0, where "a:b:n" is n numbers evenly spaced in the logarithm.
std::vector<double> parse_positive_list(const std::string& text, const std::string& option);

}  // namespace porowave::reports
