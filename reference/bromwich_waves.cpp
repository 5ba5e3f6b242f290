#include "reference/bromwich_waves.hpp"

#include <cmath>

namespace porowave::reference::line {

namespace {

template <class S>
using Pair = std::array<S, 2>;
template <class S>
using Square = std::array<Pair<S>, 2>;

/// Two linear conditions on the four fields at an end, and their right sides for a unit load.
struct Conditions {
  std::array<std::array<double, 4>, 2> row;
  Pair<double> load;
};

Conditions conditions(NearEnd end) {
  switch (end) {
    case NearEnd::drained_traction:
      return {{{{1, 0, 0, 0}, {0, 1, 0, 0}}}, {-1, 0}};
    case NearEnd::sealed_traction:
      return {{{{1, -1, 0, 0}, {0, 0, 1, -1}}}, {-1, 0}};
    case NearEnd::fluid_pressure:
      return {{{{1, 0, 0, 0}, {0, 1, 0, 0}}}, {0, 1}};
    case NearEnd::velocity:
      break;
  }
  return {{{{0, 0, 1, 0}, {0, 0, 0, 1}}}, {1, 1}};
}

Conditions conditions(FarEnd end) {
  switch (end) {
    case FarEnd::rigid_drained:
      return {{{{0, 0, 1, 0}, {0, 1, 0, 0}}}, {0, 0}};
    case FarEnd::free_drained:
      return {{{{1, 0, 0, 0}, {0, 1, 0, 0}}}, {0, 0}};
    case FarEnd::rigid_sealed:
    case FarEnd::half_space:
      break;
  }
  return {{{{0, 0, 1, 0}, {0, 0, 0, 1}}}, {0, 0}};
}

/// Neither end that fixes both stresses nor one that fixes both velocities mixes the modes.
bool mixes(const Column& column) {
  return column.near == NearEnd::sealed_traction || column.far == FarEnd::rigid_drained;
}

template <class S>
FourOf<S> down(FourOf<S> up) {
  up[0] = -up[0];
  up[1] = -up[1];
  return up;
}

/// conditions * (fields of both modes)
template <class S>
Square<S> apply(const Conditions& at, const std::array<FourOf<S>, 2>& mode) {
  Square<S> result{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      result[i][k] = S(0.0);
      for (std::size_t f = 0; f < 4; ++f) {
        if (at.row[i][f] != 0.0) result[i][k] = result[i][k] + S(at.row[i][f]) * mode[k][f];
      }
    }
  }
  return result;
}

/// Cramer's rule.
template <class S>
Pair<S> solve(const Square<S>& m, const Pair<S>& b) {
  const S determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return {(b[0] * m[1][1] - m[0][1] * b[1]) / determinant,
          (m[0][0] * b[1] - b[0] * m[1][0]) / determinant};
}

/// What leaves an end when mode k arrives with amplitude 1: leaving * result = -arriving.
template <class S>
Square<S> reflection(const Conditions& at, const std::array<FourOf<S>, 2>& leaving,
                     const std::array<FourOf<S>, 2>& arriving) {
  const Square<S> out = apply(at, leaving);
  const Square<S> in = apply(at, arriving);
  Square<S> result;
  for (std::size_t k = 0; k < 2; ++k) {
    const Pair<S> column = solve(out, Pair<S>{-in[0][k], -in[1][k]});
    result[0][k] = column[0];
    result[1][k] = column[1];
  }
  return result;
}

/// Square root of 1 - 2 u Re(m) + u^2 |m|^2 that is 1 at u = 0. For a complex u it is analytic
/// outside of the two lines from s = 0 to the meeting points m and conj(m).
Complex meeting_root(const Medium& medium, const Complex& u) {
  return std::sqrt(1.0 - u * medium.meeting) * std::sqrt(1.0 - u * std::conj(medium.meeting));
}
Series meeting_root(const Medium& medium, const Series& u) {
  return sqrt(Series(1.0) + u * Series(-2.0 * medium.meeting.real()) +
              u * u * Series(std::norm(medium.meeting)));
}

}  // namespace

Medium::Medium(const Material& m) : material(m) {
  const double ns = m.solid_fraction();
  const double nf = m.porosity;
  const double K = m.storage_modulus();
  const double E = m.constrained_modulus;
  const double a11 = E + K * ns * ns;
  const double a22 = K * nf * nf;
  const double determinant = E * a22;  // of A
  const double ms = m.solid_partial_density();
  const double mf = m.fluid_partial_density();

  // det(D - A/c^2) = 0 for 1/c^2; the smaller root from the product, so that nothing cancels.
  const double a12 = K * ns * nf;
  const double half = 0.5 * (a11 * mf + a22 * ms) / determinant;
  const double split =
      0.5 * std::hypot(a11 * mf - a22 * ms, 2.0 * a12 * std::sqrt(ms * mf)) / determinant;
  const double slow = half + split;
  const double quick = ms * mf / determinant / slow;
  speed = {1.0 / std::sqrt(quick), 1.0 / std::sqrt(slow)};
  gap = 2.0 * split;

  trace = m.drag() * (E + K) / determinant;
  const double product = m.drag() * (ms + mf) / determinant;
  fast = product - trace * quick;
  const double real = (2.0 * fast - gap * trace) / (gap * gap);
  const double size = trace / gap;
  meeting = {real, std::sqrt(std::max(0.0, (size - real) * (size + real)))};
  for (std::size_t k = 0; k < 2; ++k) {
    const double squared = k == 0 ? quick : slow;
    solid_leads[k] = std::abs(mf - squared * a22) > std::abs(ms - squared * a11);
  }
}

