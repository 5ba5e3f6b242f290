#include "verification/cluster/status.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "verification/store/store.hpp"

namespace porowave::verification {

namespace {

constexpr std::int64_t window = 600;  // s

std::string utc(std::int64_t time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(time)));
}

/// Seconds since 1970 of such a text; none if it is not one.
std::optional<std::int64_t> time_of(const std::string& text) {
  std::tm parts{};
  if (std::sscanf(text.c_str(), "%d-%d-%dT%d:%d:%dZ", &parts.tm_year, &parts.tm_mon, &parts.tm_mday,
                  &parts.tm_hour, &parts.tm_min, &parts.tm_sec) != 6) {
    return std::nullopt;
  }
  parts.tm_year -= 1900;
  parts.tm_mon -= 1;
  return static_cast<std::int64_t>(timegm(&parts));
}

class LookUp {
 public:
  LookUp(const CaseList& cases, std::int64_t now)
      : entries_(cases.entries),
        states_(entries_.size(), missing),
        now_(now),
        since_(utc(now - window)) {}

  bool complete() const { return unfinished_ == 0; }

  void add(const std::string& path) {
    std::size_t at = 0;
    Store::open(path).visit_ends(
        [&](std::string_view id, std::string_view status, std::string_view finished) {
          while (at < entries_.size() && entries_[at].id_text() < id) ++at;
          if (at < entries_.size() && entries_[at].id_text() == id) see(at, status, finished);
        });
  }

  StudyStatus result() const {
    StudyStatus status;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (states_[i] == missing) {
        ++status.missing;
      } else {
        ++status.by_status[states_[i]];
      }
      if (open(i)) status.unfinished.entries.push_back(entries_[i]);
    }
    if (const auto first = time_of(first_)) {
      status.rate = recent_ / static_cast<double>(std::max<std::int64_t>(1, now_ - *first));
    }
    return status;
  }

 private:
  static constexpr std::uint8_t missing = 255;
  static constexpr auto failed = static_cast<std::uint8_t>(CaseStatus::failed);

  bool open(std::size_t i) const { return states_[i] == missing || states_[i] == failed; }

  void see(std::size_t i, std::string_view status, std::string_view finished) {
    if (!open(i)) return;
    const auto* const found = std::find(case_status_names.begin(), case_status_names.end(), status);
    states_[i] = found == case_status_names.end()
                     ? failed
                     : static_cast<std::uint8_t>(found - case_status_names.begin());
    if (open(i)) return;
    --unfinished_;
    if (finished < since_) return;
    recent_ += static_cast<double>(entries_[i].seconds);
    if (first_.empty() || finished < first_) first_ = finished;
  }

  const std::vector<CaseList::Entry>& entries_;
  std::vector<std::uint8_t> states_;
  std::size_t unfinished_ = states_.size();
  std::int64_t now_;
  std::string since_;
  std::string first_;  ///< end of the first case in the window
  double recent_ = 0.0;
};

}  // namespace

StudyStatus study_status(const CaseList& cases, const std::string& store,
                         const std::vector<std::string>& shards, std::int64_t now) {
  LookUp look_up(cases, now);
  if (std::filesystem::exists(store)) look_up.add(store);
  for (const std::string& shard : shards) {
    if (look_up.complete()) break;
    look_up.add(shard);
  }
  return look_up.result();
}

}  // namespace porowave::verification
