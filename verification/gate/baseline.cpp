#include "verification/gate/baseline.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "reference/problem/errors.hpp"

namespace porowave::verification {

namespace {

constexpr std::string_view header =
    "group,measure,seeds,replicates,order,order_half,spacing,mean_log,sd_log";
constexpr std::size_t columns = 9;

std::string quoted_field(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

std::string field(const std::string& text) {
  return text.find_first_of(",\"") == std::string::npos ? text : quoted_field(text);
}

/// Fields of one line; "..." may hold commas and doubled quotes.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && inside && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (line[i] == '"') {
      inside = !inside;
    } else if (line[i] == ',' && !inside) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

double number_in(const std::string& text, const std::string& where) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw InputError(fmt::format("{}: {}: expected a number", where, text));
  }
  return value;
}

/// A whole number, 1 or more.
int count_in(const std::string& text, const std::string& where) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1) {
    throw InputError(
        fmt::format("{}: {}: expected a whole number of replicates, at least 1", where, text));
  }
  return value;
}

void read_row(const std::string& line, const std::string& where, Baseline& baseline) {
  const auto fields = split(line);
  if (fields.size() != columns) {
    throw InputError(fmt::format("{}: {} fields: expected {}", where, fields.size(), columns));
  }
  Expected& expected = baseline.expected[{fields[0], fields[1]}];
  expected.seeds = fields[2];
  expected.replicates = count_in(fields[3], where);
  expected.order = number_in(fields[4], where);
  expected.order_half = number_in(fields[5], where);
  expected.spacing.push_back(number_in(fields[6], where));
  expected.mean_log.push_back(number_in(fields[7], where));
  expected.sd_log.push_back(number_in(fields[8], where));
}

}  // namespace

Baseline baseline_of_text(const std::string& text, const std::string& path) {
  std::istringstream lines(text);
  Baseline baseline;
  bool in_table = false;
  int line_number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string where = fmt::format("{}:{}", path, ++line_number);
    if (line.empty()) continue;
    if (line.starts_with("# ") && !in_table) {
      baseline.history.push_back(line.substr(2));
    } else if (!in_table) {
      if (line != header) throw InputError(fmt::format("{}: expected \"{}\"", where, header));
      in_table = true;
    } else {
      read_row(line, where, baseline);
    }
  }
  if (!in_table) throw InputError(fmt::format("{}: expected \"{}\"", path, header));
  return baseline;
}

Baseline read_baseline(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be read: expected a baseline");
  return baseline_of_text({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()},
                          path);
}

std::string baseline_text(const Baseline& baseline) {
  std::string text;
  for (const std::string& reason : baseline.history) text += fmt::format("# {}\n", reason);
  text += fmt::format("{}\n", header);
  for (const auto& [key, expected] : baseline.expected) {
    for (std::size_t i = 0; i < expected.spacing.size(); ++i) {
      text += fmt::format("{},{},{},{},{:.4f},{:.4f},{},{:.6f},{:.6f}\n", quoted_field(key.first),
                          field(key.second), quoted_field(expected.seeds), expected.replicates,
                          expected.order, expected.order_half, expected.spacing[i],
                          expected.mean_log[i], expected.sd_log[i]);
    }
  }
  return text;
}

}  // namespace porowave::verification
