#include "reports/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace porowave::reports {

namespace {

using verification::Verdict;
using verification::VerdictKind;

/// XML has no way to write most control characters.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result;
}

std::string outcome(const Verdict& verdict) {
  const std::string reason = escaped(verdict.reason);
  const auto word = to_string(verdict.kind);
  switch (verdict.kind) {
    case VerdictKind::pass:
      return fmt::format("<system-out>{}</system-out>", reason);
    case VerdictKind::xfail:
      return fmt::format("<skipped message=\"{}: {}\"/>", word, reason);
    case VerdictKind::inconclusive:
      return fmt::format("<error type=\"{0}\" message=\"{1}\"/>", word, reason);
    default:
      return fmt::format("<failure type=\"{0}\" message=\"{1}\"/>", word, reason);
  }
}

}  // namespace

std::string junit_of(const std::string& study, const std::vector<Verdict>& verdicts) {
  const auto count = [&](std::initializer_list<VerdictKind> kinds) {
    return std::count_if(verdicts.begin(), verdicts.end(), [&](const Verdict& v) {
      return std::find(kinds.begin(), kinds.end(), v.kind) != kinds.end();
    });
  };
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
      escaped(study), verdicts.size(), count({VerdictKind::fail, VerdictKind::xpass}),
      count({VerdictKind::inconclusive}), count({VerdictKind::xfail}));
  for (const Verdict& v : verdicts) {
    text += fmt::format("  <testcase classname=\"{}\" name=\"{}\">{}</testcase>\n",
                        escaped(v.group), escaped(v.measure), outcome(v));
  }
  return text + "</testsuite>\n";
}

}  // namespace porowave::reports
