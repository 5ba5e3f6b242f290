#include "reference/problem/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "reference/problem/errors.hpp"

namespace porowave {

namespace {

/// A file without line ends would be read into memory as a whole.
constexpr std::size_t longest_line = 1'000'000;
constexpr std::size_t longest_shown = 60;

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// On one line and short, whatever the value holds.
std::string shown(std::string_view value) {
  if (value.empty()) return "(empty)";
  std::string text(value.substr(0, longest_shown));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return value.size() > longest_shown ? text + "..." : text;
}

std::optional<double> parsed(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

CsvReader::CsvReader(CsvReader&&) noexcept = default;
CsvReader::~CsvReader() = default;

CsvReader::CsvReader(std::unique_ptr<std::istream> in, std::string path)
    : in_(std::move(in)), path_(std::move(path)) {
  read_header();
}

CsvReader CsvReader::open(const std::string& path, const std::string& shown_as) {
  const std::string& name = shown_as.empty() ? path : shown_as;
  std::error_code ignored;
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file || std::filesystem::is_directory(path, ignored)) {
    throw InputError(fmt::format("{}: cannot be read: expected a CSV file", name));
  }
  return {std::move(file), name};
}

CsvReader CsvReader::of_text(std::string text, const std::string& path) {
  return {std::make_unique<std::istringstream>(std::move(text)), path};
}

/// The next line that is neither blank nor a comment.
bool CsvReader::read_line() {
  std::streambuf& in = *in_->rdbuf();
  for (;;) {
    text_.clear();
    ++line_;
    int c = in.sbumpc();
    if (c == std::char_traits<char>::eof()) return false;
    for (; c != '\n' && c != std::char_traits<char>::eof(); c = in.sbumpc()) {
      text_.push_back(static_cast<char>(c));
      if (text_.size() > longest_line) {
        refuse_line(fmt::format("more than {} characters", longest_line), "lines of a table");
      }
    }
    if (line_ == 1 && text_.starts_with("\xef\xbb\xbf")) text_.erase(0, 3);
    const std::string_view content = trimmed(text_);
    if (!content.empty() && content.front() != '#') return true;
  }
}

void CsvReader::split() {
  cells_.clear();
  const std::string_view text = text_;
  for (std::size_t at = 0;; ++at) {
    const auto first = text.find_first_not_of(" \t", at);
    auto comma = text.find(',', at);
    if (first == std::string_view::npos || text[first] != '"') {
      cells_.emplace_back(trimmed(text.substr(at, comma == text.npos ? comma : comma - at)));
    } else {
      std::string& cell = cells_.emplace_back();
      std::size_t i = first + 1;
      for (; i < text.size() && (text[i] != '"' || text.substr(i, 2) == "\"\""); ++i) {
        if (text[i] == '"') ++i;
        cell.push_back(text[i]);
      }
      comma = text.find(',', i);
      const bool closed = i < text.size();
      if (!closed ||
          !trimmed(text.substr(i + 1, comma == text.npos ? comma : comma - i - 1)).empty()) {
        refuse_line(shown(text.substr(first)), "a quote that is closed before the next comma");
      }
    }
    if (comma == std::string_view::npos) return;
    at = comma;
  }
}

void CsvReader::read_header() {
  if (!read_line()) {
    throw InputError(
        fmt::format("{}: no header: expected a first row with the names of the columns", path_));
  }
  if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff")) {
    refuse_line("UTF-16", "text in UTF-8");
  }
  split();
  header_line_ = line_;
  columns_ = cells_;
  if (columns_.size() == 1 && columns_[0].find_first_of(";\t") != std::string::npos) {
    refuse_line(shown(columns_[0]), "commas between the columns");
  }
  if (std::all_of(columns_.begin(), columns_.end(), [](const auto& c) { return parsed(c); })) {
    refuse_line(shown(text_), "the names of the columns before the numbers, not in a comment");
  }
}

bool CsvReader::next() {
  if (!read_line()) return false;
  split();
  if (cells_.size() != columns_.size()) {
    refuse_line(
        fmt::format("{} values", cells_.size()),
        fmt::format("{}, as many as there are columns in line {}", columns_.size(), header_line_));
  }
  return true;
}

std::optional<std::size_t> CsvReader::find(std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return std::nullopt;
  if (std::find(found + 1, columns_.end(), column) != columns_.end()) {
    throw InputError(fmt::format("{}:{}: {} appears twice: expected one column of that name", path_,
                                 header_line_, shown(column)));
  }
  return static_cast<std::size_t>(found - columns_.begin());
}

std::size_t CsvReader::require(std::string_view column, std::string_view expected) const {
  if (const auto found = find(column)) return *found;
  throw InputError(fmt::format("{}:{}: {} is missing: expected {}", path_, header_line_,
                               shown(column), expected));
}

double CsvReader::number(std::size_t column, const Range& range) const {
  const auto value = parsed(cells_[column]);
  if (!value || !range.contains(*value)) refuse(column, range.text());
  return *value;
}

void CsvReader::refuse(std::size_t column, std::string_view expected) const {
  refuse_line(fmt::format("{} {}", shown(columns_[column]), shown(cells_[column])), expected);
}

void CsvReader::refuse_line(std::string_view what, std::string_view expected) const {
  throw InputError(fmt::format("{}:{}: {}: expected {}", path_, line_, what, expected));
}

}  // namespace porowave
