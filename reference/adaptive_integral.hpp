#pragma once

#include <functional>
#include <span>

#include "reference/quantities.hpp"

namespace porowave::reference {

/// Integral from the first to the last of `ends` (ascending) of a function that is smooth between
/// them, except that it may begin each piece like the square root of the distance or its inverse.
///
/// Gauss-Kronrod rules of 31 points in that square root; the panel with the largest error is
/// halved until their sum is below 1e-13 of the integral of |f|, or below what the errors of the
/// values make it. The error adds both; it is infinite if a value was not finite. After 4000 panels
/// the integral is given with the error it has.
/// Source: Piessens et al., QUADPACK (1983), the strategy of QAG.
Bounded adaptive_integral(const std::function<Bounded(double)>& f, std::span<const double> ends);

}  // namespace porowave::reference
