#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "reference/profile.hpp"
#include "verification/run.hpp"
#include "verification/store/record.hpp"
#include "verification/study/study.hpp"

namespace porowave::verification {

/// How a case is run: run_case, or another solver in the same process.
using RunFunction = std::function<RunResult(const solver::Case&, const reference::Profile&)>;

/// Runs cases of studies. Reference profiles are shared by the cases that have the same problem,
/// end and grid length. May be used by several threads at a time.
class CaseRunner {
 public:
  /// With an adapter its solver runs the cases, else `run`.
  CaseRunner(std::string study, std::string provenance, std::optional<Adapter> adapter = {},
             RunFunction run = run_case)
      : study_(std::move(study)),
        provenance_(std::move(provenance)),
        adapter_(std::move(adapter)),
        run_(std::move(run)) {}

  /// A case with its errors and cost. Nothing that goes wrong in it is thrown: it is the record's
  /// status and reason.
  Record run(const StudyCase& one);
  /// CPU time of all that was run, s: solver, reference and errors.
  double cpu_seconds() const { return 1e-9 * static_cast<double>(cpu_nanoseconds_); }

 private:
  using ProfilePointer = std::shared_ptr<const reference::Profile>;
  ProfilePointer profile_of(const StudyCase& one);

  std::atomic<std::int64_t> cpu_nanoseconds_ = 0;
  std::string study_;
  std::string provenance_;
  std::optional<Adapter> adapter_;
  RunFunction run_;
  std::mutex mutex_;
  std::map<std::string, std::shared_future<ProfilePointer>> profiles_;
};

/// Profiles of references that a runner makes for all cases of a study, and CPU time of one, s, by
/// porowave-cost-fit: between 4 and 17 ms.
std::size_t profile_count(const Study& study);
inline constexpr double seconds_per_profile = 0.008;

}  // namespace porowave::verification
