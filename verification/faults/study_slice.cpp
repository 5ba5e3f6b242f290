#include "verification/faults/study_slice.hpp"

#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "verification/process/scratch_directory.hpp"

namespace porowave::verification::faults {

namespace {

const std::string room = std::string(POROWAVE_SOURCE_DIR) + "/verification/";

/// Keeps some of the values of an axis, given as they stand there.
void keep(std::string& study, const std::string& axis, const std::string& values) {
  const auto begin = study.find("\n\"" + axis + "\" = [");
  if (begin == std::string::npos) throw std::runtime_error("pull_request has no axis " + axis);
  const auto end = study.find('\n', begin + 1);
  if (study.substr(begin, end - begin).find(values) == std::string::npos) {
    throw std::runtime_error("pull_request has no " + axis + " = " + values);
  }
  study.replace(begin, end - begin, "\n\"" + axis + "\" = [" + values + "]");
}

std::string slice(Until until) {
  std::ifstream file(room + "studies/pull_request.toml");
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  text.erase(text.find("[[exclude]]"));
  keep(text, "time.end", until == Until::first_passage ? "4.0e-5" : "8.0e-5");
  keep(text, "load.shape", "\"smooth_ramp\"");
  keep(text, "discretization.kernel", "\"bspline2\"");
  keep(text, "discretization.strain", "\"recovered\"");
  keep(text, "discretization.elements", "100, 200");
  return text;
}

/// What the baseline says of the first two levels; no order follows from two.
Baseline coarse_baseline() {
  Baseline baseline = read_baseline(room + "baselines/pull_request.csv");
  for (auto& [key, expected] : baseline.expected) {
    expected.spacing.resize(2);
    expected.mean_log.resize(2);
    expected.sd_log.resize(2);
    expected.order = std::numeric_limits<double>::quiet_NaN();
  }
  return baseline;
}

}  // namespace

std::vector<Verdict> verdicts_of_slice(const RunFunction& run, Until until) {
  const TomlDocument document = TomlDocument::parse(slice(until), "pull_request.toml");
  const Study study = read_study(document);
  const ScratchDirectory directory;
  Store store = Store::create_or_open(directory.file("results"));
  SweepOptions options;
  options.run = run;
  sweep(study, store, options);
  return judge(groups_of(study, store), read_gate_rules(document, study), coarse_baseline());
}

Catch caught_by_study(const RunFunction& run, Until until) {
  for (const Verdict& verdict : verdicts_of_slice(run, until)) {
    if (verdict.kind == VerdictKind::pass) continue;
    return {"study `pull_request`",
            std::string(to_string(verdict.kind)) + ": " + verdict.measure + ": " + verdict.reason};
  }
  return {"study `pull_request`", ""};
}

}  // namespace porowave::verification::faults
