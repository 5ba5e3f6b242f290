#include "verification/sweep/shares.hpp"

#include <functional>
#include <queue>
#include <utility>

namespace porowave::verification {

std::vector<int> shared_out(std::span<const double> works, int shares) {
  using Load = std::pair<double, int>;  // work, share
  std::priority_queue<Load, std::vector<Load>, std::greater<>> lightest;
  for (int i = 0; i < shares; ++i) lightest.emplace(0.0, i);
  std::vector<int> share_of;
  share_of.reserve(works.size());
  for (const double work : works) {
    const auto [load, index] = lightest.top();
    lightest.pop();
    lightest.emplace(load + work, index);
    share_of.push_back(index);
  }
  return share_of;
}

std::vector<double> share_sums(std::span<const double> works, std::span<const int> share_of,
                               int shares) {
  std::vector<double> sums(static_cast<std::size_t>(shares), 0.0);
  for (std::size_t i = 0; i < works.size(); ++i) {
    sums[static_cast<std::size_t>(share_of[i])] += works[i];
  }
  return sums;
}

}  // namespace porowave::verification
