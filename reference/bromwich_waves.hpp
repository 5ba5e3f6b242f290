#pragma once

#include <array>
#include <complex>
#include <vector>

#include "reference/bromwich_series.hpp"
#include "reference/problem/problem.hpp"

/// Waves and images of the Bromwich route. Everything is a function of u = 1/s, either a complex
/// number or a Series; nothing is shared with the main route (modes, boundary, rays).
namespace porowave::reference::line {

using Complex = std::complex<double>;
template <class S>
using FourOf = std::array<S, 4>;  ///< effective stress, pore pressure, solid and fluid velocity

/// The numbers of a material from which both modes follow. The squared slownesses of
/// A V'' = s^2 (D + u d J) V are 1/c_k^2 + u nu_k; their sum and product are linear in u.
struct Medium {
  explicit Medium(const Material& material);

  Material material;
  std::array<double, 2> speed;      ///< c_k, frozen, m/s; speed[0] > speed[1]
  double gap;                       ///< 1/c_2^2 - 1/c_1^2
  double trace;                     ///< nu_1 + nu_2
  double fast;                      ///< nu_1 nu_2 at small u, times the gap
  Complex meeting;                  ///< the s in the upper half plane where both modes meet, 1/s
  std::array<bool, 2> solid_leads;  ///< which of two formulas gives the velocities of a mode
};

/// The two modes: a wave up, e^(-lambda x), has these fields; one down has minus the stresses.
template <class S>
struct Waves {
  std::array<S, 2> excess;  ///< lambda_k - s/c_k, 1/m
  std::array<FourOf<S>, 2> up;
};
template <class S>
Waves<S> waves_at(const Medium& medium, const S& u);

/// A wave that has crossed the column `crossings` times, `slow` of them as the slow one, and runs
/// its last leg as `mode`; its front needs `arrival`.
struct Image {
  int crossings;
  int slow;
  int mode;
  std::array<double, 2> path;  ///< m run as the fast and as the slow wave
  double arrival;              ///< s
};
/// More images than this are not inverted one by one.
inline constexpr std::size_t most_images = 600;

/// All images whose fronts reach x by time t; longer than most_images if there are more.
std::vector<Image> images_until(const Column& column, const Medium& medium, double x, double t);

/// The four fields of an image for a unit load, without the factor e^(-s arrival).
template <class S>
FourOf<S> image_fields(const Column& column, const Medium& medium, const Image& image, const S& u);

extern template FourOf<Complex> image_fields(const Column&, const Medium&, const Image&,
                                             const Complex&);
extern template FourOf<Series> image_fields(const Column&, const Medium&, const Image&,
                                            const Series&);

}  // namespace porowave::reference::line
