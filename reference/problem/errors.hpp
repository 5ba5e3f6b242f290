#pragma once

#include <stdexcept>
#include <string>

namespace porowave {

/// Wrong usage or input; the message names file, line, key, value and what was expected.
/// The program ends with exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run broke down numerically; the message says at which step and in which quantity.
/// The program ends with exit code 4.
struct BreakdownError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The machine does not offer what is needed (directory not writable, disk full, no gnuplot).
/// The program ends with exit code 5.
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace porowave
