#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace porowave {

/// The values that a number may take, and how to say so in a message.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;   ///< low itself is not allowed
  bool high_open = false;  ///< high itself is not allowed

  bool contains(double value) const;
  std::string text() const;  ///< for instance "a number > 0"

  static Range positive() { return {0.0, std::numeric_limits<double>::infinity(), true, true}; }
  static Range inside(double low, double high) { return {low, high, true, true}; }
  static Range between(double low, double high) { return {low, high, false, false}; }
};

/// The known word nearest to a misspelt one, if one is near enough to suggest.
std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> known);

/// The known words, or the one that was probably meant: "did you mean x?".
std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace porowave
