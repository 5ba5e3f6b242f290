#include "verification/adapters/adapter.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "verification/study/case_identity.hpp"

namespace porowave::verification {

namespace fs = std::filesystem;

namespace {

bool is_program(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

/// The file that will be started; empty if there is none.
fs::path program_file(const std::string& name, const fs::path& directory) {
  if (name.find('/') != std::string::npos) {
    const fs::path path = directory / name;  // an absolute name stands for itself
    return is_program(path) ? path : fs::path();
  }
  const char* const variable = std::getenv("PATH");
  std::string_view places = variable != nullptr ? variable : "/usr/bin:/bin";
  while (!name.empty() && !places.empty()) {
    const auto colon = std::min(places.find(':'), places.size());
    const fs::path path = directory / fs::path(places.substr(0, colon)) / name;
    if (is_program(path)) return path;
    places.remove_prefix(std::min(colon + 1, places.size()));
  }
  return {};
}

std::string content_hash(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return "no file";
  std::ifstream file(path, std::ios::binary);
  return text_hash(std::string{std::istreambuf_iterator<char>(file), {}});
}

std::string identity_of(const Adapter& adapter, const fs::path& program) {
  std::string text = adapter.toml() + content_hash(program);
  for (std::size_t i = 1; i < adapter.command.size(); ++i) {
    text += '\n' + content_hash(adapter.directory / adapter.command[i]);
  }
  return text_hash(text);
}

std::vector<std::string> read_command(TomlSection& section) {
  std::vector<std::string> command;
  for (const TomlValue& value : section.values("command")) {
    const auto* const word = std::get_if<std::string>(&value.value);
    if (word == nullptr || word->find('\0') != std::string::npos) {
      section.refuse("command", "a list of strings: the program and its arguments");
    }
    command.push_back(*word);
  }
  return command;
}

}  // namespace

std::string Adapter::toml() const {
  std::string words;
  for (const std::string& word : command) {
    words += (words.empty() ? "" : ", ") + TomlValue{word}.text();
  }
  return fmt::format("[adapter]\ncommand = [{}]\ntime_limit = {}\n", words,
                     TomlValue{time_limit}.text());
}

std::optional<Adapter> read_adapter(const TomlDocument& document) {
  TomlSection section = document.section("adapter");
  if (!section.present()) return std::nullopt;
  Adapter adapter;
  adapter.command = read_command(section);
  adapter.time_limit = section.number_or("time_limit", adapter.time_limit, Range::positive());
  section.done();
  adapter.directory = fs::absolute(document.path()).parent_path();
  const fs::path program = program_file(adapter.command[0], adapter.directory);
  if (program.empty()) {
    section.refuse("command",
                   "a program that can be started: a path from the study's folder, such "
                   "as ./solver, or a name in PATH");
  }
  adapter.identity = identity_of(adapter, program);
  return adapter;
}

}  // namespace porowave::verification
