#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace porowave {

/// A value of a TOML file that may stand for any key: what the axes of a study are made of.
struct TomlValue {
  std::variant<bool, std::int64_t, double, std::string, std::vector<double>> value;
  int line = 0;  ///< where it stands in its file

  /// As TOML: true, 5, 0.5, "word", [0.1, 0.2]; numbers to all their digits.
  std::string text() const;
};

/// Equal values; 5 and 5.0 are.
bool same_value(const TomlValue& a, const TomlValue& b);

}  // namespace porowave
