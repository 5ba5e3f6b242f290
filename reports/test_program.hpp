#pragma once

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <vector>

#include "reports/process.hpp"
#include "reports/test_directory.hpp"

namespace porowave::tests {

inline reports::ProcessResult run_porowave(std::vector<std::string> arguments,
                                           const std::filesystem::path& directory = ".") {
  arguments.insert(arguments.begin(), POROWAVE_PROGRAM);
  return reports::run_process(arguments, directory);
}

/// A file of verification/studies.
inline std::string study_path(const std::string& name) {
  return std::string(POROWAVE_SOURCE_DIR) + "/verification/studies/" + name;
}
inline const std::string paper_problem = study_path("paper_problem.toml");
inline const std::string paper_case = study_path("paper_case.toml");

/// The paper's case with some of its lines changed; an empty new text removes the line.
class CaseText {
 public:
  CaseText() : text_(text_of(paper_case)) {}

  /// Replaces the line that begins with `key = `.
  CaseText& line(const std::string& key, const std::string& replacement) {
    const auto begin = text_.find("\n" + key + " = ");
    BOOST_REQUIRE_MESSAGE(begin != std::string::npos, "no line " + key);
    const auto end = text_.find('\n', begin + 1);
    text_.replace(begin, end - begin, "\n" + replacement);
    return *this;
  }
  CaseText& set(const std::string& key, const std::string& value) {
    return line(key, key + " = " + value);
  }
  CaseText& without(const std::string& key) { return line(key, ""); }
  /// Adds a line at the beginning of a table.
  CaseText& add(const std::string& table, const std::string& added) {
    const std::string head = "\n[" + table + "]\n";
    const auto at = text_.find(head);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, "no table " + table);
    text_.insert(at + head.size(), added + "\n");
    return *this;
  }
  /// Number of the line with these words, as a message gives it.
  int line_of(const std::string& words) const {
    const auto at = text_.find(words);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, "no text " + words);
    return 1 +
           static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<long>(at), '\n'));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

inline bool is_one_line(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

/// That it ended with the code and said why in one line with these parts, and nothing else.
inline void check_failure(const reports::ProcessResult& result, int code,
                          const std::vector<std::string>& parts) {
  BOOST_TEST(result.exit_code == code);
  BOOST_TEST(result.output == "");
  BOOST_TEST(is_one_line(result.errors), result.errors);
  BOOST_TEST(result.errors.rfind("porowave: ", 0) == 0u, result.errors);
  for (const auto& part : parts) {
    BOOST_TEST(contains(result.errors, part), result.errors << " lacks " << part);
  }
}

/// The words of the example in a command's help, after "porowave".
inline std::vector<std::string> example_of(const std::string& command) {
  const std::string help = run_porowave({command, "--help"}).output;
  const std::string begin = "\nExample: porowave ";
  const auto at = help.find(begin);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, command + " --help has no example");
  std::vector<std::string> words(1);
  for (std::size_t i = at + begin.size(); i < help.size() && help[i] != '\n'; ++i) {
    if (help[i] == ' ') {
      words.emplace_back();
    } else {
      words.back() += help[i];
    }
  }
  return words;
}

/// The example from the top of the tree, with what it writes put elsewhere.
inline reports::ProcessResult run_example(const std::string& command, const std::string& output) {
  auto words = example_of(command);
  const auto option = std::find(words.begin(), words.end(), "--output");
  if (option != words.end()) *std::next(option) = output;
  return run_porowave(words, POROWAVE_SOURCE_DIR);
}

}  // namespace porowave::tests
