// Any bytes as a problem, a case, a study with its gate: read, or refused by InputError.

#include <cstdint>

#include "reference/problem/errors.hpp"
#include "verification/gate/gate.hpp"

using namespace porowave;

namespace {

/// Fuzzers find soon how to ask for ten million cases, which takes its time and finds nothing else.
bool is_large(const TomlDocument& document) {
  std::size_t cases = 1;
  TomlSection axes = document.section("axes");
  for (const std::string& key : axes.keys()) {
    cases *= axes.values(key).size();
    if (cases > 200) return true;
  }
  return document.sections("method").size() > 20;
}

void read(std::uint8_t kind, const TomlDocument& document) {
  if (kind % 3 == 0) {
    read_problem(document);
  } else if (kind % 3 == 1) {
    solver::read_case(document);
  } else if (!is_large(document)) {
    const auto study = verification::read_study(document);
    verification::read_gate_rules(document, study);
    for (const auto& one : study.cases) {
      // What a case is must be read again as the same.
      const auto text = TomlDocument::parse(one.specification, "specification");
      if (text.canonical({"material", "column", "load", "discretization", "time"}) !=
          one.specification) {
        __builtin_trap();
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  try {
    read(data[0], TomlDocument::parse({reinterpret_cast<const char*>(data + 1), size - 1}, "fuzz"));
  } catch (const InputError&) {
  }
  return 0;
}