template <class S>
Waves<S> waves_at(const Medium& medium, const S& u) {
  using std::sqrt;
  const Material& m = medium.material;
  const double ns = m.solid_fraction();
  const double nf = m.porosity;
  const double K = m.storage_modulus();
  const double E = m.constrained_modulus;

  const S root = S(medium.gap) * meeting_root(medium, u);
  std::array<S, 2> nu;
  nu[0] = S(2.0 * medium.fast) / (S(medium.gap) + S(medium.trace) * u + root);
  nu[1] = S(medium.trace) - nu[0];
  Waves<S> waves;
  for (std::size_t k = 0; k < 2; ++k) {
    const double frozen = 1.0 / medium.speed[k];
    const S squared = S(frozen * frozen) + u * nu[k];
    const S slowness = sqrt(squared);
    waves.excess[k] = nu[k] / (slowness + S(frozen));
    // A null vector of D + u d J - A/c^2, from its first or second row.
    const S drag = S(m.drag()) * u;
    const S off = -drag - squared * S(K * ns * nf);
    S solid;
    S fluid;
    if (medium.solid_leads[k]) {
      solid = S(m.fluid_partial_density()) + drag - squared * S(K * nf * nf);
      fluid = -off;
    } else {
      solid = -off;
      fluid = S(m.solid_partial_density()) + drag - squared * S(E + K * ns * ns);
    }
    waves.up[k] = {-slowness * S(E) * solid, slowness * S(K) * (S(ns) * solid + S(nf) * fluid),
                   solid, fluid};
  }
  return waves;
}

std::vector<Image> images_until(const Column& column, const Medium& medium, double x, double t) {
  std::vector<Image> images;
  const double length = column.length.value_or(0.0);
  for (int crossings = 0; crossings == 0 || column.length; ++crossings) {
    if (crossings * length > t * medium.speed[0] || images.size() > most_images) break;
    const double leg = crossings % 2 == 0 ? x : length - x;
    for (int slow = 0; slow <= crossings; ++slow) {
      for (int mode = 0; mode < 2; ++mode) {
        if (!mixes(column) && slow != mode * crossings) continue;
        Image image{crossings, slow, mode, {(crossings - slow) * length, slow * length}, 0.0};
        image.path[static_cast<std::size_t>(mode)] += leg;
        image.arrival = image.path[0] / medium.speed[0] + image.path[1] / medium.speed[1];
        if (image.arrival <= t) images.push_back(image);
      }
    }
  }
  return images;
}

template <class S>
FourOf<S> image_fields(const Column& column, const Medium& medium, const Image& image, const S& u) {
  using std::exp;
  const Waves<S> waves = waves_at(medium, u);
  const std::array<FourOf<S>, 2> back = {down(waves.up[0]), down(waves.up[1])};
  const Conditions near = conditions(column.near);
  const Conditions far = conditions(column.far);
  const Square<S> source = apply(near, waves.up);
  const Square<S> at_far = reflection(far, back, waves.up);
  const Square<S> at_near = reflection(near, waves.up, back);

  // Amplitudes after each crossing, sorted by how many of them were slow.
  std::vector<Pair<S>> amplitude = {solve(source, Pair<S>{S(near.load[0]), S(near.load[1])})};
  for (int crossing = 0; crossing < image.crossings; ++crossing) {
    const Square<S>& end = crossing % 2 == 0 ? at_far : at_near;
    std::vector<Pair<S>> next(amplitude.size() + 1, Pair<S>{S(0.0), S(0.0)});
    for (std::size_t slow = 0; slow < amplitude.size(); ++slow) {
      for (std::size_t mode = 0; mode < 2; ++mode) {
        for (std::size_t k = 0; k < 2; ++k) {
          next[slow + mode][k] = next[slow + mode][k] + end[k][mode] * amplitude[slow][mode];
        }
      }
    }
    amplitude.swap(next);
  }
  const auto mode = static_cast<std::size_t>(image.mode);
  const S decay = exp(-(waves.excess[0] * S(image.path[0]) + waves.excess[1] * S(image.path[1])));
  const S size = amplitude[static_cast<std::size_t>(image.slow)][mode] * decay;
  FourOf<S> fields = image.crossings % 2 == 0 ? waves.up[mode] : back[mode];
  for (S& field : fields) field = field * size;
  return fields;
}

template FourOf<Complex> image_fields(const Column&, const Medium&, const Image&, const Complex&);
template FourOf<Series> image_fields(const Column&, const Medium&, const Image&, const Series&);

}  // namespace porowave::reference::line
