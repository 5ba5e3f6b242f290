#include "verification/cluster/machine_speed.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <thread>

#include "verification/cost/cost_model.hpp"
#include "verification/store/store.hpp"
#include "verification/sweep/case_runner.hpp"

namespace porowave::verification {

namespace {

std::map<std::string_view, const StudyCase*> by_id(const Study& study) {
  std::map<std::string_view, const StudyCase*> cases;
  for (const StudyCase& one : study.cases) cases.emplace(one.id, &one);
  return cases;
}

}  // namespace

std::optional<MachineSpeed> speed_of_rows(const Study& study, const CaseList& all,
                                          const std::vector<std::string>& stores) {
  constexpr std::size_t most_cases = 2000;
  constexpr double least_seconds = 0.5;
  const auto cases = by_id(study);
  const std::size_t looked_at = std::min(all.entries.size(), most_cases);
  double measured = 0.0;
  double predicted = 0.0;
  MachineSpeed speed{.stored = true};
  for (const std::string& path : stores) {
    if (!std::filesystem::exists(path)) continue;
    const Store store = Store::open(path);
    for (std::size_t i = 0; i < looked_at; ++i) {
      const auto row = store.find(std::string(all.entries[i].id_text()));
      if (!row || row->status == CaseStatus::failed) continue;
      const solver::Case& scene = cases.at(all.entries[i].id_text())->scene;
      measured += row->cpu_seconds;
      predicted += study.adapter ? static_cast<double>(all.entries[i].seconds)
                                 : predicted_solver_seconds(scene);
      ++speed.cases;
    }
  }
  if (predicted < least_seconds) return std::nullopt;
  speed.factor = measured / predicted;
  return speed;
}

std::vector<std::size_t> equal_steps(const std::vector<double>& works, std::size_t count) {
  const double all = std::accumulate(works.begin(), works.end(), 0.0);
  std::vector<std::size_t> taken;
  double sum = 0.0;
  for (std::size_t i = 0; i < works.size(); ++i) {
    sum += works[i];
    while (taken.size() < count &&
           (static_cast<double>(taken.size()) + 0.5) / static_cast<double>(count) * all < sum) {
      taken.push_back(i);
    }
  }
  return taken;
}

MachineSpeed speed_of_trial(const Study& study, const CaseList& cases, double seconds) {
  MachineSpeed speed;
  if (study.adapter) return speed;
  const auto scenes = by_id(study);
  std::vector<const StudyCase*> candidates;
  std::vector<double> works;
  for (const CaseList::Entry& entry : cases.entries) {
    const auto predicted = static_cast<double>(entry.seconds);
    if (predicted > seconds / 4.0) continue;
    candidates.push_back(scenes.at(entry.id_text()));
    works.push_back(predicted);
  }
  if (works.empty()) return speed;
  double sum = 0.0;
  double squares = 0.0;
  for (const double work : works) {
    sum += work;
    squares += work * work;
  }
  // A case taken so is squares / sum long in the mean.
  const auto count = static_cast<std::size_t>(std::max(1.0, seconds * sum / squares));
  CaseRunner runner(study.name, "");
  double ratios = 0.0;
  const auto run = [&] {
    for (const std::size_t i : equal_steps(works, std::min(count, works.size()))) {
      runner.run(*candidates[i]);  // makes the profile, wakes the processor
      const double before = runner.cpu_seconds();
      runner.run(*candidates[i]);
      ratios += (runner.cpu_seconds() - before) / works[i];
      ++speed.cases;
    }
  };
  // In a thread of its own, as a sweep does: memory is got in another way there.
  std::jthread(run).join();
  speed.factor = ratios / static_cast<double>(speed.cases);
  return speed;
}

}  // namespace porowave::verification
