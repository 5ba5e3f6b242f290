#include "reports/wave_figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "reference/problem/errors.hpp"
#include "verification/dispersion/dispersion.hpp"
#include "verification/run.hpp"
#include "verification/wave_measures/cosine_spectrum.hpp"

namespace porowave::reports {

namespace {

using std::numbers::pi;
using verification::Method;
using verification::Places;
using verification::TravellingWaves;

constexpr double fewest_cells = 2.5;
constexpr double most_cells = 100.0;
constexpr int samples = 161;

/// Relative error of the speed; amplitude after a wavelength's way over that of the exact wave,
/// less 1.
std::string wave_columns(const std::optional<std::complex<double>>& scheme,
                         const std::optional<std::complex<double>>& exact) {
  if (!scheme || !exact) return " NaN NaN";
  const double excess =
      2.0 * pi * (scheme->real() / scheme->imag() - exact->real() / exact->imag());
  return fmt::format(" {:.6e} {:.6e}", scheme->imag() / exact->imag() - 1.0, std::expm1(excess));
}

std::string dispersion_block(const Method& method) {
  const verification::SchemeDispersion scheme(method.scene, method.scene.time.courant);
  std::string block = fmt::format(
      "# {}: cells in a wavelength; relative error of speed and of amplitude a wavelength, of the "
      "fast wave and of the slow one\n",
      method.name);
  for (int k = 0; k < samples; ++k) {
    const double cells = fewest_cells * std::pow(most_cells / fewest_cells, k / (samples - 1.0));
    const double number = 2.0 * pi / (cells * scheme.spacing());
    const TravellingWaves ours = verification::travelling(scheme.rates(number));
    const TravellingWaves exact =
        verification::travelling(verification::exact_rates(method.scene.problem.material, number));
    block += fmt::format("{:.6g}", cells) + wave_columns(ours.fast, exact.fast) +
             wave_columns(ours.slow, exact.slow) + "\n";
  }
  return block;
}

std::string spectrum_block(const Method& method) {
  const auto profile = verification::reference_profile(method.scene);
  const auto run = verification::run_case(method.scene, *profile);
  if (run.breakdown) throw BreakdownError("error spectrum: " + run.breakdown->reason);
  std::vector<double> reference, error;
  for (std::size_t c = 0; c < run.snapshot.cell_x.size(); ++c) {
    reference.push_back(profile->at(run.snapshot.cell_x[c]).effective_stress);
    error.push_back(run.snapshot.effective_stress[c] - reference.back());
  }
  const auto exact = verification::cosine_spectrum(reference, Places::cell_middles);
  const auto wrong = verification::cosine_spectrum(error, Places::cell_middles);
  const double load = method.scene.problem.load.magnitude();
  const auto cells = static_cast<double>(error.size());
  std::string block = fmt::format(
      "# {}: cells in a wavelength, amplitude of effective stress and of its error\n", method.name);
  // Energy of the wave a cos(pi k x/L) is a² n/2.
  for (std::size_t k = 1; k < exact.size(); ++k) {
    block += fmt::format("{:.6g} {:.6e} {:.6e}\n", 2.0 * cells / static_cast<double>(k),
                         std::sqrt(2.0 * exact[k] / cells) / load,
                         std::sqrt(2.0 * wrong[k] / cells) / load);
  }
  return block;
}

template <class Block>
Figure figure_of(const std::string& name, const std::string& drawn_by, const std::string& caption,
                 std::span<const Method> methods, Block block) {
  Figure figure{name, drawn_by, {{"caption", caption}}, ""};
  figure.texts.emplace_back("count", std::to_string(methods.size()));
  for (std::size_t k = 0; k < methods.size(); ++k) {
    figure.texts.emplace_back(fmt::format("method{}", k + 1), methods[k].name);
    figure.data += (k == 0 ? "" : "\n\n") + block(methods[k]);
  }
  return figure;
}

}  // namespace

Figure dispersion_figure(const std::string& name, const std::string& caption,
                         std::span<const Method> methods) {
  return figure_of(name, "dispersion", caption, methods, dispersion_block);
}

Figure error_spectrum_figure(const std::string& name, const std::string& caption,
                             std::span<const Method> methods) {
  return figure_of(name, "error_spectrum", caption, methods, spectrum_block);
}

}  // namespace porowave::reports
