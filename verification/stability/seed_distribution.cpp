#include "verification/stability/seed_distribution.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace porowave::verification {

namespace {

double growth_at_shortest(const solver::CriticalStep& critical) {
  return critical.scan.empty() ? 0.0 : critical.scan.back().growth;
}

/// A seed is worse if its limit is lower, and of equal limits if noise grows more at the shortest
/// of the steps that were tried.
bool worse(const MappedStability& a, const MappedStability& b) {
  if (a.critical.courant != b.critical.courant) return a.critical.courant < b.critical.courant;
  return growth_at_shortest(a.critical) > growth_at_shortest(b.critical);
}

}  // namespace

double SeedDistribution::quantile(double share) const {
  if (courant.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = std::ceil(share * static_cast<double>(courant.size())) - 1.0;
  return courant[static_cast<std::size_t>(
      std::clamp(place, 0.0, static_cast<double>(courant.size() - 1)))];
}

std::vector<SeedDistribution> seed_distributions(const Study& study,
                                                 const std::vector<MappedStability>& map) {
  if (!study.seed) throw std::invalid_argument("seed distributions: a study without seeds");
  std::vector<SeedDistribution> found;
  std::vector<const MappedStability*> worst;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < map.size(); ++i) {
    std::vector<TomlValue> others = study.cases[i].coordinates;
    const TomlValue seed = others[*study.seed];
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(*study.seed));
    std::string key;
    for (const TomlValue& value : others) key += value.text() + '\n';
    const auto [place, is_new] = places.try_emplace(key, found.size());
    if (is_new) {
      found.push_back({});
      found.back().coordinates = std::move(others);
      worst.push_back(nullptr);
    }
    SeedDistribution& one = found[place->second];
    if (!map[i].refused.empty()) {
      ++one.refused;
      continue;
    }
    one.courant.push_back(map[i].critical.courant);
    one.unlimited += map[i].critical.unstable == 0.0 && map[i].critical.courant > 0.0 ? 1 : 0;
    const MappedStability*& so_far = worst[place->second];
    if (so_far == nullptr || worse(map[i], *so_far)) {
      so_far = &map[i];
      one.worst_seed = plain_text(seed);
    }
  }
  for (SeedDistribution& one : found) std::sort(one.courant.begin(), one.courant.end());
  return found;
}

void write_seed_csv(const Study& study, const std::vector<SeedDistribution>& distributions,
                    std::ostream& out) {
  for (const Axis& axis : study.axes) {
    if (&axis != &study.axes[study.seed.value()]) out << axis.name() << ',';
  }
  out << "seeds,refused,unstable_at_every,stable_to_highest,critical_least,critical_05,"
         "critical_25,critical_50,critical_75,critical_95,worst_seed\n";
  for (const SeedDistribution& one : distributions) {
    for (const TomlValue& value : one.coordinates) out << in_csv(plain_text(value)) << ',';
    const auto unstable = std::count(one.courant.begin(), one.courant.end(), 0.0);
    fmt::print(out, "{},{},{},{}", one.courant.size() + static_cast<std::size_t>(one.refused),
               one.refused, unstable, one.unlimited);
    for (const double share : {0.0, 0.05, 0.25, 0.5, 0.75, 0.95}) {
      out << ',' << (one.courant.empty() ? "" : fmt::format("{:.6g}", one.quantile(share)));
    }
    out << ',' << one.worst_seed << '\n';
  }
}

}  // namespace porowave::verification
