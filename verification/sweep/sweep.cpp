#include "verification/sweep/sweep.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "verification/cost/cost_model.hpp"
#include "verification/study/case_identity.hpp"
#include "verification/sweep/shares.hpp"

namespace porowave::verification {

namespace {

constexpr auto store_interval = std::chrono::milliseconds(100);
/// How often the rows of other sweeps on the same store are looked up.
constexpr auto others_interval = std::chrono::seconds(2);

/// Records on their way from the threads that make them to the one that stores them.
class Mailbox {
 public:
  void put(Record record) {
    const std::lock_guard lock(mutex_);
    records_.push_back(std::move(record));
  }
  void worker_ended() {
    const std::lock_guard lock(mutex_);
    ++ended_;
    changed_.notify_one();
  }
  /// Waits for `store_interval`, or until all workers have ended.
  std::vector<Record> take(std::size_t workers, bool& all_ended) {
    std::unique_lock lock(mutex_);
    all_ended = changed_.wait_for(lock, store_interval, [&] { return ended_ == workers; });
    return std::exchange(records_, {});
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Record> records_;
  std::size_t ended_ = 0;
};

/// Cases that need not be run, shared with the workers.
class Finished {
 public:
  bool contains(const std::string& id) const {
    const std::lock_guard lock(mutex_);
    return ids_.contains(id);
  }
  void set(std::set<std::string> ids) {
    const std::lock_guard lock(mutex_);
    ids_ = std::move(ids);
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::string> ids_;
};

/// Longest first, in classes of work within a factor of two. Within a class every process has its
/// own order, so that sweeps on one store seldom take the same case.
std::vector<const StudyCase*> in_running_order(std::vector<const StudyCase*> cases) {
  struct Place {
    int work_class;
    std::string order;
    const StudyCase* one;
  };
  std::vector<Place> places;
  for (const StudyCase* one : cases) {
    places.push_back({std::ilogb(predicted_seconds(one->scene)),
                      text_hash(one->id + std::to_string(getpid())), one});
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.work_class != b.work_class ? a.work_class > b.work_class : a.order < b.order;
  });
  std::transform(places.begin(), places.end(), cases.begin(), [](const Place& p) { return p.one; });
  return cases;
}

std::size_t thread_count(const SweepOptions& options, std::size_t cases) {
  const auto wanted = options.jobs > 0 ? static_cast<std::size_t>(options.jobs)
                                       : std::max(1U, std::thread::hardware_concurrency());
  return std::min(wanted, cases);
}

}  // namespace

std::vector<const StudyCase*> cases_of(const Study& study, const std::optional<Shard>& shard,
                                       const std::optional<std::set<std::string>>& only) {
  std::vector<const StudyCase*> cases;
  for (const StudyCase& one : study.cases) {
    if (!only || only->contains(one.id)) cases.push_back(&one);
  }
  if (!shard) return cases;
  using Weighed = std::pair<double, const StudyCase*>;
  std::vector<Weighed> weighed;
  for (const StudyCase* one : cases) weighed.emplace_back(predicted_seconds(one->scene), one);
  // The same order in every process: by work, then by identity.
  std::sort(weighed.begin(), weighed.end(), [](const Weighed& a, const Weighed& b) {
    return a.first != b.first ? a.first > b.first : a.second->id < b.second->id;
  });
  std::vector<double> works;
  for (const auto& [work, one] : weighed) works.push_back(work);
  const std::vector<int> share_of = shared_out(works, shard->count);
  std::vector<const StudyCase*> part;
  for (std::size_t i = 0; i < weighed.size(); ++i) {
    if (share_of[i] + 1 == shard->index) part.push_back(weighed[i].second);
  }
  return part;
}

SweepSummary sweep(const Study& study, Store& store, const SweepOptions& options) {
  const Provenance here = current_provenance();
  store.add(here);
  SweepSummary summary;
  std::vector<const StudyCase*> cases = cases_of(study, options.shard, options.only);
  summary.cases = cases.size();
  std::set<std::string> known = store.finished_ids();
  std::erase_if(cases, [&](const StudyCase* one) { return known.contains(one->id); });
  summary.reused = summary.cases - cases.size();
  cases = in_running_order(std::move(cases));
  Finished finished;
  finished.set(std::move(known));

  CaseRunner runner(study.name, here.id, study.adapter, options.run);
  Mailbox mailbox;
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> skipped = 0;
  std::atomic<bool> give_up = false;
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size(); i = next++) {
      if (give_up || (options.stop != nullptr && *options.stop)) break;
      if (finished.contains(cases[i]->id)) {
        ++skipped;
        continue;
      }
      mailbox.put(runner.run(*cases[i]));
    }
    mailbox.worker_ended();
  };
  const std::size_t workers = thread_count(options, cases.size());
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < workers; ++i) threads.emplace_back(work);

  std::size_t done = 0;
  auto looked = std::chrono::steady_clock::now();
  try {
    for (bool all_ended = workers == 0; !all_ended;) {
      const std::vector<Record> records = mailbox.take(workers, all_ended);
      if (!records.empty()) store.add(records);
      for (const Record& record : records) {
        ++summary.by_status[static_cast<std::size_t>(record.status)];
        summary.solver_cpu_seconds += record.cpu_seconds;
      }
      done += records.size();
      if (options.progress) options.progress(done + skipped, cases.size());
      if (std::chrono::steady_clock::now() - looked > others_interval) {
        finished.set(store.finished_ids());
        looked = std::chrono::steady_clock::now();
      }
    }
  } catch (...) {
    give_up = true;  // the threads end after their case; then the error goes on
    throw;
  }
  summary.reused += skipped;
  summary.case_cpu_seconds = runner.cpu_seconds();
  summary.stopped = done + skipped < cases.size();
  return summary;
}

}  // namespace porowave::verification
