#include "verification/store/record.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "verification/field_errors.hpp"
#include "verification/study/build_identity.hpp"
#include "verification/study/case_identity.hpp"
#include "verification/wave_measures/wave_measures.hpp"

namespace porowave::verification {

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

}  // namespace

const std::vector<std::string>& measure_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const std::string_view field : field_names) {
      for (const char* where : {"points", "field"}) {
        for (const char* norm : {"l1", "l2", "linf"}) {
          list.push_back(fmt::format("{}_{}_{}", field, where, norm));
        }
      }
    }
    list.insert(list.end(), {"reference_error", "largest_strain"});
    const auto& waves = wave_measure_names();
    list.insert(list.end(), waves.begin(), waves.end());
    return list;
  }();
  return names;
}

std::optional<std::size_t> measure_index(std::string_view name) {
  const auto& names = measure_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

Provenance current_provenance() {
  Provenance here{{},
                  std::string(program_version()),
                  std::string(git_state()),
                  std::string(numerics_hash()),
                  std::string(compiler()),
                  std::string(compiler_flags()),
                  processor(),
                  host_name()};
  here.id = text_hash(fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", here.version, here.git,
                                  here.numerics, here.compiler, here.flags, here.cpu, here.host));
  return here;
}

}  // namespace porowave::verification
