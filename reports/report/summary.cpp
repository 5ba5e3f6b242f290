#include "reports/report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "reports/report/text_forms.hpp"
#include "verification/study/build_identity.hpp"

namespace porowave::reports {

namespace {

constexpr std::size_t most_rows = 12;

std::string verdict_line(const std::vector<verification::Verdict>& verdicts) {
  std::array<std::size_t, verification::verdict_names.size()> count{};
  for (const auto& v : verdicts) ++count[static_cast<std::size_t>(v.kind)];
  constexpr std::array<const char*, 4> words = {"pass", "fail", "", "inconclusive"};
  std::string text = words[static_cast<std::size_t>(verification::exit_code(verdicts))];
  for (std::size_t k = 0; k < count.size(); ++k) {
    text += fmt::format("{}{} {}", k == 0 ? ": " : ", ", count[k], verification::verdict_names[k]);
  }
  return text;
}

std::string order_line(const ReportContent& content) {
  std::array<std::size_t, verification::order_status_names.size()> count{};
  std::size_t groups = 0;
  for (const StudyReport& study : content.studies) {
    for (const GroupSummary& summary : study.summaries.front()) {
      ++count[static_cast<std::size_t>(summary.order.status)];
      ++groups;
    }
  }
  constexpr std::array<const char*, 5> words = {"have an observed order", "too few levels",
                                                "with errors missing", "not yet asymptotic",
                                                "at a floor"};
  std::string text;
  for (std::size_t k = 0; k < count.size(); ++k) {
    if (count[k] == 0 && k != 0) continue;
    text += fmt::format("{}{} {}", k == 0 ? "" : ", ", count[k], words[k]);
  }
  return fmt::format("of {} groups {}", groups, text);
}

std::vector<ResultTable> shown_tables(const ReportContent& content) {
  auto tables = tables_of(content);
  std::erase_if(tables, [](const ResultTable& t) {
    return t.name.starts_with("groups") || t.name == "provenance";
  });
  for (ResultTable& table : tables) {
    // What passes, and what has not changed, needs no reader.
    std::erase_if(table.rows, [&](const std::vector<std::string>& row) {
      return (table.name == "verdicts" && (row[0] == "pass" || row[0] == "xfail")) ||
             (table.name == "comparison" && row[0] == "same");
    });
  }
  std::erase_if(tables, [](const ResultTable& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace

std::string outcome_line(const ReportContent& content) {
  if (content.verdicts) return verdict_line(*content.verdicts);
  if (content.studies.empty()) return "the store holds no cases";
  return "no verdicts (no study file was given); " + order_line(content);
}

std::string study_line(const StudyReport& report) {
  std::string text = fmt::format("{}: {} cases", report.table.study, report.table.rows.size());
  constexpr std::array<const char*, 4> words = {"done", "broke down", "refused", "failed"};
  for (std::size_t s = 0; s < words.size(); ++s) {
    if (report.by_status[s] > 0) text += fmt::format(", {} {}", report.by_status[s], words[s]);
  }
  return text + fmt::format("; {} groups", report.table.groups.size());
}

std::string comparison_line(const ReportContent& content) {
  if (!content.comparison) return "";
  std::map<std::string, std::size_t> count;
  for (const ComparedGroup& g : content.comparison->groups) ++count[g.verdict];
  std::string text =
      fmt::format("{} better, {} worse, {} same", count["better"], count["worse"], count["same"]);
  if (count["nothing in common"] > 0) {
    text += fmt::format(", {} with no case in common", count["nothing in common"]);
  }
  return text + fmt::format("; cases only before {}, only after {}",
                            content.comparison->only_before, content.comparison->only_after);
}

std::string build_note(const ReportContent& content) {
  const auto& builds = content.provenance;
  const bool foreign =
      std::none_of(builds.begin(), builds.end(), [](const verification::Provenance& p) {
        return p.numerics == verification::numerics_hash();
      });
  if (!content.verdicts || builds.empty() || !foreign) return "";
  return "The cases of this store were run by builds with other numerics than this program's, so "
         "the verdicts do not find them: judge with the program that ran them, or sweep again.";
}

std::string summary_markdown(const ReportContent& content) {
  std::string text =
      fmt::format("## porowave report\n\n**{}**\n\n", markdown_text(outcome_line(content)));
  for (const StudyReport& study : content.studies) {
    text += fmt::format("- {}\n", markdown_text(study_line(study)));
  }
  if (const std::string note = build_note(content); !note.empty()) text += "- " + note + "\n";
  if (content.comparison) {
    text += fmt::format("- compared with {}: {}\n", markdown_text(content.comparison->after),
                        comparison_line(content));
  }
  if (content.studies.empty()) {
    text += fmt::format("Fill it: `porowave sweep STUDY.toml --store {}`\n",
                        shell_word(content.options.store));
  }
  for (const ResultTable& table : shown_tables(content)) {
    text +=
        fmt::format("\n### {}\n\n{}", markdown_text(table.caption), as_markdown(table, most_rows));
  }
  for (const StudyReport& study : content.studies) {
    for (const ReportFigure& figure : study.figures) {
      if (figure.heading == "Convergence" || figure.heading == "Heat maps") continue;
      text += fmt::format("\n![{}]({}.png)\n", markdown_text(figure.alt), figure.figure.name);
    }
  }
  return text;
}

}  // namespace porowave::reports
