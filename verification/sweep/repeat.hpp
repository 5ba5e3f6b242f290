#pragma once

#include <string>

#include "verification/store/store.hpp"

namespace porowave::verification {

/// A stored case, and what the present program makes of it.
struct Repetition {
  Record stored;
  Record now;
  bool same = false;  ///< status the same and all errors equal to one part in a million
};

/// Runs the case of a row again, from the row's own specification. `id` may be the beginning of an
/// id if only one row has it. Throws InputError otherwise, or if the specification cannot be read.
Repetition repeat(const Store& store, const std::string& id);

/// Errors then and now, a line each, for people.
std::string comparison(const Repetition& repetition);

}  // namespace porowave::verification
