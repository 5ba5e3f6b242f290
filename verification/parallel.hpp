#pragma once

#include <cstddef>
#include <functional>

namespace porowave::verification {

/// Calls work(0), ..., work(count - 1), begun in this order, `threads` at a time (0: on all cores).
/// If some throw, no further ones are begun, and when all under way have ended the exception of the
/// first in this order is thrown again, however the threads were scheduled.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work,
                  std::size_t threads = 0);

}  // namespace porowave::verification
