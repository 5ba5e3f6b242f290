#pragma once

#include <vector>

#include "reference/digits/numbers.hpp"
#include "reference/problem/load.hpp"

namespace porowave::fixtures::digits {

/// One part of a load of unit magnitude. Its transform is e^(-s time) * at(s), where the part is
/// zero before `time`.
template <class R>
struct LoadEvent {
  using C = ComplexOf<R>;
  enum class Kind { powers, sine, whole_pulse } kind = Kind::powers;
  R time = 0;                  ///< s
  std::array<R, 7> power = {}; /**< factor of s^-n at [n] */
  R sign = 1;                  ///< of a sine
  R duration = 0;              ///< of a sine and a whole pulse
  R frequency = 0;             ///< pi/duration; the sine has poles at 0, +-2 and +-4 times i that

  C at(const C& s) const {
    using std::exp;
    const C z = R(1) / s;
    if (kind == Kind::powers) {
      C sum(R(0));
      for (std::size_t n = 6; n >= 1; --n) sum = (sum + power[n]) * z;
      return sum;
    }
    const R w2 = frequency * frequency;
    const C pulse = 24 * w2 * w2 * z / ((s * s + 4 * w2) * (s * s + 16 * w2));
    return kind == Kind::sine ? C(sign * pulse) : C(pulse * (exp(C(s * duration)) - R(1)));
  }
};

/// A load (not the ricker wavelet) as a sum of events in order of time. The two sines of a
/// sin4_pulse are followed by a third event, which may be used instead of both for waves that the
/// whole pulse has passed.
template <class R>
std::vector<LoadEvent<R>> load_events(const Load& load);

/// Transform of the ricker wavelet of unit magnitude, not truncated, at s, without its factor
/// e^(-s T/2), the middle of the wavelet.
template <class R>
ComplexOf<R> ricker_transform(const Load& load, const ComplexOf<R>& s);

}  // namespace porowave::fixtures::digits
