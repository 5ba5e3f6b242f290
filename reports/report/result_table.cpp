#include "reports/report/result_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/report/text_forms.hpp"

namespace porowave::reports {

namespace {

constexpr std::string_view none = "–";
/// Fields of more bytes may break anywhere and have a column of some width; page.js has it too.
constexpr std::size_t long_text = 28;
constexpr std::size_t rows_on_a_page = 40;

/// Fields by a function, with something between them.
template <class Form>
std::string joined(const std::vector<std::string>& fields, std::string_view between, Form form) {
  std::string text;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : between, form(fields[i]));
  }
  return text;
}

bool numeric_column(const ResultTable& table, std::size_t column) {
  bool any = false;
  for (const auto& row : table.rows) {
    if (row[column] == none) continue;
    char* end = nullptr;
    std::strtod(row[column].c_str(), &end);
    if (row[column].empty() || *end != '\0') return false;
    any = true;
  }
  return any;
}

}  // namespace

std::string as_csv(const ResultTable& table) {
  const auto field = [](const std::string& text) { return csv_field(text == none ? "" : text); };
  std::string text = joined(table.columns, ",", field) + "\n";
  for (const auto& row : table.rows) text += joined(row, ",", field) + "\n";
  return text;
}

std::string as_latex(const ResultTable& table) {
  const bool one_page = table.rows.size() <= rows_on_a_page;
  std::string columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    columns += numeric_column(table, c) ? 'r' : 'l';
  }
  const auto form = [](const std::string& text) {
    return text == none ? std::string("--") : latex_text(text);
  };
  const std::string header = joined(table.columns, " & ", form) + " \\\\\n";
  std::string text =
      fmt::format("% \\usepackage{{booktabs}}{}\n", one_page ? "" : " and \\usepackage{longtable}");
  if (one_page) {
    text += fmt::format(
        "\\begin{{table}}\n\\caption{{{}}}\n\\centering\n\\begin{{tabular}}{{{}}}\n\\toprule\n{}"
        "\\midrule\n",
        latex_text(table.caption), columns, header);
  } else {
    text += fmt::format(
        "\\begin{{longtable}}{{{}}}\n\\caption{{{}}}\\\\\n\\toprule\n{}\\midrule\n\\endhead\n",
        columns, latex_text(table.caption), header);
  }
  for (const auto& row : table.rows) text += joined(row, " & ", form) + " \\\\\n";
  text += "\\bottomrule\n";
  return text + (one_page ? "\\end{tabular}\n\\end{table}\n" : "\\end{longtable}\n");
}

std::string as_markdown(const ResultTable& table, std::size_t most) {
  std::string text = "| " + joined(table.columns, " | ", markdown_text) + " |\n|";
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    text += numeric_column(table, c) ? "--:|" : "---|";
  }
  text += "\n";
  const std::size_t shown = std::min(most, table.rows.size());
  for (std::size_t r = 0; r < shown; ++r) {
    text += "| " + joined(table.rows[r], " | ", markdown_text) + " |\n";
  }
  if (shown < table.rows.size()) {
    text += fmt::format("\n… and {} more in `{}.csv`\n", table.rows.size() - shown, table.name);
  }
  return text;
}

std::string as_html(const ResultTable& table, std::size_t most) {
  std::string text = fmt::format(
      "<div class=\"table\" id=\"table_{0}\"><div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"{1}\"><table><caption>{1} <a href=\"{0}.csv\">CSV</a> <a "
      "href=\"{0}.tex\">LaTeX</a></caption>\n<thead><tr>",
      table.name, html_text(table.caption));
  for (const auto& column : table.columns) {
    text += fmt::format("<th scope=\"col\">{}</th>", html_text(column));
  }
  text += "</tr></thead>\n<tbody>\n";
  const std::size_t shown = std::min(most, table.rows.size());
  for (std::size_t r = 0; r < shown; ++r) {
    text += "<tr>";
    for (const auto& field : table.rows[r]) {
      text += fmt::format("<td{}>{}</td>", field.size() > long_text ? " class=\"long\"" : "",
                          html_text(field));
    }
    text += "</tr>\n";
  }
  text += "</tbody></table></div>";
  if (shown < table.rows.size()) {
    text += fmt::format(
        "<p class=\"count\">{} of {} rows; all of them in <a href=\"{}.csv\">the "
        "CSV file</a></p>",
        shown, table.rows.size(), table.name);
  }
  return text + "</div>\n";
}

std::string error_text(double error) {
  return std::isfinite(error) ? fmt::format("{:.2e}", error) : std::string(none);
}

std::string number_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string(none);
}

}  // namespace porowave::reports
