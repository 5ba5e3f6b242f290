#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>

#include "reference/problem/errors.hpp"
#include "reference/problem/load.hpp"
#include "reference/problem/toml_document.hpp"

namespace porowave {

namespace {

bool parse_number(std::string_view text, double& number) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

Load read_table(const std::string& path, double magnitude) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw InputError(
        fmt::format("{}: cannot be read: expected a CSV file with columns t,value", path));
  }
  std::vector<double> times;
  std::vector<double> values;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (number == 1 && line != "t,value") {
      throw InputError(fmt::format("{}:1: {}: expected the header t,value", path, line));
    }
    if (number == 1 || line.empty()) continue;
    const auto comma = line.find(',');
    double t = 0.0;
    double value = 0.0;
    if (comma == std::string::npos || !parse_number(std::string_view(line).substr(0, comma), t) ||
        !parse_number(std::string_view(line).substr(comma + 1), value)) {
      throw InputError(fmt::format("{}:{}: {}: expected two numbers, t,value", path, number, line));
    }
    times.push_back(t);
    values.push_back(value);
  }
  try {
    return {magnitude, std::move(times), std::move(values)};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace

Load read_load(const TomlDocument& document) {
  auto section = document.section("load");
  const auto shape = static_cast<LoadShape>(section.choice("shape", load_shape_names));
  const double magnitude = section.number_or("magnitude", 1.0, {});
  if (magnitude == 0.0) section.refuse("magnitude", "a number other than 0");
  if (!has_duration(shape) && section.has("duration")) {
    section.refuse("duration", fmt::format("no duration with shape = \"{}\"", name(shape)));
  }
  if (shape != LoadShape::table && section.has("file")) {
    section.refuse("file", "no file unless shape = \"table\"");
  }
  Load load;
  if (shape == LoadShape::table) {
    const std::filesystem::path file = section.text("file");
    const auto folder = std::filesystem::path(document.path()).parent_path();
    load = read_table((folder / file).string(), magnitude);
  } else if (has_duration(shape)) {
    load = Load(shape, magnitude, section.number("duration", Range::positive()));
  } else {
    load = Load(shape, magnitude);
  }
  section.done();
  return load;
}

}  // namespace porowave
