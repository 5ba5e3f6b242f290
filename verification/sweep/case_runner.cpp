#include "verification/sweep/case_runner.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <limits>
#include <new>
#include <set>

#include "reference/problem/errors.hpp"
#include "verification/adapters/adapter_run.hpp"
#include "verification/cost/calibration.hpp"

namespace porowave::verification {

namespace {

std::string now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

std::int64_t thread_cpu_nanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

void set_result(const RunResult& result, Record& record) {
  record.steps = result.steps;
  record.time_step = result.time_step;
  record.points = static_cast<std::int64_t>(result.points);
  record.cpu_seconds = result.cost.cpu_seconds;
  record.wall_seconds = result.cost.wall_seconds;
  record.peak_rss_bytes = result.cost.peak_rss_bytes;
  if (result.breakdown) {
    record.status = CaseStatus::broke_down;
    record.reason = result.breakdown->reason;
    return;
  }
  record.measures.clear();
  for (const FieldError& error : result.errors) {
    for (const Norms& norms : {error.points, error.field}) {
      record.measures.insert(record.measures.end(), {norms.l1, norms.l2, norms.linf});
    }
  }
  record.measures.insert(record.measures.end(), {result.reference_error, result.largest_strain});
  const std::vector<double> waves = wave_measure_values(result.measures);
  record.measures.insert(record.measures.end(), waves.begin(), waves.end());
}

/// Only errors at the points are known.
void set_result(const AdapterRun& run, Record& record) {
  record.points = static_cast<std::int64_t>(run.points);
  record.cpu_seconds = run.cost.cpu_seconds;
  record.wall_seconds = run.cost.wall_seconds;
  record.peak_rss_bytes = run.cost.peak_rss_bytes;
  if (run.failure) {
    record.status = CaseStatus::broke_down;
    record.reason = *run.failure;
    return;
  }
  const auto set = [&](std::string_view name, double value) {
    record.measures[measure_index(name).value()] = value;
  };
  for (std::size_t f = 0; f < field_names.size(); ++f) {
    if (!run.errors[f]) continue;
    set(fmt::format("{}_points_l1", field_names[f]), run.errors[f]->l1);
    set(fmt::format("{}_points_l2", field_names[f]), run.errors[f]->l2);
    set(fmt::format("{}_points_linf", field_names[f]), run.errors[f]->linf);
  }
  set("reference_error", run.reference_error);
}

void set_failure(CaseStatus status, const char* reason, Record& record) {
  record.status = status;
  record.reason = reason;
}

/// What a profile depends on. The problem alone is what stands before the choices of the method.
std::string profile_key(const StudyCase& one) {
  const auto end =
      std::min(one.specification.find("\n[discretization]"), one.specification.find("\n[time]"));
  return fmt::format("{}\n{} {}", one.specification.substr(0, end), one.scene.time.end,
                     solver::ColumnSolver::grid_length(one.scene));
}

}  // namespace

Record CaseRunner::run(const StudyCase& one) {
  const std::int64_t start = thread_cpu_nanoseconds();
  Record record;
  record.id = one.id;
  record.study = study_;
  record.specification = one.specification;
  if (adapter_) record.specification += "\n" + adapter_->toml();
  record.provenance = provenance_;
  record.measures.assign(measure_names().size(), std::numeric_limits<double>::quiet_NaN());
  try {
    const ProfilePointer profile = profile_of(one);
    if (adapter_) {
      set_result(run_adapter(*adapter_, one.specification, one.scene, *profile), record);
    } else {
      record.calibration_ns = recent_calibration_nanoseconds();
      set_result(run_(one.scene, *profile), record);
    }
  } catch (const InputError& error) {
    set_failure(CaseStatus::refused, error.what(), record);
  } catch (const BreakdownError& error) {
    set_failure(CaseStatus::broke_down, error.what(), record);
  } catch (const std::bad_alloc&) {
    set_failure(CaseStatus::failed, "out of memory", record);
  } catch (const std::exception& error) {
    set_failure(CaseStatus::failed, error.what(), record);
  }
  record.finished = now();
  cpu_nanoseconds_ += thread_cpu_nanoseconds() - start;
  return record;
}

CaseRunner::ProfilePointer CaseRunner::profile_of(const StudyCase& one) {
  const std::string key = profile_key(one);
  std::promise<ProfilePointer> promise;
  std::shared_future<ProfilePointer> future;
  bool first = false;
  {
    const std::lock_guard lock(mutex_);
    const auto [entry, fresh] = profiles_.try_emplace(key);
    if (fresh) entry->second = promise.get_future().share();
    future = entry->second;
    first = fresh;
  }
  if (first) {
    try {
      promise.set_value(reference_profile(one.scene));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  }
  return future.get();
}

std::size_t profile_count(const Study& study) {
  std::set<std::string> keys;
  for (const StudyCase& one : study.cases) keys.insert(profile_key(one));
  return keys.size();
}

}  // namespace porowave::verification
