// Wrong norms, judged by what norms are.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "verification/faults/norm_check.hpp"

namespace porowave::verification::faults {

namespace {

using In = std::span<const double>;
using List = std::vector<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool same(double a, double b) {
  return std::abs(a - b) <= 1e-14 * (std::abs(a) + std::abs(b));
}
bool same(const Norms& a, const Norms& b) {
  return same(a.l1, b.l1) && same(a.l2, b.l2) && same(a.linf, b.linf);
}
bool all_nan(const Norms& n) {
  return std::isnan(n.l1) && std::isnan(n.l2) && std::isnan(n.linf);
}

struct Fact {
  std::string name;
  std::function<bool(const NormFunction&)> holds;
};

const std::vector<Fact>& facts() {
  static const std::vector<Fact> all = {
      {"errors (3, -4) of a reference (5, 12) are 7/17, 5/13, 4/12",
       [](const NormFunction& norms) {
         return same(norms(List{8, 8}, List{5, 12}, List{1, 1}), {7.0 / 17, 5.0 / 13, 4.0 / 12});
       }},
      {"a weight of 3 is three times the same place",
       [](const NormFunction& norms) {
         return same(norms(List{1, 5}, List{2, 3}, List{3, 1}),
                     norms(List{1, 1, 1, 5}, List{2, 2, 2, 3}, List{1, 1, 1, 1}));
       }},
      {"other units change nothing",
       [](const NormFunction& norms) {
         return same(norms(List{1, 5}, List{2, 3}, List{3, 1}),
                     norms(List{1e3, 5e3}, List{2e3, 3e3}, List{6, 2}));
       }},
      {"a value that is not a number never looks small",
       [](const NormFunction& norms) {
         return all_nan(norms(List{1, nan, 1}, List{1, 1, 1}, List{1, 1, 1})) &&
                all_nan(norms(List{nan, 1, 1}, List{1, 1, 1}, List{1, 1, 1}));
       }},
      {"an error where the reference is zero is not zero",
       [](const NormFunction& norms) {
         return !(norms(List{1, 1}, List{0, 0}, List{1, 1}).l2 < 1.0);
       }},
      {"the same reversed is the same",
       [](const NormFunction& norms) {
         return same(norms(List{1, 5, 9}, List{2, 3, 1}, List{3, 1, 2}),
                     norms(List{9, 5, 1}, List{1, 3, 2}, List{2, 1, 3}));
       }},
  };
  return all;
}

/// e^T w and the largest, over the same of r, without any of the precautions.
Norms plain(In values, In reference, In weights, const std::function<double(double)>& size) {
  double e1 = 0, r1 = 0, e2 = 0, r2 = 0, em = 0, rm = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double e = size(values[i] - reference[i]);
    const double r = size(reference[i]);
    e1 += weights[i] * e;
    r1 += weights[i] * r;
    e2 += weights[i] * e * e;
    r2 += weights[i] * r * r;
    em = std::max(em, e);
    rm = std::max(rm, r);
  }
  return {e1 / r1, std::sqrt(e2 / r2), em / rm};
}

Fault in_norm(const std::string& what, const std::string& named, const NormFunction& wrong) {
  return {"norm", what, named, [wrong] { return caught_by_norm_facts(wrong); }};
}

double magnitude(double e) {
  return std::abs(e);
}

}  // namespace

Catch caught_by_norm_facts(const NormFunction& norms) {
  for (const Fact& fact : facts()) {
    if (!fact.holds(norms)) return {"facts of norms", "does not hold: " + fact.name};
  }
  return {"facts of norms", ""};
}

std::vector<Fault> norm_faults() {
  return {
      in_norm("errors without their sign taken off", "7/17",
              [](In v, In r, In w) { return plain(v, r, w, [](double e) { return e; }); }),
      in_norm("volumes of the points forgotten", "weight of 3",
              [](In v, In r, In) { return relative_norms(v, r, List(v.size(), 1.0)); }),
      in_norm("relative to the computed values", "7/17",
              [](In v, In r, In w) { return relative_norms(r, v, w); }),
      in_norm("no root in L2", "7/17",
              [](In v, In r, In w) {
                Norms n = relative_norms(v, r, w);
                n.l2 *= n.l2;
                return n;
              }),
      in_norm("NaN dropped by std::max", "not a number",
              [](In v, In r, In w) {
                Norms n = plain(v, r, w, magnitude);
                if (std::isnan(n.l2)) n.l1 = n.l2 = n.linf;
                return n;
              }),
      in_norm("the last point left out", "7/17",
              [](In v, In r, In w) {
                const std::size_t n = std::max<std::size_t>(1, v.size() - 1);
                return relative_norms(v.first(n), r.first(n), w.first(n));
              }),
      in_norm("absolute errors", "7/17",
              [](In v, In r, In w) {
                const Norms n = relative_norms(v, r, w);
                const double sum = std::accumulate(r.begin(), r.end(), 0.0);
                return Norms{n.l1 * sum, n.l2 * sum, n.linf * sum};
              }),
      in_norm("nothing divided by nothing is no error", "reference is zero",
              [](In v, In r, In w) {
                const bool rest = std::all_of(r.begin(), r.end(), [](double x) { return x == 0; });
                return rest ? Norms{} : relative_norms(v, r, w);
              }),
  };
}

}  // namespace porowave::verification::faults
