#include <fmt/format.h>

#include <filesystem>

#include "reference/problem/csv_reader.hpp"
#include "reference/problem/errors.hpp"
#include "reference/problem/load.hpp"
#include "reference/problem/toml_document.hpp"

namespace porowave {

namespace {

Load read_table(const std::string& path, double magnitude) {
  CsvReader reader = CsvReader::open(path);
  if (reader.columns() != std::vector<std::string>{"t", "value"}) {
    reader.refuse_line(fmt::format("{}", fmt::join(reader.columns(), ",")), "the header t,value");
  }
  std::vector<double> times;
  std::vector<double> values;
  while (reader.next()) {
    times.push_back(reader.number(0));
    values.push_back(reader.number(1));
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
