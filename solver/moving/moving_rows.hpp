#pragma once

// Moving least squares rows (weights.hpp) at places in front of moving points, one dimension. The
// points are sorted, so the row of a place touches neighbouring points.
//
// A row is renewed when its place is new or has moved, or when a point in its reach has moved;
// all others are kept. What is kept is to the last bit what renewal would give.

#include <cstddef>
#include <span>
#include <vector>

#include "solver/moving/cell_order.hpp"
#include "solver/weights.hpp"

namespace porowave::solver {

// How many of the first points have moved: what rows ask for any range of points.
class MovedPoints {
 public:
  explicit MovedPoints(const std::vector<bool>& moved);
  bool any(IndexRange points) const { return before_[points.last] > before_[points.first]; }
  std::size_t count() const { return before_.back(); }

 private:
  std::vector<std::size_t> before_;
};

class MovingRows {
 public:
  // Radius of the support in m, > 0; 0 <= basis order <= 3 (std::invalid_argument from renew).
  MovingRows(KernelName kernel, double radius, int basis_order)
      : kernel_(kernel), radius_(radius), basis_order_(basis_order) {}

  // Rows for `places` (m, ascending), which have the numbers first, first + 1, ... (of nodes or
  // cells); a number keeps its row from one renewal to the next. Points sorted; `moved` since the
  // last renewal, or reordered. Throws as mls_rows does.
  void renew(long first, std::span<const double> places, std::span<const Vector<1>> points,
             const MovedPoints& moved);

  // Σ_p Φ_p(place) value_p of all places, in their order.
  void multiply(std::span<const double> point_values, std::span<double> at_places) const;

  std::size_t renewed() const { return renewed_; }  // rows made by the last renewal
  std::size_t reduced() const;                      // rows that had to lower the basis order
  std::size_t empty() const;                        // rows that no point reaches

 private:
  struct Row {
    double place = 0.0;
    IndexRange reach{};  // points that the support may touch
    std::size_t first_column = 0;
    std::vector<double> values;
    int order_used = -1;
  };

  IndexRange reach_of(double place, std::span<const Vector<1>> points) const;
  bool is_still_good(const Row& row, const Row& wanted, const MovedPoints& moved) const;
  void make(std::span<Row> rows, std::span<const Vector<1>> points) const;

  KernelName kernel_;
  double radius_;
  int basis_order_;
  long first_ = 0;
  std::vector<Row> rows_;
  std::size_t renewed_ = 0;
};

}  // namespace porowave::solver
