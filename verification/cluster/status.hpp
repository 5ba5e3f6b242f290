#pragma once

#include <filesystem>
#include <vector>

#include "verification/cluster/case_list.hpp"
#include "verification/store/record.hpp"

namespace porowave::verification {

/// What has become of the cases of a study.
struct StudyStatus {
  std::array<std::size_t, 4> by_status{};  ///< in the order of CaseStatus
  std::size_t missing = 0;                 ///< have no row
  CaseList unfinished;                     ///< missing and failed ones
  /// Predicted seconds of the cases that ended in the last ten minutes, a second of wall time; 0 if
  /// none did.
  double rate = 0.0;
  double seconds_left() const { return unfinished.seconds() / rate; }  ///< infinite at rate 0
};

/// Looks every case up in the store and, if it is not finished there, in the shards. Stores that
/// are not there have no rows; a case counts once, in however many stores it is. `now` is UTC,
/// seconds since 1970. Throws InputError if one of them is no store.
StudyStatus study_status(const CaseList& cases, const std::string& store,
                         const std::vector<std::string>& shards, std::int64_t now);

}  // namespace porowave::verification
