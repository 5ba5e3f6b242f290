#include "reference/sine_transform.hpp"

#include <fftw3.h>

#include <algorithm>
#include <memory>
#include <new>

#include "reference/fftw_planning.hpp"

namespace porowave::reference {

namespace {

struct Free {
  void operator()(double* values) const { fftw_free(values); }
};

struct Destroy {
  void operator()(fftw_plan plan) const {
    const std::scoped_lock lock(fftw_planning());
    fftw_destroy_plan(plan);
  }
};

/// FFTW's transform of the amplitudes folded into the first `intervals` ones; mirrored are those
/// of the upper half of a period, with a sign for sines.
std::vector<double> transform(std::span<const double> amplitudes, std::size_t intervals,
                              fftw_r2r_kind kind, double mirror) {
  const std::unique_ptr<double, Free> values(fftw_alloc_real(intervals));
  if (!values) throw std::bad_alloc();
  double* const v = values.get();
  std::unique_ptr<fftw_plan_s, Destroy> plan;
  {
    const std::scoped_lock lock(fftw_planning());
    plan.reset(fftw_plan_r2r_1d(static_cast<int>(intervals), v, v, kind, FFTW_ESTIMATE));
  }
  if (!plan) throw std::bad_alloc();
  std::fill_n(v, intervals, 0.0);
  for (std::size_t n = 0; n < amplitudes.size(); ++n) {
    const std::size_t place = n % (2 * intervals);
    if (place < intervals) {
      v[place] += 0.5 * amplitudes[n];
    } else {
      v[2 * intervals - 1 - place] += 0.5 * mirror * amplitudes[n];
    }
  }
  fftw_execute(plan.get());
  return {v, v + intervals};
}

}  // namespace

std::mutex& fftw_planning() {
  static std::mutex planning;
  return planning;
}

std::vector<double> quarter_wave_sines(std::span<const double> amplitudes, std::size_t intervals) {
  auto sums = transform(amplitudes, intervals, FFTW_RODFT10, -1.0);
  sums.insert(sums.begin(), 0.0);
  return sums;
}

std::vector<double> quarter_wave_cosines(std::span<const double> amplitudes,
                                         std::size_t intervals) {
  auto sums = transform(amplitudes, intervals, FFTW_REDFT10, 1.0);
  sums.push_back(0.0);
  return sums;
}

}  // namespace porowave::reference
