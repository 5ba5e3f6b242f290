#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace porowave::tests {

/// A table as text: the header, and the cells of every row.
struct CsvText {
  std::string header;
  std::vector<std::vector<std::string>> rows;
};

inline CsvText read_csv(const std::string& text) {
  CsvText csv;
  std::istringstream in(text);
  std::getline(in, csv.header);
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',') {
        cells.emplace_back();
      } else {
        cells.back() += c;
      }
    }
    csv.rows.push_back(cells);
  }
  return csv;
}

}  // namespace porowave::tests
