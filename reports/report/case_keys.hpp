#pragma once

#include <map>
#include <string>
#include <vector>

#include "reference/problem/toml_value.hpp"
#include "verification/store/record.hpp"

namespace porowave::reports {

/// The keys of one case: "discretization.kernel" and its value.
using CaseKeys = std::map<std::string, TomlValue>;

/// Of a specification as a store has it. `name` is for messages. Throws InputError for what is not
/// TOML.
CaseKeys case_keys(const std::string& specification, const std::string& name);

/// A value for people: strings without quotes.
std::string shown(const TomlValue& value);

/// Whether a key says what is solved (material, load, end), not how.
bool is_of_problem(const std::string& key);

/// The last part of a key's name: "kernel".
std::string short_name(const std::string& key);

/// Sorts texts in natural order: numbers by size before words, words by alphabet. No text comes
/// twice.
std::vector<std::string> in_natural_order(std::vector<std::string> texts);

}  // namespace porowave::reports
