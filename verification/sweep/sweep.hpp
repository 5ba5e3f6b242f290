#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "verification/store/store.hpp"
#include "verification/study/study.hpp"
#include "verification/sweep/case_runner.hpp"

namespace porowave::verification {

/// Part i of n, counted from 1.
struct Shard {
  int index = 1;
  int count = 1;
};

struct SweepOptions {
  int jobs = 0;  ///< threads; 0 for one a core
  std::optional<Shard> shard = {};
  std::optional<std::set<std::string>> only = {};  ///< ids of cases; all if absent
  /// Called about ten times a second from the thread that called `sweep`: cases done, cases to do.
  std::function<void(std::size_t, std::size_t)> progress = {};
  /// When it becomes true no case is begun any more; those under way are finished and stored.
  const std::atomic<bool>* stop = nullptr;
  /// What runs the cases of a study without [adapter]; called from several threads at a time. Rows
  /// are keyed by the case alone: results of another solver belong in a store of their own.
  RunFunction run = run_case;
};

struct SweepSummary {
  std::size_t cases = 0;   ///< of the study, or of the shard
  std::size_t reused = 0;  ///< in the store before, or done by another sweep meanwhile
  std::array<std::size_t, 4> by_status{};  ///< of those run now, in the order of CaseStatus
  double solver_cpu_seconds = 0.0;         ///< in those run now
  double case_cpu_seconds = 0.0;           ///< the same with reference and errors
  bool stopped = false;
};

/// Runs the cases of a study that the store does not have, the longest first, and stores every
/// tenth of a second those that have ended. Killed at any moment it loses only them and those under
/// way; run again it continues. Several sweeps may fill one store at a time.
/// Throws EnvironmentError if the store cannot be written.
SweepSummary sweep(const Study& study, Store& store, const SweepOptions& options = {});

/// The cases of a shard: those with the longest predicted work first, each goes to the shard with
/// the least work so far. With `only`, the shards are those of the cases with these ids.
std::vector<const StudyCase*> cases_of(const Study& study, const std::optional<Shard>& shard,
                                       const std::optional<std::set<std::string>>& only = {});

}  // namespace porowave::verification
