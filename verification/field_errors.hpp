#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "reference/profile.hpp"
#include "solver/column_solver.hpp"
#include "verification/norms.hpp"

namespace porowave::verification {

inline constexpr std::array<std::string_view, 4> field_names = {"effective_stress", "pore_pressure",
                                                                "solid_velocity", "fluid_velocity"};

/// Errors of one field: at the material points of its phase, weighted by their volume, and of the
/// field reconstructed by the transfer (stresses at cell middles, velocities at nodes).
struct FieldError {
  Norms points;
  Norms field;
};

/// In the order of field_names.
using FieldErrors = std::array<FieldError, 4>;

/// The four fields at the places of a snapshot, in the order of field_names; SI units.
struct ReferenceValues {
  std::array<std::vector<double>, 4> points;  ///< at the points of the field's phase
  std::array<std::vector<double>, 4> field;   ///< stresses at cell middles, velocities at nodes
};

/// The reference profile at the places of a snapshot of the same time.
/// Throws std::invalid_argument if the times differ.
ReferenceValues reference_values(const solver::Snapshot& snapshot,
                                 const reference::Profile& profile);

/// Norms of one field (index in field_names) against the reference, from values and weights
/// (volumes) at places x. Throws std::invalid_argument as relative_norms does.
Norms compare_at(const reference::Profile& profile, std::size_t field, const std::vector<double>& x,
                 const std::vector<double>& values, const std::vector<double>& weights);

/// Compares a snapshot with the reference at its points, cell middles and nodes.
FieldErrors field_errors(const solver::Snapshot& snapshot, const ReferenceValues& reference);

}  // namespace porowave::verification
