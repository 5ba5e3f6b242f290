#pragma once

// The domains of the points of cpGIMP follow the solid: l ← l (1 + ∂Δu_s/∂x), with the increment of
// the solid's displacement since the last time, for solid and fluid points alike. (The volumes and
// the porosity stay as they are, strains being small; so a domain and its volume differ by the
// strain.) Source: Bardenhagen & Kober (2004).

#include <span>

namespace porowave::solver {

// `strain` is that increment of ∂u_s/∂x at the points, `domain` their l. A domain that would turn
// inside out keeps a tenth of its length: such a run is about to be stopped by its breakdown check.
void stretch_domains(std::span<const double> strain, std::span<double> domain);

}  // namespace porowave::solver
