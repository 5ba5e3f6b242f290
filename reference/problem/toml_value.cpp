#include "reference/problem/toml_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

namespace porowave {

namespace {

std::string number_text(double number) {
  std::string text = fmt::format("{}", number);
  // A TOML float has a point or an exponent.
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

std::string quoted(const std::string& word) {
  std::string text = "\"";
  for (const char c : word) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
      text += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    } else {
      if (c == '"' || c == '\\') text += '\\';
      text += c;
    }
  }
  return text + '"';
}

}  // namespace

std::string TomlValue::text() const {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  if (const auto* word = std::get_if<std::string>(&value)) return quoted(*word);
  std::vector<std::string> entries;
  for (const double number : std::get<std::vector<double>>(value)) {
    entries.push_back(number_text(number));
  }
  return fmt::format("[{}]", fmt::join(entries, ", "));
}

bool same_value(const TomlValue& a, const TomlValue& b) {
  const auto number = [](const TomlValue& v) -> std::optional<double> {
    if (const auto* integer = std::get_if<std::int64_t>(&v.value)) {
      return static_cast<double>(*integer);
    }
    if (const auto* real = std::get_if<double>(&v.value)) return *real;
    return std::nullopt;
  };
  const auto first = number(a);
  const auto second = number(b);
  return first && second ? *first == *second : a.value == b.value;
}

}  // namespace porowave
