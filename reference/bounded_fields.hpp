#pragma once

#include "reference/problem/problem.hpp"

namespace porowave::reference {

/// Values at one point and time, each with a bound or estimate of its own error (same unit). A
/// value that could not be resolved is NaN with an error of infinity.
struct BoundedFields {
  Fields value;
  Fields error;
};

}  // namespace porowave::reference
