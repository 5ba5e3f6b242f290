#pragma once

#include <span>
#include <string>
#include <vector>

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

/// The effective stress in the cells of a run at one time, and what is wrong in it.
struct SpectrumPanel {
  std::string title;
  std::vector<double> reference;  ///< over the load, as is `error`
  std::vector<double> error;
  std::string detail = {};  ///< in smaller letters below the title
};

/// Where in the spectrum an error stands: amplitude of effective stress and of its error over the
/// number of cells in a wavelength, one panel a run.
Figure error_spectrum_figure(const std::string& name, const std::string& caption,
                             std::span<const SpectrumPanel> panels);

/// Half of the squared error stands in waves of so many cells or more: their length, in cells;
/// infinite if half of it is the mean, which is no wave. NaN without an error.
double median_wavelength(const SpectrumPanel& panel);

/// The same of runs that are made here, at their end.
Figure error_spectrum_figure(const std::string& name, const std::string& caption,
                             std::span<const verification::Method> methods);

}  // namespace porowave::reports
