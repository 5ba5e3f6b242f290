#pragma once

// The exact solution under a step, written out from the reference's own pieces (modes, ends, rays)
// with every piece in the open, so that tests can exchange one for a wrong one. Each ray is
// inverted by Talbot's contour (Abate and Valko 2004), good to some 1e-8 of the load where drag is
// moderate.

#include <functional>
#include <vector>

#include "reference/rays.hpp"

namespace porowave::verification::faults {

struct ReferenceParts {
  std::function<void(Problem&)> problem = [](Problem&) {};
  std::function<reference::ModeState(const reference::WaveModes&, reference::Complex s)> modes =
      [](const reference::WaveModes& of, reference::Complex s) { return of.at(s); };
  std::function<void(reference::WaveState&)> state = [](reference::WaveState&) {};
  std::function<void(std::vector<reference::Ray>&)> rays = [](std::vector<reference::Ray>&) {};
  /// Weight of the contour's node on the real axis.
  double first_weight = 0.5;
};

/// Fields at x and t under a step of the problem's magnitude.
Fields open_reference(const Problem& problem, double x, double t, const ReferenceParts& parts = {});

}  // namespace porowave::verification::faults
