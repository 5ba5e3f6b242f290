#include "verification/norms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "verification/not_a_number.hpp"

namespace porowave::verification {

namespace {

double ratio(double error, double reference) {
  if (!std::isfinite(error) || !std::isfinite(reference)) return nan;
  if (reference > 0.0) return error / reference;
  return error == 0.0 ? 0.0 : nan;
}

}  // namespace

Norms relative_norms(std::span<const double> values, std::span<const double> reference,
                     std::span<const double> weights) {
  if (values.empty() || values.size() != reference.size() || values.size() != weights.size()) {
    throw std::invalid_argument("norms: as many values, references and weights, at least one");
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    largest = std::max({largest, std::abs(values[i]), std::abs(reference[i])});
  }
  // By a power of two, which no ratio feels: squares of values below 1e-154 would be zero.
  const double unit = std::isfinite(largest) && largest > 0.0
                          ? std::scalbn(1.0, std::min(-std::ilogb(largest), 1000))
                          : 1.0;
  // std::max would drop a NaN; the sums keep it, so they decide about finiteness.
  double e1 = 0.0, e2 = 0.0, e_max = 0.0;
  double r1 = 0.0, r2 = 0.0, r_max = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double e = unit * std::abs(values[i] - reference[i]);
    const double r = unit * std::abs(reference[i]);
    e1 += weights[i] * e;
    r1 += weights[i] * r;
    e2 += weights[i] * e * e;
    r2 += weights[i] * r * r;
    e_max = std::max(e_max, e);
    r_max = std::max(r_max, r);
  }
  const double l1 = ratio(e1, r1);
  if (!std::isfinite(e1) || !std::isfinite(r1)) return {nan, nan, nan};
  return {l1, std::sqrt(ratio(e2, r2)), ratio(e_max, r_max)};
}

}  // namespace porowave::verification
