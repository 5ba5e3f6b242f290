#pragma once

#include <span>
#include <string>

#include "reports/gnuplot.hpp"
#include "verification/methods.hpp"

namespace porowave::reports {

/// How wrong a scheme's waves are against the exact ones, over the number of cells in a wavelength
/// (2.5 to 100): the speed of the fast and of the slow wave, and the share of the amplitude that
/// the scheme takes from or adds to each in the way of a wavelength. A wave that only diffuses has
/// no curve. Methods need uniform points without empty elements and time.order = 2; each is taken
/// at the courant of its case.
Figure dispersion_figure(const std::string& name, const std::string& caption,
                         std::span<const verification::Method> methods);

/// Where in the spectrum the error of a run stands: amplitude of effective stress and of its error
/// over the number of cells in a wavelength, one panel a method, at the end of the run.
Figure error_spectrum_figure(const std::string& name, const std::string& caption,
                             std::span<const verification::Method> methods);

}  // namespace porowave::reports
