#pragma once

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/problem/range.hpp"

namespace porowave {

/// Reads a table of comma-separated values row by row, so that a file of any size takes little
/// memory. The first row that is neither blank nor a comment (# in front) names the columns.
///
/// Accepted: LF and CRLF, a byte order mark of UTF-8, blank lines, comment lines, spaces around
/// values, and quoted values ("a ""b""", closed on their line). Every row must have as many values
/// as there are columns.
///
/// All errors are InputError and read like "points.csv:7: x 0.2: expected a number >= 0".
class CsvReader {
 public:
  /// Opens a file and reads its header. Throws if it cannot be read or has no header. Messages name
  /// it by `shown_as` if that is not empty.
  static CsvReader open(const std::string& path, const std::string& shown_as = {});
  /// The same for text; `path` is only the name used in messages.
  static CsvReader of_text(std::string text, const std::string& path);
  CsvReader(CsvReader&&) noexcept;
  ~CsvReader();

  const std::string& path() const { return path_; }
  const std::vector<std::string>& columns() const { return columns_; }
  /// Index of a column; none if there is no such column. Throws if there are two.
  std::optional<std::size_t> find(std::string_view column) const;
  /// The same for a column that has to be there.
  std::size_t require(std::string_view column, std::string_view expected) const;

  /// Reads the next row; false at the end.
  bool next();
  long line() const { return line_; }  ///< of the row read last, counted from 1
  const std::string& cell(std::size_t column) const { return cells_[column]; }
  /// A finite number in the range.
  double number(std::size_t column, const Range& range = {}) const;

  /// Refuses the value of a column in this row.
  [[noreturn]] void refuse(std::size_t column, std::string_view expected) const;
  /// Refuses something else at this line.
  [[noreturn]] void refuse_line(std::string_view what, std::string_view expected) const;

 private:
  CsvReader(std::unique_ptr<std::istream> in, std::string path);
  bool read_line();
  void read_header();
  void split();

  std::unique_ptr<std::istream> in_;
  std::string path_;
  long line_ = 0;
  long header_line_ = 0;
  std::string text_;  ///< of the line
  std::vector<std::string> columns_;
  std::vector<std::string> cells_;
};

}  // namespace porowave
