#pragma once

#include <span>
#include <vector>

namespace porowave::verification {

/// Shares out works, one after the other as they stand, each to the share with the least so far (of
/// several such to the first). Returns the share of each, counted from 0. The largest share is at
/// most 2 - 1/shares times as large as it must be (Graham 1969), of works in falling order 4/3.
std::vector<int> shared_out(std::span<const double> works, int shares);

/// The sum of every share.
std::vector<double> share_sums(std::span<const double> works, std::span<const int> share_of,
                               int shares);

}  // namespace porowave::verification
