#include "verification/wave_measures/cosine_spectrum.hpp"

#include <fftw3.h>

#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <utility>

#include "reference/fftw_planning.hpp"

namespace porowave::verification {

namespace {

struct Destroy {
  void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using Plan = std::unique_ptr<fftw_plan_s, Destroy>;

/// A plan for any array of that size, in place. Executing one is safe in any number of threads.
fftw_plan plan_for(std::size_t size, Places places) {
  static std::map<std::pair<std::size_t, Places>, Plan> plans;
  const std::scoped_lock lock(reference::fftw_planning());
  Plan& plan = plans[{size, places}];
  if (!plan) {
    std::vector<double> scratch(size);
    plan.reset(fftw_plan_r2r_1d(static_cast<int>(size), scratch.data(), scratch.data(),
                                places == Places::nodes ? FFTW_REDFT00 : FFTW_REDFT10,
                                FFTW_ESTIMATE | FFTW_UNALIGNED));
    if (!plan) throw std::bad_alloc();
  }
  return plan.get();
}

}  // namespace

std::vector<double> cosine_spectrum(std::span<const double> values, Places places) {
  if (values.size() < (places == Places::nodes ? 2U : 1U)) {
    throw std::invalid_argument("cosine spectrum: values of one cell at least");
  }
  std::vector<double> energy(values.begin(), values.end());
  fftw_execute_r2r(plan_for(values.size(), places), energy.data(), energy.data());
  const auto cells =
      static_cast<double>(places == Places::nodes ? values.size() - 1 : values.size());
  // FFTW leaves the factors out: 2 sum w_j f_j cos, w_j = 1/2 at end nodes.
  for (double& c : energy) c *= c / (2.0 * cells);
  energy.front() *= 0.5;
  if (places == Places::nodes) energy.back() *= 0.5;
  return energy;
}

}  // namespace porowave::verification
