#include "verification/gate/verdict.hpp"

#include <algorithm>

namespace porowave::verification {

VerdictKind as_known_failure(VerdictKind kind) {
  if (kind == VerdictKind::fail) return VerdictKind::xfail;
  if (kind == VerdictKind::pass) return VerdictKind::xpass;
  return kind;
}

int exit_code(const std::vector<Verdict>& verdicts) {
  const auto any = [&](VerdictKind kind) {
    return std::any_of(verdicts.begin(), verdicts.end(),
                       [kind](const Verdict& v) { return v.kind == kind; });
  };
  if (any(VerdictKind::fail) || any(VerdictKind::xpass)) return 1;
  return verdicts.empty() || any(VerdictKind::inconclusive) ? 3 : 0;
}

}  // namespace porowave::verification
