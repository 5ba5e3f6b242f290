#pragma once

// The domains of the points of cpGIMP follow the solid: l ← l (1 + ∂Δu_s/∂x), with the increment of
// the solid's displacement since the last time, for solid and fluid points alike. (The volumes and
// the porosity stay as they are, strains being small; so a domain and its volume differ by the
// strain.) Source: Bardenhagen & Kober (2004).

#include <span>

#include "solver/transfer.hpp"

namespace porowave::solver {

// A domain that would turn inside out keeps a tenth of its length: such a run is about to be
// stopped by its breakdown check.
void stretch_domains(const Transfer<1>& transfer, std::span<const double> nodal_displacement,
                     std::span<double> domain);

}  // namespace porowave::solver
