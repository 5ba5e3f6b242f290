#include "solver/column_operators.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "solver/compact_operators.hpp"
#include "solver/general_operators.hpp"

namespace porowave::solver {

PreparedPhase prepare_phase(const PointSet<1>& points, const Grid<1>& grid,
                            const Discretization& choice, const TimeSettings& time) {
  const auto before = [](const Vector<1>& a, const Vector<1>& b) { return a[0] < b[0]; };
  if (!std::is_sorted(points.x.begin(), points.x.end(), before)) {
    throw std::invalid_argument("prepare phase: the points are not sorted along the column");
  }
  const bool compact = compact_form_available(choice, time);
  Transfer<1> transfer(points, grid, choice,
                       compact ? TransferUse::compact_form : TransferUse::all);
  PreparedPhase phase{nullptr, transfer.nodal_mass(), transfer.nodal_volume(),
                      transfer.reduced_rows(), transfer.empty_rows()};
  if (compact) {
    phase.operators = std::make_shared<CompactOperators>(std::move(transfer), points, grid);
  } else {
    phase.operators = std::make_shared<GeneralOperators>(std::move(transfer), points.x.size());
  }
  return phase;
}

}  // namespace porowave::solver
