#include "reports/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "reference/problem/errors.hpp"
#include "reports/output_file.hpp"
#include "reports/plot_templates.hpp"
#include "reports/process.hpp"

namespace porowave::reports {

namespace fs = std::filesystem;

namespace {

void require_plain_name(const std::string& name) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), plain)) {
    throw std::invalid_argument("figure name: letters, digits, - and _ expected: " + name);
  }
}

const char* data_ending(const Figure& figure) {
  return figure.for_paper ? ".csv" : ".dat";
}

std::string script_of(const Figure& figure) {
  std::string script =
      fmt::format("# Run: gnuplot {0}.gp   (reads {0}{1}, writes {0}.svg and {0}.png{2})\n",
                  figure.name, data_ending(figure), figure.for_paper ? " and the PDF" : "");
  script += fmt::format("name = {}\n", gnuplot_string(figure.name));
  for (const auto& [variable, text] : figure.texts) {
    script += fmt::format("{} = {}\n", variable, gnuplot_string(text));
  }
  return script + plot_template(figure.template_name);
}

}  // namespace

std::string gnuplot_string(const std::string& text) {
  // In single quotes gnuplot takes everything as it is, except a single quote, which comes in
  // double quotes: doubling it as the manual says fails at the beginning of a string.
  std::string literal = "'";
  for (const char c : text) {
    if (c == '\'') {
      literal += "'.\"'\".'";
    } else {
      literal += c == '\n' || c == '\r' ? ' ' : c;
    }
  }
  return literal + "'";
}

void require_gnuplot() {
  constexpr const char* remedy = "; Debian and Ubuntu: apt-get install gnuplot-nox";
  try {
    if (run_process({"gnuplot", "--version"}, ".").exit_code == 0) return;
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(std::string(error.what()) + remedy);
  }
  throw EnvironmentError(std::string("gnuplot: does not run") + remedy);
}

std::vector<fs::path> draw(const Figure& figure, const fs::path& directory) {
  require_plain_name(figure.name);
  const std::string script = script_of(figure);
  std::vector<fs::path> files;
  for (const char* ending : {".svg", ".png", ".gp", data_ending(figure)}) {
    files.push_back(directory / (figure.name + ending));
  }
  if (figure.for_paper) files.push_back(directory / (figure.name + ".pdf"));
  if (figure.animated) files.push_back(directory / (figure.name + ".gif"));
  try {
    write_file(files[3], figure.data);
    write_file(files[2], script);
    const ProcessResult result = run_process({"gnuplot", "-d", figure.name + ".gp"}, directory);
    const bool complete = std::all_of(files.begin(), files.end(),
                                      [](const fs::path& file) { return fs::exists(file); });
    if (result.exit_code == 0 && complete) return files;
    throw EnvironmentError(fmt::format("gnuplot failed (exit code {}) on figure {}: {}",
                                       result.exit_code, figure.name, result.errors));
  } catch (const EnvironmentError&) {
    for (const fs::path& file : files) {
      std::error_code ignored;
      fs::remove(file, ignored);
    }
    throw;
  }
}

}  // namespace porowave::reports
