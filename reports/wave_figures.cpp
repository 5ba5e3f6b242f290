#include "reports/wave_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/problem/errors.hpp"
#include "verification/dispersion/dispersion.hpp"
#include "verification/not_a_number.hpp"
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

SpectrumPanel panel_of(const Method& method) {
  const auto profile = verification::reference_profile(method.scene);
  const auto run = verification::run_case(method.scene, *profile);
  if (run.breakdown) throw BreakdownError("error spectrum: " + run.breakdown->reason);
  const double load = method.scene.problem.stress_scale();
  SpectrumPanel panel{method.name, {}, {}};
  for (std::size_t c = 0; c < run.snapshot.cell_x.size(); ++c) {
    const double exact = profile->at(run.snapshot.cell_x[c]).effective_stress;
    panel.reference.push_back(exact / load);
    panel.error.push_back((run.snapshot.effective_stress[c] - exact) / load);
  }
  return panel;
}

/// Amplitudes of the waves k = 0, 1, ...: energy of the wave a cos(pi k x/L) is a² n/2.
std::vector<double> amplitudes(const std::vector<double>& values) {
  auto spectrum = verification::cosine_spectrum(values, Places::cell_middles);
  for (double& energy : spectrum) {
    energy = std::sqrt(2.0 * energy / static_cast<double>(values.size()));
  }
  return spectrum;
}

std::string spectrum_block(const SpectrumPanel& panel) {
  const auto exact = amplitudes(panel.reference);
  const auto wrong = amplitudes(panel.error);
  const auto cells = static_cast<double>(panel.error.size());
  std::string title = panel.title;
  std::replace(title.begin(), title.end(), '\n', ' ');
  std::string block = fmt::format(
      "# {}: cells in a wavelength, amplitude of effective stress and of its error\n", title);
  for (std::size_t k = 1; k < exact.size(); ++k) {
    block += fmt::format("{:.6g} {:.6e} {:.6e}\n", 2.0 * cells / static_cast<double>(k), exact[k],
                         wrong[k]);
  }
  return block;
}

}  // namespace

Figure dispersion_figure(const std::string& name, const std::string& caption,
                         std::span<const Method> methods) {
  Figure figure{name, "dispersion", {{"caption", caption}}, ""};
  figure.texts.emplace_back("count", std::to_string(methods.size()));
  for (std::size_t k = 0; k < methods.size(); ++k) {
    figure.texts.emplace_back(fmt::format("method{}", k + 1), methods[k].name);
    figure.data += (k == 0 ? "" : "\n\n") + dispersion_block(methods[k]);
  }
  return figure;
}

Figure error_spectrum_figure(const std::string& name, const std::string& caption,
                             std::span<const SpectrumPanel> panels) {
  Figure figure{name, "error_spectrum", {{"caption", caption}}, ""};
  figure.texts.emplace_back("count", std::to_string(panels.size()));
  double longest = 4.0;
  double highest = 1.0;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    figure.texts.emplace_back(fmt::format("method{}", k + 1), panels[k].title);
    figure.texts.emplace_back(fmt::format("detail{}", k + 1), panels[k].detail);
    figure.data += (k == 0 ? "" : "\n\n") + spectrum_block(panels[k]);
    longest = std::max(longest, 2.0 * static_cast<double>(panels[k].error.size()));
    for (const double value : panels[k].error) highest = std::max(highest, std::abs(value));
  }
  figure.texts.emplace_back("longest", fmt::format("{:#.6g}", longest));
  figure.texts.emplace_back("highest",
                            fmt::format("{:#.6g}", std::pow(10.0, std::ceil(std::log10(highest)))));
  return figure;
}

double median_wavelength(const SpectrumPanel& panel) {
  const auto spectrum = verification::cosine_spectrum(panel.error, Places::cell_middles);
  double all = 0.0;
  for (const double energy : spectrum) all += energy;
  if (!(all > 0.0)) return verification::nan;
  double longer = 0.0;
  std::size_t k = 0;
  while (2.0 * (longer += spectrum[k]) < all && k + 1 < spectrum.size()) ++k;
  return 2.0 * static_cast<double>(panel.error.size()) / static_cast<double>(k);
}

Figure error_spectrum_figure(const std::string& name, const std::string& caption,
                             std::span<const Method> methods) {
  std::vector<SpectrumPanel> panels;
  for (const Method& method : methods) panels.push_back(panel_of(method));
  return error_spectrum_figure(name, caption, std::span<const SpectrumPanel>(panels));
}

}  // namespace porowave::reports
