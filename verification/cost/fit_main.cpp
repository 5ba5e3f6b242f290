// porowave-cost-fit STUDY... [--check STUDY...]
//
// Measures cases of studies and fits to them the constants of the cost model (cost_model.cpp, where
// they are entered by hand). Of every study 200 cases, the first by id, which is a hash: so any
// ones. Each is run three times, one after the other among all of that study, and the fastest
// counts: what other programs take from it only makes it slower. Studies after --check are
// measured, not fitted. Prints constants, then for every study and family what was measured and
// what is predicted.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>
#include <map>
#include <memory>

#include "reference/problem/errors.hpp"
#include "verification/cost/calibration.hpp"
#include "verification/cost/cost_model.hpp"
#include "verification/cost/relative_fit.hpp"
#include "verification/sweep/case_runner.hpp"

namespace {

using namespace porowave;
using namespace porowave::verification;

constexpr std::size_t cases_of_a_study = 120;
constexpr int repetitions = 6;
constexpr double never = std::numeric_limits<double>::infinity();

struct Measured {
  const StudyCase* one = nullptr;
  double solver = never;   // s
  double judging = never;  // s
  bool done = true;
};

/// A study and its cases that are measured.
struct Measuring {
  explicit Measuring(const std::string& path, bool to_check)
      : study(load_study(path)), check(to_check), runner(study.name, "") {
    for (const StudyCase& one : study.cases) cases.push_back({&one});
    std::sort(cases.begin(), cases.end(),
              [](const Measured& a, const Measured& b) { return a.one->id < b.one->id; });
    cases.resize(std::min(cases.size(), cases_of_a_study));
    for (const Measured& m : cases) runner.run(*m.one);  // makes the profiles of references
  }
  void repeat() {
    for (Measured& m : cases) {
      const double before = runner.cpu_seconds();
      const Record record = runner.run(*m.one);
      m.done = record.status == CaseStatus::done;
      m.solver = std::min(m.solver, record.cpu_seconds);
      m.judging = std::min(m.judging, runner.cpu_seconds() - before - record.cpu_seconds);
    }
  }
  void leave_out_what_broke_down() {
    std::erase_if(cases, [](const Measured& m) { return !m.done; });
  }

  Study study;
  bool check;
  CaseRunner runner;
  std::vector<Measured> cases;
};

double profile_seconds(const Study& study) {
  double fastest = never;
  for (int k = 0; k < repetitions; ++k) {
    const std::clock_t before = std::clock();
    reference_profile(study.cases.front().scene);
    fastest = std::min(fastest, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  return fastest;
}

std::vector<double> terms_of(const CostTerms& terms) {
  return {terms.begin(), terms.end()};
}

CostConstants fit(const std::vector<Measured>& cases) {
  std::array<std::vector<Measurement>, cost_family_names.size()> solver;
  std::vector<Measurement> judging;
  for (const Measured& m : cases) {
    const CaseCost cost = case_cost(m.one->scene);
    solver[static_cast<std::size_t>(cost.family)].push_back({terms_of(cost.terms), m.solver});
    judging.push_back({{1.0, cost.points}, m.judging});
  }
  CostConstants constants = cost_constants();
  for (std::size_t f = 0; f < solver.size(); ++f) {
    const std::vector<double> fitted = relative_fit(solver[f]);
    std::copy(fitted.begin(), fitted.end(), constants.solver[f].begin());
    fmt::print("{:<10} {{{:.3g}}}{}\n", cost_family_names[f], fmt::join(constants.solver[f], ", "),
               fitted.empty() ? "  as it was" : "");
  }
  const std::vector<double> fitted = relative_fit(judging);
  std::copy(fitted.begin(), fitted.end(), constants.judging.begin());
  fmt::print("{:<10} {{{:.3g}}}\n", "judging", fmt::join(constants.judging, ", "));
  return constants;
}

struct Sum {
  std::size_t cases = 0;
  double measured = 0.0;
  double entered = 0.0;  // by the constants of the program
  double fitted = 0.0;
  std::vector<double> errors;  // of single cases, by the fitted constants
};

void compare(const std::string& study, const std::vector<Measured>& cases,
             const CostConstants& fitted) {
  std::map<std::string, Sum> sums;
  for (const Measured& m : cases) {
    const CaseCost cost = case_cost(m.one->scene);
    const double measured = m.solver + m.judging;
    const auto predicted = [&](const CostConstants& constants) {
      return solver_seconds(cost, constants) + judging_seconds(cost, constants);
    };
    const std::string family(cost_family_names[static_cast<std::size_t>(cost.family)]);
    for (Sum* sum : {&sums[family], &sums["~ all"]}) {
      ++sum->cases;
      sum->measured += measured;
      sum->entered += predicted(cost_constants());
      sum->fitted += predicted(fitted);
      sum->errors.push_back(std::abs(predicted(fitted) / measured - 1.0));
    }
  }
  for (auto& [family, sum] : sums) {
    std::sort(sum.errors.begin(), sum.errors.end());
    fmt::print("{:<28} {:<10} {:>5} {:>9.3f} {:>8.3f} {:>8.3f} {:>10.0f} % {:>7.0f} %\n", study,
               family, sum.cases, sum.measured, sum.entered / sum.measured,
               sum.fitted / sum.measured, 100.0 * sum.errors[sum.errors.size() / 2],
               100.0 * sum.errors[sum.errors.size() * 9 / 10]);
  }
}

int run(int argc, char** argv) {
  std::vector<std::unique_ptr<Measuring>> studies;
  bool check = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--check") == 0) {
      check = true;
    } else {
      studies.push_back(std::make_unique<Measuring>(argv[i], check));
    }
  }
  if (studies.empty()) throw InputError("porowave-cost-fit: expected STUDY... [--check STUDY...]");
  for (int k = 0; k < repetitions; ++k) {
    for (const auto& one : studies) one->repeat();
  }
  std::vector<Measured> to_fit;
  for (const auto& one : studies) {
    one->leave_out_what_broke_down();
    if (!one->check) to_fit.insert(to_fit.end(), one->cases.begin(), one->cases.end());
    fmt::print("{}: profile of the reference {:.2g} s\n", one->study.name,
               profile_seconds(one->study));
  }
  fmt::print("calibration loop: {:.2f} ns\n", calibration_nanoseconds());
  const CostConstants fitted = fit(to_fit);
  fmt::print("{:<28} {:<10} {:>5} {:>9} {:>8} {:>8} {:>12} {:>9}\n", "study", "family", "cases",
             "s", "entered", "fitted", "median error", "9 of 10");
  for (const auto& one : studies) {
    compare(one->study.name + (one->check ? " (not fitted)" : ""), one->cases, fitted);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
