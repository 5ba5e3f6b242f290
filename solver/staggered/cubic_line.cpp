#include "solver/staggered/cubic_line.hpp"

#include <algorithm>
#include <stdexcept>

namespace porowave::solver {

namespace {

constexpr std::size_t fewest_cells = 4;
constexpr std::size_t ghosts = 3;

void check(std::size_t cells, double spacing) {
  if (cells < fewest_cells) throw std::invalid_argument("cubic line: fewer than 4 cells");
  if (!(spacing > 0.0)) throw std::invalid_argument("cubic line: spacing must be positive");
}

bool mirrored(EndRule rule) {
  return rule == EndRule::odd || rule == EndRule::even;
}

double sign_of(EndRule rule) {
  return rule == EndRule::odd ? -1.0 : 1.0;
}

}  // namespace

CubicLine CubicLine::nodes(std::size_t cells, double spacing, EndRule near, EndRule far) {
  check(cells, spacing);
  CubicLine line;
  for (std::size_t i = 0; i <= cells; ++i) {
    line.places_.push_back({spacing * static_cast<double>(i), i, 1.0});
  }
  line.add_ghosts(near, far, spacing * static_cast<double>(cells));
  return line;
}

CubicLine CubicLine::middles(std::size_t cells, double spacing, EndRule near, EndRule far) {
  check(cells, spacing);
  const double length = spacing * static_cast<double>(cells);
  CubicLine line;
  if (near == EndRule::held) line.places_.push_back({0.0, 0, 1.0});
  for (std::size_t c = 0; c < cells; ++c) {
    line.places_.push_back({spacing * (static_cast<double>(c) + 0.5), c + 1, 1.0});
  }
  if (far == EndRule::held) line.places_.push_back({length, cells + 1, 1.0});
  line.add_ghosts(near, far, length);
  return line;
}

void CubicLine::add_ghosts(EndRule near, EndRule far, double length) {
  std::vector<Place> before;
  std::vector<Place> after;
  for (std::size_t k = 0; k <= ghosts; ++k) {
    const Place& left = places_[k];
    const Place& right = places_[places_.size() - 1 - k];
    if (mirrored(near) && left.x > 0.0) {
      before.insert(before.begin(), {-left.x, left.index, sign_of(near)});
    }
    if (mirrored(far) && right.x < length) {
      after.push_back({2.0 * length - right.x, right.index, sign_of(far)});
    }
  }
  places_.insert(places_.begin(), before.begin(), before.end());
  places_.insert(places_.end(), after.begin(), after.end());
}

std::size_t CubicLine::first_of_stencil(double x) const {
  const auto above = std::upper_bound(places_.begin(), places_.end(), x,
                                      [](double a, const Place& b) { return a < b.x; });
  const auto two_below = std::max(std::ptrdiff_t{0}, above - places_.begin() - 2);
  return std::min(static_cast<std::size_t>(two_below), places_.size() - 4);
}

CubicRow CubicLine::value(double x) const {
  const Place* p = &places_[first_of_stencil(x)];
  CubicRow row;
  for (std::size_t j = 0; j < 4; ++j) {
    double weight = p[j].sign;
    for (std::size_t m = 0; m < 4; ++m) {
      if (m != j) weight *= (x - p[m].x) / (p[j].x - p[m].x);
    }
    row.index[j] = p[j].index;
    row.weight[j] = weight;
  }
  return row;
}

CubicRow CubicLine::slope(double x) const {
  const Place* p = &places_[first_of_stencil(x)];
  CubicRow row;
  for (std::size_t j = 0; j < 4; ++j) {
    // The product rule on Π (x − x_m): one factor left out at a time.
    double numerator = 0.0;
    double denominator = 1.0;
    for (std::size_t m = 0; m < 4; ++m) {
      if (m == j) continue;
      double product = 1.0;
      for (std::size_t k = 0; k < 4; ++k) {
        if (k != j && k != m) product *= x - p[k].x;
      }
      numerator += product;
      denominator *= p[j].x - p[m].x;
    }
    row.index[j] = p[j].index;
    row.weight[j] = p[j].sign * numerator / denominator;
  }
  return row;
}

}  // namespace porowave::solver
