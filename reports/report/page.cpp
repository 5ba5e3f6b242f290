#include "reports/report/page.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#include "reports/plot_templates.hpp"
#include "reports/report/run_sections.hpp"
#include "reports/report/summary.hpp"
#include "reports/report/text_forms.hpp"

namespace porowave::reports {

namespace fs = std::filesystem;

namespace {

/// Rows that stand in the page itself, for readers without scripts and on paper.
constexpr std::size_t static_rows = 200;
/// Of tables that stand before the figures.
constexpr std::size_t first_rows = 25;

std::string file_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Width and height in pixels as attributes; gnuplot's "dynamic" pictures have them in viewBox
/// only.
std::string size_attributes(const std::string& svg) {
  const auto at = svg.find("viewBox=\"0 0 ");
  int width = 0;
  int height = 0;
  if (at == std::string::npos ||
      std::sscanf(svg.c_str() + at, "viewBox=\"0 0 %d %d\"", &width, &height) != 2) {
    return "";
  }
  return fmt::format(" width=\"{}\" height=\"{}\"", width, height);
}

std::string figure_html(const ReportFigure& figure, const fs::path& directory) {
  const std::string& name = figure.figure.name;
  const std::string svg = file_text(directory / (name + ".svg"));
  std::string text = fmt::format(
      "<figure id=\"figure_{0}\"><div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Figure {0}\"><img alt=\"{1}\"{2} src=\"data:image/svg+xml;base64,{3}\"></div>\n"
      "<figcaption>{4} <span class=\"files\">",
      name, html_text(figure.alt), size_attributes(svg), base64(svg), html_text(figure.claim));
  for (const auto& [ending, title] : {std::pair("svg", "SVG"), std::pair("pdf", "PDF"),
                                      std::pair("png", "PNG"), std::pair("gp", "script")}) {
    text +=
        fmt::format("<a href=\"{0}.{1}\" aria-label=\"{2} of {0}\">{2}</a> ", name, ending, title);
  }
  text += fmt::format("<a href=\"{}\" aria-label=\"data of {}\">data</a> ",
                      figure.figure.data_file(), name);
  return text + "</span></figcaption></figure>\n";
}

std::string notes_html(const std::vector<std::string>& notes) {
  if (notes.empty()) return "";
  std::string text = "<ul>";
  for (const std::string& note : notes) text += fmt::format("<li>{}</li>", html_text(note));
  return text + "</ul>\n";
}

std::string runs_html(const ReportContent& content, const fs::path& directory) {
  std::string text;
  for (const StudyReport& study : content.studies) {
    const bool named = content.studies.size() > 1;
    for (const RunSection& section : study.runs) {
      text += fmt::format("<h3>{}{}</h3>\n",
                          named ? html_text(study.table.study + ", ") : std::string(),
                          html_text(section.heading));
      text += notes_html(section.notes);
      for (const ReportFigure& figure : section.figures) text += figure_html(figure, directory);
    }
  }
  if (text.empty() && content.run_notes.empty()) {
    text = "<p>None: no case to choose, or --runs 0.</p>\n";
  }
  return fmt::format("<h2>Runs</h2>\n<p>{}</p>\n{}{}", html_text(rule_of_runs(content.options)),
                     notes_html(content.run_notes), text);
}

std::string figures_html(const ReportContent& content, const fs::path& directory) {
  std::string text;
  for (const StudyReport& study : content.studies) {
    if (study.figures.empty()) continue;
    text += fmt::format("<h2>Figures: {}</h2>\n", html_text(study.table.study));
    std::string heading;
    for (const ReportFigure& figure : study.figures) {
      if (figure.heading != heading) {
        heading = figure.heading;
        text += fmt::format("<h3>{}</h3>\n", html_text(heading));
      }
      text += figure_html(figure, directory);
    }
  }
  return text.empty() ? "<h2>Figures</h2><p>No case has ended with an error to draw.</p>\n" : text;
}

std::string constants_html(const StudyReport& study) {
  std::string text =
      fmt::format("<details><summary>What all cases of {} have in common</summary><dl>",
                  html_text(study.table.study));
  for (const auto& [key, value] : study.table.constants) {
    text += fmt::format("<dt>{}</dt><dd>{}</dd>", html_text(key), html_text(value));
  }
  return text + "</dl></details>\n";
}

/// A class for the outcome's colour; its word stands beside it.
std::string outcome_class(const ReportContent& content) {
  if (!content.verdicts) return "neutral";
  constexpr std::array<const char*, 4> classes = {"good", "bad", "neutral", "unsure"};
  return classes[static_cast<std::size_t>(verification::exit_code(*content.verdicts))];
}

std::string verdict_html(const ReportContent& content) {
  std::string text =
      fmt::format("<h2 id=\"verdicts\">Verdicts</h2>\n<p class=\"outcome {}\">{}</p>\n",
                  outcome_class(content), html_text(outcome_line(content)));
  if (const std::string note = build_note(content); !note.empty()) {
    text += fmt::format("<p>{}</p>\n", html_text(note));
  }
  if (content.comparison) {
    text += fmt::format("<p>Compared with {}: {}.</p>\n", html_text(content.comparison->after),
                        html_text(comparison_line(content)));
  }
  text += "<ul>";
  for (const StudyReport& study : content.studies) {
    text += fmt::format("<li>{}</li>", html_text(study_line(study)));
  }
  text += "</ul>\n";
  if (!failures_table(content).rows.empty()) {
    text += "<p>Cases that did not end: <a href=\"#table_failures\">table of failures</a></p>\n";
  }
  if (content.studies.empty()) {
    text += fmt::format("<p>Fill it: <code>porowave sweep STUDY.toml --store {}</code></p>\n",
                        html_text(shell_word(content.options.store)));
  } else if (!content.verdicts) {
    text += fmt::format(
        "<p>For verdicts: <code>porowave report {} --output DIR --study STUDY.toml --baseline "
        "FILE</code></p>\n",
        html_text(shell_word(content.options.store)));
  }
  return text;
}

bool comes_first(const ResultTable& table) {
  return table.name == "verdicts" || table.name == "comparison";
}

std::string tables_html(const std::vector<ResultTable>& tables, bool first) {
  std::string text;
  for (const ResultTable& table : tables) {
    if (comes_first(table) == first) text += as_html(table, first ? first_rows : static_rows);
  }
  return text;
}

std::string title_of(const ReportContent& content) {
  std::string title;
  for (const StudyReport& study : content.studies) {
    title += (title.empty() ? "" : ", ") + study.table.study;
  }
  return title.empty() ? "empty store" : title;
}

}  // namespace

std::string page_html(const ReportContent& content, const fs::path& directory) {
  const auto tables = tables_of(content);
  const std::string title = html_text(title_of(content));
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>{} · porowave report</title>\n<style>\n{}</style></head>\n"
      "<body><a class=\"skip\" href=\"#verdicts\">Skip to the verdicts</a>\n"
      "<header><h1>{}</h1><p>Report of the store <code>{}</code></p>\n"
      "<nav aria-label=\"Parts\"><a href=\"#verdicts\">Verdicts</a> <a "
      "href=\"#figures\">Figures</a> "
      "<a href=\"#runs\">Runs</a> "
      "<a href=\"#tables\">Tables</a></nav></header>\n<main>\n",
      title, plot_template("page.css"), title, html_text(content.options.store));
  text += "<section>" + verdict_html(content) + tables_html(tables, true) + "</section>\n";
  if (!content.studies.empty()) {
    text += "<section id=\"figures\">" + figures_html(content, directory) + "</section>\n";
    text += "<section id=\"runs\">" + runs_html(content, directory) + "</section>\n";
    text +=
        "<section id=\"tables\"><h2>Tables</h2>\n<form id=\"find\" class=\"script\"><label>Case "
        "by the beginning of its id <input name=\"id\" size=\"20\" "
        "autocomplete=\"off\"></label> <button>Open</button> <span role=\"status\"></span>"
        "</form>\n";
    text += tables_html(tables, false);
    for (const StudyReport& study : content.studies) text += constants_html(study);
    text += "</section>\n";
  }
  text += "</main>\n<dialog id=\"case\" aria-labelledby=\"case_title\"></dialog>\n";
  text += "<script type=\"application/json\" id=\"data\">" + page_data(content) + "</script>\n";
  return text + "<script>\n" + plot_template("page.js") + "</script>\n</body></html>\n";
}

}  // namespace porowave::reports
