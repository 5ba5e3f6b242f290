#pragma once

#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
  TomlSection(const TomlDocument& document, std::string name);
  std::optional<Node> find(std::string_view key);
  Node require(std::string_view key, std::string_view expected);
  double checked_number(std::string_view key, const Node& node, const Range& range) const;

  const TomlDocument* document_;
  std::string name_;
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
  /// Refuses tables and top-level keys other than these.
  void only(std::initializer_list<std::string_view> sections) const;

 private:
  friend class TomlSection;
  struct Impl;
  std::string path_;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace porowave
