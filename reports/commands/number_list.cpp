#include "reports/commands/number_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "reference/problem/errors.hpp"

namespace porowave::reports {

namespace {

constexpr double most_numbers = 1e8;

[[noreturn]] void refuse(const std::string& text, const std::string& option) {
  throw InputError(
      fmt::format("{} {}: expected numbers as FIRST:LAST:COUNT or as a comma list", option, text));
}

std::vector<double> numbers_between(const std::string& text, char separator,
                                    const std::string& option) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    double value = 0.0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) refuse(text, option);
    numbers.push_back(value);
    if (next == end) return numbers;
    if (*next != separator) refuse(text, option);
    at = next + 1;
  }
}

}  // namespace

std::vector<double> parse_number_list(const std::string& text, const std::string& option) {
  if (text.find(':') == std::string::npos) return numbers_between(text, ',', option);
  const auto range = numbers_between(text, ':', option);
  if (range.size() != 3 || range[2] < 1 || range[2] > most_numbers ||
      range[2] != std::floor(range[2])) {
    refuse(text, option);
  }
  const auto count = static_cast<std::size_t>(range[2]);
  std::vector<double> numbers(count, range[0]);
  for (std::size_t i = 1; i < count; ++i) {
    numbers[i] = i + 1 == count ? range[1]
                                : range[0] + (range[1] - range[0]) * static_cast<double>(i) /
                                                 static_cast<double>(count - 1);
  }
  return numbers;
}

std::vector<double> parse_positive_list(const std::string& text, const std::string& option) {
  auto numbers = parse_number_list(text, option);
  if (std::any_of(numbers.begin(), numbers.end(), [](double number) { return number <= 0.0; })) {
    throw InputError(fmt::format("{} {}: expected numbers > 0", option, text));
  }
  if (text.find(':') == std::string::npos) return numbers;
  // To the base 10, so that decades are met exactly.
  const double first = std::log10(numbers.front());
  const double last = std::log10(numbers.back());
  for (std::size_t i = 1; i + 1 < numbers.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(numbers.size() - 1);
    numbers[i] = std::pow(10.0, first + share * (last - first));
  }
  return numbers;
}

}  // namespace porowave::reports
