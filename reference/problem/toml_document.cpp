#include "reference/problem/toml_document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <sstream>

#include "reference/problem/errors.hpp"

namespace porowave {

struct TomlDocument::Impl {
  toml::table table;
};

struct TomlSection::Node {
  const toml::node* node;
};

namespace {

/// On one line, whatever the value holds.
std::string on_one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

std::string shown(const toml::node& node) {
  if (const auto* text = node.as_string()) return on_one_line(fmt::format("\"{}\"", text->get()));
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return on_one_line(out.str());
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

std::string known_words(std::span<const std::string> known) {
  return fmt::format("{}", fmt::join(known, ", "));
}

std::string suggestion(std::string_view word, std::span<const std::string> known) {
  if (const auto near = nearest_word(word, known)) {
    return fmt::format("did you mean {}?", *near);
  }
  return known.empty() ? std::string("none is known here")
                       : fmt::format("expected one of {}", known_words(known));
}

}  // namespace

bool Range::contains(double value) const {
  const bool above = low_open ? value > low : value >= low;
  const bool below = high_open ? value < high : value <= high;
  return std::isfinite(value) && above && below;
}

std::string Range::text() const {
  std::string text = "a number";
  const bool bounded_below = std::isfinite(low);
  if (bounded_below) text += fmt::format(" {} {:g}", low_open ? ">" : ">=", low);
  if (std::isfinite(high)) {
    text += fmt::format("{} {} {:g}", bounded_below ? " and" : "", high_open ? "<" : "<=", high);
  }
  return text;
}

std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> known) {
  std::optional<std::string> best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const auto& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

TomlSection::TomlSection(const TomlDocument& document, std::string name)
    : document_(&document), name_(std::move(name)) {}

bool TomlSection::present() const {
  return document_->impl_->table.contains(name_);
}

std::optional<TomlSection::Node> TomlSection::find(std::string_view key) {
  known_.emplace(key);
  const toml::node* node = document_->impl_->table[name_][key].node();
  return node ? std::optional<Node>(Node{node}) : std::nullopt;
}

bool TomlSection::has(std::string_view key) {
  return find(key).has_value();
}

bool TomlSection::is_text(std::string_view key) {
  const auto node = find(key);
  return node && node->node->is_string();
}

void TomlSection::refuse(std::string_view key, std::string_view expected) const {
  const toml::node* node = document_->impl_->table[name_][key].node();
  if (!node) {
    throw InputError(
        fmt::format("{}: [{}] {} is missing: expected {}", document_->path_, name_, key, expected));
  }
  throw InputError(fmt::format("{}:{}: [{}] {} = {}: expected {}", document_->path_,
                               node->source().begin.line, name_, key, shown(*node), expected));
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
  return checked_number(key, require(key, range.text()), range);
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
  const std::string expected = fmt::format("a whole number from {} to {}", low, high);
  const Node node = require(key, expected);
  const auto* value = node.node->as_integer();
  if (!value || value->get() < low || value->get() > high) refuse(key, expected);
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
  const auto expected = fmt::format("a list, each entry {}", range.text());
  const auto* list = node->node->as_array();
  if (!list) refuse(key, expected);
  std::vector<double> numbers;
  for (const auto& entry : *list) {
    const auto value = entry.value<double>();
    if (!entry.is_number() || !value || !range.contains(*value)) refuse(key, expected);
    numbers.push_back(*value);
  }
  return numbers;
}

std::size_t TomlSection::choice(std::string_view key, std::span<const std::string_view> words) {
  const std::vector<std::string> known(words.begin(), words.end());
  const std::string expected = "one of " + known_words(known);
  const Node node = require(key, expected);
  const auto* word = node.node->as_string();
  if (!word) refuse(key, expected);
  const auto found = std::find(words.begin(), words.end(), word->get());
  if (found == words.end()) {
    const auto near = nearest_word(word->get(), known);
    refuse(key, near ? fmt::format("{} (did you mean {}?)", expected, *near) : expected);
  }
  return static_cast<std::size_t>(found - words.begin());
}

std::size_t TomlSection::choice_or(std::string_view key, std::size_t fallback,
                                   std::span<const std::string_view> words) {
  return find(key) ? choice(key, words) : fallback;
}

void TomlSection::done() const {
  const auto* table = document_->impl_->table[name_].as_table();
  if (!table) return;
  const std::vector<std::string> known(known_.begin(), known_.end());
  for (const auto& [key, node] : *table) {
    if (known_.contains(key.str())) continue;
    throw InputError(fmt::format("{}:{}: [{}] {} = {}: unknown key; {}", document_->path_,
                                 key.source().begin.line, name_, key.str(), shown(node),
                                 suggestion(key.str(), known)));
  }
}

TomlDocument TomlDocument::load(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("{}: cannot be read: expected a TOML file", path));
  }
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return parse(text, path);
}

TomlDocument TomlDocument::parse(std::string_view text, const std::string& path) {
  auto impl = std::make_shared<Impl>();
  try {
    impl->table = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: not TOML: {}", path, error.source().begin.line, error.description()));
  }
  TomlDocument document;
  document.path_ = path;
  document.impl_ = std::move(impl);
  return document;
}

TomlSection TomlDocument::section(std::string name) const {
  const toml::node* node = impl_->table[name].node();
  if (node && !node->is_table()) {
    throw InputError(fmt::format("{}:{}: {} = {}: expected a table [{}]", path_,
                                 node->source().begin.line, name, shown(*node), name));
  }
  return {*this, std::move(name)};
}

void TomlDocument::only(std::initializer_list<std::string_view> sections) const {
  const std::vector<std::string> known(sections.begin(), sections.end());
  for (const auto& [key, node] : impl_->table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    throw InputError(
        fmt::format("{}:{}: {}: unknown {}; {}", path_, key.source().begin.line,
                    node.is_table() ? fmt::format("[{}]", key.str()) : std::string(key.str()),
                    node.is_table() ? "table" : "top-level key", suggestion(key.str(), known)));
  }
}

}  // namespace porowave
