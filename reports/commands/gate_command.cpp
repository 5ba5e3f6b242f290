#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <memory>

#include "reference/problem/errors.hpp"
#include "reports/commands/commands.hpp"
#include "reports/junit.hpp"
#include "reports/output_file.hpp"
#include "verification/gate/floor_cause.hpp"
#include "verification/gate/gate.hpp"

namespace porowave::reports {

namespace {

using verification::Verdict;
using verification::VerdictKind;

struct GateOptions {
  std::string study;
  std::string store;
  std::string baseline;
  std::optional<std::string> reason;
  std::string junit;
  bool all = false;
};

int rebaseline(const GateOptions& options, const std::vector<verification::Group>& groups,
               const verification::GateRules& rules,
               const std::optional<verification::Baseline>& old) {
  const std::string today = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
  const auto fresh = verification::rebaselined(groups, rules, old, today, *options.reason);
  write_file(options.baseline, verification::baseline_text(fresh));
  fmt::print("{} expectations\nwrote {}\n", fresh.expected.size(), options.baseline);
  return 0;
}

/// The verdicts that somebody must look at (all of them with --all), then the count of each kind.
int show(const std::vector<Verdict>& verdicts, bool all) {
  std::array<std::size_t, verification::verdict_names.size()> count{};
  for (const Verdict& v : verdicts) {
    ++count[static_cast<std::size_t>(v.kind)];
    if (!all && (v.kind == VerdictKind::pass || v.kind == VerdictKind::xfail)) continue;
    fmt::print("{}: {}: {}: {}\n", to_string(v.kind), v.group, v.measure, v.reason);
  }
  std::string text;
  for (std::size_t k = 0; k < count.size(); ++k) {
    text += fmt::format("{}{} {}", k == 0 ? "" : ", ", count[k], verification::verdict_names[k]);
  }
  const int code = exit_code(verdicts);
  constexpr std::array<const char*, 4> words = {"pass", "fail", "", "inconclusive"};
  fmt::print("{}: {}\n", words[static_cast<std::size_t>(code)], text);
  return code;
}

int run_gate(const GateOptions& options) {
  const bool change = options.reason.has_value();
  if (change &&
      (options.reason->empty() || options.reason->find_first_of("\r\n") != std::string::npos)) {
    throw InputError("--rebaseline: expected a reason of one line");
  }
  const TomlDocument document = TomlDocument::load(options.study);
  const verification::Study study = verification::read_study(document);
  const auto rules = verification::read_gate_rules(document, study);
  std::optional<verification::Baseline> baseline;
  if (!options.baseline.empty() && !(change && !std::filesystem::exists(options.baseline))) {
    baseline = verification::read_baseline(options.baseline);
  }
  if (change && options.baseline.empty()) {
    throw InputError("--rebaseline: expected --baseline FILE, which is to be written");
  }
  if (!options.junit.empty()) require_writable(options.junit);
  const auto groups = verification::groups_of(study, verification::Store::open(options.store));
  if (change) return rebaseline(options, groups, rules, baseline);
  verification::CaseRunner runner(study.name, "", study.adapter);
  const auto explain = [&](const verification::Group& group, std::size_t measure) {
    return cause_of_floor(study, group, measure, runner);
  };
  auto verdicts = verification::judge(groups, rules, baseline, explain);
  const auto costs = judge_costs(groups, rules, baseline);
  verdicts.insert(verdicts.end(), costs.begin(), costs.end());
  if (!options.junit.empty()) write_file(options.junit, junit_of(study.name, verdicts));
  return show(verdicts, options.all);
}

}  // namespace

void add_gate_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<GateOptions>();
  CLI::App* command = program.add_subcommand("gate", "Verdict of a study for CI");
  command->add_option("study", options->study, "Study file (TOML)")->required();
  command->add_option("--store", options->store, "Store of results")->required();
  command->add_option("--baseline", options->baseline, "Expected errors and orders (CSV)");
  command->add_option("--rebaseline", options->reason,
                      "Reason why the baseline changes: writes what is now as what is expected");
  command->add_option("--junit", options->junit, "Verdicts as JUnit XML");
  command->add_flag("--all", options->all, "Show every verdict, not only those to look at");
  command->footer(
      "Judges every group of cases (all axes but levels and seeds) and measure: against the order\n"
      "of theory ([gate] order), and against the baseline. Better than expected is a failure too.\n"
      "Exit codes: 0 all pass (or fail as known), 1 a fail or an unexpected pass, 3 inconclusive.\n"
      "Example: porowave gate verification/studies/smoke.toml --store results --baseline "
      "verification/baselines/smoke.csv");
  command->callback([options, &run] { run = [options] { return run_gate(*options); }; });
}

}  // namespace porowave::reports
