#pragma once

// What documents and their sections share; for the two source files of theirs only.

#include <toml++/toml.h>

#include <map>
#include <optional>
#include <string>

#include "reference/problem/toml_document.hpp"

namespace porowave {

struct TomlDocument::Impl {
  toml::table table;
  std::map<std::string, int, std::less<>> lines;  ///< of values put in later, by "section.key"
};

struct TomlSection::Node {
  const toml::node* node;
};

/// A value as it stands in messages: on one line, and not too long.
std::string shown(const toml::node& node);
/// Empty for tables, dates and lists of other things than numbers.
std::optional<TomlValue> value_of(const toml::node& node);

}  // namespace porowave
