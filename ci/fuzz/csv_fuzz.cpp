// Any bytes as a table of points, a baseline, or a table without a meaning.

#include <cmath>
#include <cstdint>

#include "reference/problem/errors.hpp"
#include "verification/gate/baseline.hpp"
#include "verification/grade/point_table.hpp"

using namespace porowave;
using namespace porowave::verification;

namespace {

void require(bool condition) {
  if (!condition) __builtin_trap();
}

void read_points_of(const std::string& text, std::uint8_t kind) {
  CsvReader reader = CsvReader::of_text(text, "fuzz");
  PointReading reading;
  if (kind & 4U) reading.time = 1e-5;
  if (kind & 8U) reading.length = 0.1;
  if (kind & 16U) reading.names["effective_stress"] = "s'";
  for (const PointProfile& profile : read_points(reader, reading).profiles) {
    for (const double x : profile.x) require(std::isfinite(x) && x >= 0.0);
    for (const double w : profile.weight) require(w > 0.0 && std::isfinite(w));
    require(profile.weight.size() == profile.x.size());
  }
}

void read_all(const std::string& text) {
  CsvReader reader = CsvReader::of_text(text, "fuzz");
  while (reader.next()) {
    for (std::size_t c = 0; c < reader.columns().size(); ++c) reader.cell(c);
    if (!reader.columns().empty()) require(std::isfinite(reader.number(0)));
  }
}

/// What is written can be read, and is the same.
void read_again(const Baseline& once) {
  try {
    const Baseline twice = baseline_of_text(baseline_text(once), "written");
    require(twice.history == once.history && twice.expected.size() == once.expected.size());
    for (const auto& [key, expected] : once.expected) {
      require(twice.expected.at(key).replicates == expected.replicates);
    }
  } catch (const InputError&) {
    require(false);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    if (data[0] % 4 == 0) {
      read_all(text);
    } else if (data[0] % 4 == 1) {
      read_again(baseline_of_text(text, "fuzz"));
    } else {
      read_points_of(text, data[0]);
    }
  } catch (const InputError&) {
  }
  return 0;
}
