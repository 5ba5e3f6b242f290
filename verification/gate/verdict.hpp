#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace porowave::verification {

enum class VerdictKind {
  pass,
  fail,          ///< wrong, or better than expected: either way something has changed
  xfail,         ///< fails as the study says it does
  xpass,         ///< the study says it fails, and it does not
  inconclusive,  ///< the data do not tell; the reason says what is missing
};
inline constexpr std::array<std::string_view, 5> verdict_names = {"pass", "fail", "xfail", "xpass",
                                                                  "inconclusive"};
constexpr std::string_view to_string(VerdictKind kind) {
  return verdict_names[static_cast<std::size_t>(kind)];
}

/// The judgement of one measure of one group of cases, with a reason that a person can act on.
struct Verdict {
  std::string group;    ///< `discretization.kernel = "bspline1"`
  std::string measure;  ///< "effective_stress_field_l2"
  VerdictKind kind = VerdictKind::inconclusive;
  std::string reason;
};

/// What a failure or success becomes where the study says that it fails.
VerdictKind as_known_failure(VerdictKind kind);

/// Exit code of a gate: 1 if anything is fail or xpass; else 3 if anything is inconclusive or there
/// is nothing; else 0.
int exit_code(const std::vector<Verdict>& verdicts);

}  // namespace porowave::verification
