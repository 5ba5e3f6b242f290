#pragma once

#include <cstddef>
#include <functional>

namespace porowave::reports {

/// Calls work(0), ..., work(count - 1), some at a time, on all cores. If some throw, one of the
/// exceptions is thrown again when all under way have ended; no further ones are begun.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace porowave::reports
