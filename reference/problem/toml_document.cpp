#include "reference/problem/toml_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "reference/problem/errors.hpp"
#include "reference/problem/toml_implementation.hpp"

namespace porowave {

namespace {

/// On one line, whatever the value holds.
std::string on_one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

}  // namespace

std::string shown(const toml::node& node) {
  if (const auto* text = node.as_string()) return on_one_line(fmt::format("\"{}\"", text->get()));
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return on_one_line(out.str());
}

std::optional<TomlValue> value_of(const toml::node& node) {
  TomlValue result;
  result.line = static_cast<int>(node.source().begin.line);
  if (const auto* flag = node.as_boolean()) {
    result.value = flag->get();
  } else if (const auto* integer = node.as_integer()) {
    result.value = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    result.value = number->get();
  } else if (const auto* word = node.as_string()) {
    result.value = word->get();
  } else if (const auto* list = node.as_array()) {
    std::vector<double> numbers;
    for (const auto& entry : *list) {
      if (!entry.is_number()) return std::nullopt;
      // Not value<double>: it has none for integers that are rounded.
      const auto* whole = entry.as_integer();
      numbers.push_back(whole ? static_cast<double>(whole->get())
                              : entry.as_floating_point()->get());
    }
    result.value = std::move(numbers);
  } else {
    return std::nullopt;
  }
  return result;
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
  return TomlDocument(path, std::move(impl));
}

TomlSection TomlDocument::section(std::string name) const {
  const toml::node* node = impl_->table[name].node();
  if (node && !node->is_table()) {
    throw InputError(fmt::format("{}:{}: {} = {}: expected a table [{}]", path_,
                                 node->source().begin.line, name, shown(*node), name));
  }
  return {*this, std::move(name)};
}

std::vector<TomlSection> TomlDocument::sections(const std::string& name) const {
  const toml::node* node = impl_->table[name].node();
  if (!node) return {};
  const auto* list = node->as_array();
  const bool tables = list && std::all_of(list->begin(), list->end(),
                                          [](const toml::node& entry) { return entry.is_table(); });
  if (!tables) {
    throw InputError(fmt::format("{}:{}: {} = {}: expected tables [[{}]]", path_,
                                 node->source().begin.line, name, shown(*node), name));
  }
  std::vector<TomlSection> sections;
  for (std::size_t i = 0; i < list->size(); ++i) sections.push_back(TomlSection(*this, name, i));
  return sections;
}

std::shared_ptr<TomlDocument::Impl> TomlDocument::copy_with_lines() const {
  auto copy = std::make_shared<Impl>(*impl_);
  for (const auto& [name, node] : impl_->table) {
    const auto* table = node.as_table();
    if (!table) continue;
    for (const auto& [key, entry] : *table) {
      const int line = static_cast<int>(entry.source().begin.line);
      if (line > 0) copy->lines[fmt::format("{}.{}", name.str(), key.str())] = line;
    }
  }
  return copy;
}

TomlDocument TomlDocument::with(const std::string& section, const std::string& key,
                                const TomlValue& value) const {
  auto changed = impl_->lines.empty() ? copy_with_lines() : std::make_shared<Impl>(*impl_);
  auto* table = changed->table[section].as_table();
  if (!table) {
    changed->table.insert_or_assign(section, toml::table());
    table = changed->table[section].as_table();
  }
  std::visit(
      [&](const auto& content) {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, std::vector<double>>) {
          toml::array list;
          for (const double number : content) list.push_back(number);
          table->insert_or_assign(key, std::move(list));
        } else {
          table->insert_or_assign(key, content);
        }
      },
      value.value);
  changed->lines[fmt::format("{}.{}", section, key)] = value.line;
  return TomlDocument(path_, std::move(changed));
}

TomlDocument TomlDocument::without(std::initializer_list<std::string_view> names) const {
  auto changed = copy_with_lines();
  for (const std::string_view name : names) changed->table.erase(name);
  return TomlDocument(path_, std::move(changed));
}

std::string TomlDocument::canonical(std::initializer_list<std::string_view> names) const {
  std::string text;
  for (const std::string_view name : names) {
    const auto* table = impl_->table[name].as_table();
    if (!table) continue;
    text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", name);
    for (const auto& [key, node] : *table) {
      const auto value = value_of(node);
      text += fmt::format("{} = {}\n", key.str(), value ? value->text() : shown(node));
    }
  }
  return text;
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
