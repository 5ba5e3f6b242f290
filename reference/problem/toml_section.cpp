#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "reference/problem/errors.hpp"
#include "reference/problem/toml_implementation.hpp"

namespace porowave {

namespace {

constexpr std::int64_t most_values = 1'000'000;

std::string known_words(std::span<const std::string> known) {
  return fmt::format("{}", fmt::join(known, ", "));
}

}  // namespace

TomlSection::TomlSection(const TomlDocument& document, std::string name,
                         std::optional<std::size_t> index)
    : document_(&document), name_(std::move(name)), index_(index) {}

TomlSection::Node TomlSection::at(std::string_view key) const {
  const auto found = std::as_const(document_->impl_->table)[name_];
  return {index_ ? found[*index_][key].node() : found[key].node()};
}

int TomlSection::line_of(std::string_view key, const Node& node) const {
  const auto& lines = document_->impl_->lines;
  const auto put_in = lines.find(fmt::format("{}.{}", name_, key));
  return put_in != lines.end() ? put_in->second : static_cast<int>(node.node->source().begin.line);
}

bool TomlSection::present() const {
  return document_->impl_->table.contains(name_);
}

std::optional<TomlSection::Node> TomlSection::find(std::string_view key) {
  known_.emplace(key);
  const Node node = at(key);
  return node.node ? std::optional<Node>(node) : std::nullopt;
}

bool TomlSection::has(std::string_view key) {
  return find(key).has_value();
}

bool TomlSection::is_text(std::string_view key) {
  const auto node = find(key);
  return node && node->node->is_string();
}

void TomlSection::refuse(std::string_view key, std::string_view expected) const {
  const toml::node* node = at(key).node;
  if (!node) {
    throw InputError(
        fmt::format("{}: [{}] {} is missing: expected {}", document_->path_, name_, key, expected));
  }
  throw InputError(fmt::format("{}:{}: [{}] {} = {}: expected {}", document_->path_,
                               line_of(key, {node}), name_, key, shown(*node), expected));
}

TomlSection::Node TomlSection::require(std::string_view key, std::string_view expected) {
  const auto node = find(key);
  if (!node) refuse(key, expected);
  return *node;
}

double TomlSection::checked_number(std::string_view key, const Node& node,
                                   const Range& range) const {
  const auto value = node.node->value<double>();
  if (!node.node->is_number() || !value || !range.contains(*value)) refuse(key, range.text());
  return *value;
}

double TomlSection::number(std::string_view key, const Range& range) {
  const auto node = find(key);
  if (!node) refuse(key, range.text());
  return checked_number(key, *node, range);
}

std::optional<double> TomlSection::number_if(std::string_view key, const Range& range) {
  const auto node = find(key);
  return node ? std::optional<double>(checked_number(key, *node, range)) : std::nullopt;
}

double TomlSection::number_or(std::string_view key, double fallback, const Range& range) {
  return number_if(key, range).value_or(fallback);
}

long TomlSection::integer_or(std::string_view key, long fallback, long low, long high) {
  return find(key) ? integer(key, low, high) : fallback;
}

long TomlSection::integer(std::string_view key, long low, long high) {
  const auto node = find(key);
  const auto* value = node ? node->node->as_integer() : nullptr;
  if (!value || value->get() < low || value->get() > high) {
    refuse(key, fmt::format("a whole number from {} to {}", low, high));
  }
  return static_cast<long>(value->get());
}

std::string TomlSection::text(std::string_view key) {
  const Node node = require(key, "a string");
  const auto* value = node.node->as_string();
  if (!value) refuse(key, "a string");
  return value->get();
}

std::string TomlSection::text_or(std::string_view key, std::string fallback) {
  return find(key) ? text(key) : std::move(fallback);
}

std::vector<double> TomlSection::numbers_or(std::string_view key, std::vector<double> fallback,
                                            const Range& range) {
  const auto node = find(key);
  if (!node) return fallback;
  const auto expected = [&] { return fmt::format("a list, each entry {}", range.text()); };
  const auto* list = node->node->as_array();
  if (!list) refuse(key, expected());
  std::vector<double> numbers;
  for (const auto& entry : *list) {
    const auto value = entry.value<double>();
    if (!entry.is_number() || !value || !range.contains(*value)) refuse(key, expected());
    numbers.push_back(*value);
  }
  return numbers;
}

std::size_t TomlSection::choice(std::string_view key, std::span<const std::string_view> words) {
  const auto node = find(key);
  const auto* word = node ? node->node->as_string() : nullptr;
  if (word) {
    const auto found = std::find(words.begin(), words.end(), word->get());
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  }
  const std::vector<std::string> known(words.begin(), words.end());
  const auto near = word ? nearest_word(word->get(), known) : std::nullopt;
  const std::string expected = "one of " + known_words(known);
  refuse(key, near ? fmt::format("{} (did you mean {}?)", expected, *near) : expected);
}

std::size_t TomlSection::choice_or(std::string_view key, std::size_t fallback,
                                   std::span<const std::string_view> words) {
  return find(key) ? choice(key, words) : fallback;
}

void TomlSection::done() const {
  const auto found = std::as_const(document_->impl_->table)[name_];
  const auto* table = index_ ? found[*index_].as_table() : found.as_table();
  if (!table) return;
  for (const auto& [key, node] : *table) {
    if (known_.contains(key.str())) continue;
    const std::vector<std::string> known(known_.begin(), known_.end());
    throw InputError(fmt::format("{}:{}: [{}] {} = {}: unknown key; {}", document_->path_,
                                 key.source().begin.line, name_, key.str(), shown(node),
                                 suggestion(key.str(), known)));
  }
}

std::vector<std::string> TomlSection::keys() const {
  const auto found = std::as_const(document_->impl_->table)[name_];
  const auto* table = index_ ? found[*index_].as_table() : found.as_table();
  std::vector<std::pair<unsigned, std::string>> by_line;
  if (table) {
    for (const auto& [key, node] : *table) {
      by_line.emplace_back(key.source().begin.line, std::string(key.str()));
    }
  }
  std::stable_sort(by_line.begin(), by_line.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> keys;
  for (auto& [line, key] : by_line) keys.push_back(std::move(key));
  return keys;
}

int TomlSection::line_of(std::string_view key) const {
  const Node node = at(key);
  return node.node ? line_of(key, node) : 0;
}

std::optional<TomlValue> TomlSection::value_if(std::string_view key) {
  const auto node = find(key);
  return node ? value_of(*node->node) : std::nullopt;
}

std::vector<TomlValue> TomlSection::values(std::string_view key) {
  constexpr auto expected = "a list of one value or more, or { first = ..., count = ... }";
  const Node node = require(key, expected);
  if (const auto* range = node.node->as_table()) {
    // Not value<>: it would convert floating point numbers, whatever their size.
    const auto* first = (*range)["first"].as_integer();
    const auto* count = (*range)["count"].as_integer();
    constexpr std::int64_t last = std::numeric_limits<std::int64_t>::max();
    if (!first || !count || range->size() != 2 || **count < 1 || **count > most_values ||
        **first > last - **count) {
      refuse(key, fmt::format("{{ first = a whole number, count = a whole number from 1 to {} }}",
                              most_values));
    }
    std::vector<TomlValue> values;
    for (std::int64_t i = 0; i < **count; ++i) {
      values.push_back({**first + i, static_cast<int>(node.node->source().begin.line)});
    }
    return values;
  }
  const auto* list = node.node->as_array();
  if (!list || list->empty()) refuse(key, expected);
  std::vector<TomlValue> values;
  for (const auto& entry : *list) {
    const auto value = value_of(entry);
    if (!value) refuse(key, expected);
    values.push_back(*value);
  }
  return values;
}

}  // namespace porowave
