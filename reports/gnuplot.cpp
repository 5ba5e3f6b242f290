#include "reports/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
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

/// The only part of a figure that would differ from run to run.
void remove_date(const fs::path& pdf) {
  std::ifstream in(pdf, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  write_file(pdf, pdf_without_date(text));
}

std::string script_of(const Figure& figure) {
  std::string script =
      fmt::format("# Run: gnuplot {0}.gp   (reads {1}, writes {0}.svg and {0}.png{2})\n",
                  figure.name, figure.data_file(), figure.has_pdf() ? " and the PDF" : "");
  script += fmt::format("name = {}\n", gnuplot_string(figure.name));
  script += fmt::format("kinds = '{}'\n", figure.has_pdf() ? "svg png pdf" : "svg png");
  for (const auto& [variable, text] : figure.texts) {
    script += fmt::format("{} = {}\n", variable, gnuplot_string(text));
  }
  return script + plot_template(figure.template_name);
}

}  // namespace

std::string pdf_without_date(std::string pdf) {
  const std::string key = "/CreationDate (";
  for (auto at = pdf.find(key); at != std::string::npos; at = pdf.find(key, at + 1)) {
    const auto end = pdf.find(')', at);
    if (end == std::string::npos) break;
    std::fill(pdf.begin() + static_cast<std::ptrdiff_t>(at),
              pdf.begin() + static_cast<std::ptrdiff_t>(end) + 1, ' ');
  }
  return pdf;
}

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
  for (const char* ending : {".svg", ".png", ".gp"}) {
    files.push_back(directory / (figure.name + ending));
  }
  files.push_back(directory / figure.data_file());
  if (figure.has_pdf()) files.push_back(directory / (figure.name + ".pdf"));
  if (figure.animated) files.push_back(directory / (figure.name + ".gif"));
  try {
    write_file(files[3], figure.data);
    write_file(files[2], script);
    const ProcessResult result = run_process({"gnuplot", "-d", figure.name + ".gp"}, directory);
    const bool complete = std::all_of(files.begin(), files.end(),
                                      [](const fs::path& file) { return fs::exists(file); });
    if (result.exit_code == 0 && complete) {
      if (figure.has_pdf()) remove_date(directory / (figure.name + ".pdf"));
      return files;
    }
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
