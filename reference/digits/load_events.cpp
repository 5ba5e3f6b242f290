#include "reference/digits/load_events.hpp"

#include <boost/math/constants/constants.hpp>

namespace porowave::fixtures::digits {

namespace {

template <class R>
LoadEvent<R> powers(const R& time, std::array<R, 7> factors) {
  LoadEvent<R> event;
  event.time = time;
  event.power = std::move(factors);
  return event;
}

/// z^3 (10 - 15 z + 6 z^2); by symmetry, 1 less that, of -z, is what goes on after z = 1.
template <class R>
std::vector<LoadEvent<R>> ramp(const R& T) {
  const R a = 60 / (T * T * T);
  const R b = 360 / (T * T * T * T);
  const R c = 720 / (T * T * T * T * T);
  return {powers<R>(R(0), {0, 0, 0, 0, a, -b, c}), powers<R>(T, {0, 0, 0, 0, -a, -b, -c})};
}

/// sin^4 = 3/8 - cos(2 w t)/2 + cos(4 w t)/8, and the same a period later takes it away again.
template <class R>
std::vector<LoadEvent<R>> pulse(const R& T) {
  LoadEvent<R> on;
  on.kind = LoadEvent<R>::Kind::sine;
  on.duration = T;
  on.frequency = boost::math::constants::pi<R>() / T;
  LoadEvent<R> off = on;
  off.time = T;
  off.sign = -1;
  LoadEvent<R> whole = off;
  whole.kind = LoadEvent<R>::Kind::whole_pulse;
  return {on, off, whole};
}

template <class R>
std::vector<LoadEvent<R>> table(const Load& load) {
  std::vector<LoadEvent<R>> events;
  const auto& times = load.times();
  const auto& values = load.values();
  R value = 0;
  R slope = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const R jump = values[i] - value;
    const bool last = i + 1 == times.size();
    const bool jumps_next = !last && times[i + 1] == times[i];
    const R next = last || jumps_next
                       ? R(0)
                       : R((R(values[i + 1]) - values[i]) / (R(times[i + 1]) - times[i]));
    events.push_back(powers<R>(R(times[i]), {0, jump, next - slope, 0, 0, 0, 0}));
    slope = next;
    value = last || jumps_next ? values[i] : values[i + 1];
  }
  return events;
}

}  // namespace

template <class R>
std::vector<LoadEvent<R>> load_events(const Load& load) {
  const R T = load.duration();
  const std::array<R, 7> step = {0, 1, 0, 0, 0, 0, 0};
  switch (load.shape()) {
    case LoadShape::smooth_ramp:
      return ramp<R>(T);
    case LoadShape::sin4_pulse:
      return pulse<R>(T);
    case LoadShape::block:
      return {powers<R>(R(0), step), powers<R>(T, {0, -1, 0, 0, 0, 0, 0})};
    case LoadShape::table:
      return table<R>(load);
    case LoadShape::step:
    case LoadShape::ricker:  // has no events
      break;
  }
  return {powers<R>(R(0), step)};
}

template <class R>
ComplexOf<R> ricker_transform(const Load& load, const ComplexOf<R>& s) {
  using C = ComplexOf<R>;
  using std::exp;
  using std::sqrt;
  const R width = R(load.duration()) / 13;
  const C a = s * width;
  // q = -(1/2) (d/dv)^2 e^(-v^2), v = (t - T/2)/width.
  const R root_pi = sqrt(boost::math::constants::pi<R>());
  return C(-width / 2 * root_pi * a * a * exp(C(a * a / R(4))));
}

template std::vector<LoadEvent<double>> load_events<double>(const Load&);
template std::vector<LoadEvent<Real50>> load_events<Real50>(const Load&);
template std::vector<LoadEvent<Real100>> load_events<Real100>(const Load&);
template ComplexOf<Real50> ricker_transform<Real50>(const Load&, const ComplexOf<Real50>&);

}  // namespace porowave::fixtures::digits
