#pragma once

#include <mutex>

namespace porowave::reference {

/// Making and destroying plans is all of FFTW that must not happen in two threads at once: one lock
/// for the whole program.
std::mutex& fftw_planning();

}  // namespace porowave::reference
