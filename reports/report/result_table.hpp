#pragma once

#include <string>
#include <vector>

namespace porowave::reports {

/// A table of a report, in any form. Numbers are texts already; "–" where there is none.
struct ResultTable {
  std::string name;     ///< of its files: letters, digits and _
  std::string caption;  ///< what it shows, in a sentence
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  void add(std::vector<std::string> row) { rows.push_back(std::move(row)); }
};

/// Header and rows; empty fields where there is no number.
std::string as_csv(const ResultTable& table);

/// With rules by the package booktabs; `longtable` beyond a page's rows. A comment names what it
/// needs.
std::string as_latex(const ResultTable& table);

/// The first `most` rows as GitHub shows them, and how many there are more.
std::string as_markdown(const ResultTable& table, std::size_t most);

/// A table of HTML with its first `most` rows and the number of all; page.js does the rest.
std::string as_html(const ResultTable& table, std::size_t most);

/// "1.2e-05", or "–" for what is not finite.
std::string error_text(double error);
/// With four digits, or "–".
std::string number_text(double value);

}  // namespace porowave::reports
