#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/problem/range.hpp"
#include "reference/problem/toml_value.hpp"

namespace porowave {

class TomlDocument;

/// One table of a TOML file. Every getter marks its key as known and checks type and range; `done`
/// then refuses the keys that nobody asked for. All errors are InputError and read like
/// "case.toml:7: [material] porosity = 1.2: expected a number > 0 and < 1".
class TomlSection {
 public:
  bool present() const;            ///< the table stands in the file
  bool has(std::string_view key);  ///< the key stands in the table

  double number(std::string_view key, const Range& range);  ///< required
  double number_or(std::string_view key, double fallback, const Range& range);
  std::optional<double> number_if(std::string_view key, const Range& range);
  long integer_or(std::string_view key, long fallback, long low, long high);
  long integer(std::string_view key, long low, long high);  ///< required
  std::string text(std::string_view key);                   ///< required
  std::string text_or(std::string_view key, std::string fallback);
  std::vector<double> numbers_or(std::string_view key, std::vector<double> fallback,
                                 const Range& range);
  bool is_text(std::string_view key);  ///< the key is there and holds a string

  std::vector<std::string> keys() const;  ///< in the order of the file
  int line_of(std::string_view key) const;
  /// One value of any of the kinds that a key may have; none if it is missing or of another kind.
  std::optional<TomlValue> value_if(std::string_view key);
  /// A list of at least one such value, or { first = i, count = n } for n whole numbers. Required.
  std::vector<TomlValue> values(std::string_view key);

  /// A required word out of `words`; the result is its index.
  std::size_t choice(std::string_view key, std::span<const std::string_view> words);
  std::size_t choice_or(std::string_view key, std::size_t fallback,
                        std::span<const std::string_view> words);

  /// Refuses the value of a key for a reason that the getters cannot know.
  [[noreturn]] void refuse(std::string_view key, std::string_view expected) const;
  /// Refuses keys that no getter has named.
  void done() const;

 private:
  friend class TomlDocument;
  struct Node;
  TomlSection(const TomlDocument& document, std::string name,
              std::optional<std::size_t> index = std::nullopt);
  Node at(std::string_view key) const;  ///< null if the key is missing
  int line_of(std::string_view key, const Node& node) const;
  std::optional<Node> find(std::string_view key);
  Node require(std::string_view key, std::string_view expected);
  double checked_number(std::string_view key, const Node& node, const Range& range) const;

  const TomlDocument* document_;
  std::string name_;
  std::optional<std::size_t> index_;  ///< of an entry of an array of tables
  std::set<std::string, std::less<>> known_;
};

/// A TOML file in memory.
class TomlDocument {
 public:
  /// Reads a file. Throws InputError when it cannot be read or is not TOML.
  static TomlDocument load(const std::string& path);
  /// Parses text; `path` is only the name used in messages.
  static TomlDocument parse(std::string_view text, const std::string& path);

  const std::string& path() const { return path_; }
  TomlSection section(std::string name) const;
  /// The tables [[name]]; none if there is no such key.
  std::vector<TomlSection> sections(const std::string& name) const;
  /// The same document with another value of [section] key; messages name the value's own line.
  TomlDocument with(const std::string& section, const std::string& key,
                    const TomlValue& value) const;
  /// The same document without these tables and keys.
  TomlDocument without(std::initializer_list<std::string_view> names) const;
  /// The tables of these names that there are, as TOML with sorted keys: equal for equal content.
  std::string canonical(std::initializer_list<std::string_view> names) const;
  /// Refuses tables and top-level keys other than these.
  void only(std::initializer_list<std::string_view> sections) const;

 private:
  friend class TomlSection;
  struct Impl;
  TomlDocument(std::string path, std::shared_ptr<const Impl> impl)
      : path_(std::move(path)), impl_(std::move(impl)) {}
  /// A copy of the content that remembers the lines of its values: copied nodes do not.
  std::shared_ptr<Impl> copy_with_lines() const;

  std::string path_;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace porowave
