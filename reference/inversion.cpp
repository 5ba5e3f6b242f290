#include "reference/inversion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/constants.hpp"

namespace porowave::reference {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Terms smaller than this share of the load are not summed.
constexpr double negligible = 1e-18;
/// The first level scans this far in u beyond the last term that counted.
constexpr double beyond = 2.5;
constexpr double furthest = 160.0;
constexpr int first_accepted_level = 2;
constexpr int last_level = 9;
constexpr std::size_t most_nodes = 1 << 14;
/// The change before the last one must have been below this share of the load: two sums that agree
/// by chance do not converge.
constexpr double converging = 0.05;
class Trapezoid {
 public:
  Trapezoid(Integrand& integrand, NodeTable& table) : integrand_(integrand), table_(table) {
    integrand_.reset_rates();
    for (std::size_t j = 0;; ++j) {
      const Node& node = table_.at(0, j);
      if (node.u > std::min(furthest, last_ + beyond) || !add(node)) break;
    }
    store();
  }

  /// Adds the nodes of the next level, up to the last term that counted and its neighbour.
  void refine() {
    ++level_;
    const double end = last_ + 2.0 * NodeTable::step(level_);
    for (std::size_t j = 0;; ++j) {
      const Node& node = table_.at(level_, j);
      if (node.u > std::max(end, last_) || !add(node)) break;
    }
    store();
  }

  int level() const { return level_; }
  std::size_t nodes() const { return nodes_; }
  bool finite() const { return finite_; }
  double value(std::size_t f) const { return now_[f]; }
  double change(std::size_t f) const { return std::abs(now_[f] - before_[f]); }
  double change_before(std::size_t f) const { return std::abs(before_[f] - earlier_[f]); }
  double rounding(std::size_t f) const { return epsilon * rounding_[f] * step(); }
  double step() const { return NodeTable::step(level_); }

 private:
  bool add(const Node& node) {
    const NodeSum sum = integrand_.at(node);
    ++nodes_;
    if (!sum.finite()) {
      finite_ = false;
      return false;
    }
    for (std::size_t f = 0; f < 4; ++f) {
      sum_[f] += sum.value[f];
      rounding_[f] += sum.rounding[f];
    }
    if (sum.size > negligible) last_ = std::max(last_, node.u);
    return true;
  }

  void store() {
    earlier_ = before_;
    before_ = now_;
    for (std::size_t f = 0; f < 4; ++f) now_[f] = sum_[f] * step();
  }

  Integrand& integrand_;
  NodeTable& table_;
  int level_ = 0;
  std::size_t nodes_ = 0;
  double last_ = 0.0;
  bool finite_ = true;
  FourSums sum_{};
  FourSums rounding_{};
  FourSums now_{};
  FourSums before_{};
  FourSums earlier_{};
};

bool settled(const Trapezoid& rule, const FourSums& full) {
  if (rule.level() < first_accepted_level) return false;
  for (std::size_t f = 0; f < 4; ++f) {
    if (!(rule.change(f) <= rule.rounding(f))) return false;
    if (!(rule.change_before(f) <= converging * full[f])) return false;
  }
  return true;
}

/// Residues at poles of the load that the contour leaves outside.
void add_outer_poles(Integrand& integrand, const NodeTable& table, double uncertainty,
                     Inverted& result) {
  for (std::size_t i = 0; i < integrand.arrivals().size(); ++i) {
    for (const ImaginaryPole& pole : integrand.poles(i)) {
      if (table.contour().clearance({0.0, pole.frequency}) > 0.0) continue;
      const NodeSum part = integrand.residue(i, pole, table.state_at(Complex(0.0, pole.frequency)));
      for (std::size_t f = 0; f < 4; ++f) {
        result.value[f] += part.value[f];
        result.error[f] +=
            epsilon * part.rounding[f] + uncertainty * pole.frequency * std::abs(part.value[f]);
      }
    }
  }
}

}  // namespace

Inverted invert(Integrand& integrand, NodeTable& table, double uncertainty) {
  Inverted result;
  result.error.fill(infinity);
  result.worst = infinity;
  Trapezoid rule(integrand, table);
  const FourSums& full = integrand.full_wave();
  while (rule.finite() && !settled(rule, full) && rule.level() < last_level &&
         rule.nodes() < most_nodes) {
    rule.refine();
  }
  if (!rule.finite()) return result;
  const FourSums rates = integrand.rates();
  result.worst = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    result.value[f] = rule.value(f);
    result.error[f] = rule.rounding(f) + rule.change(f) + rates[f] * rule.step() * uncertainty +
                      32.0 * negligible * full[f];
  }
  add_outer_poles(integrand, table, uncertainty, result);
  for (std::size_t f = 0; f < 4; ++f) {
    result.worst = std::max(result.worst, result.error[f] / full[f]);
  }
  return result;
}

}  // namespace porowave::reference
