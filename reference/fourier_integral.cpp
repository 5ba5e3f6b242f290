#include "reference/fourier_integral.hpp"

#include <gsl/gsl_errno.h>

#include <cmath>
#include <limits>
#include <new>

namespace porowave::reference {

namespace {

constexpr std::size_t most_intervals = 1000;
constexpr std::size_t bisections = 40;
/// A tolerance below the rounding of the integrand is refused by GSL; then it is loosened.
constexpr int attempts = 4;
constexpr double loosening = 10.0;

double call(double y, void* function) {
  return (*static_cast<const FourierIntegral::Function*>(function))(y);
}

gsl_function wrap(const FourierIntegral::Function& f) {
  // GSL hands the pointer back to `call` and never writes through it.
  return {call, const_cast<FourierIntegral::Function*>(&f)};  // NOLINT
}

template <class Rule>
Integral with_looser_tolerances(Rule&& rule, double tolerance) {
  for (int attempt = 0; attempt < attempts; ++attempt, tolerance *= loosening) {
    Integral result{};
    if (rule(tolerance, result) == GSL_SUCCESS && std::isfinite(result.value)) return result;
  }
  return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
}

}  // namespace

FourierIntegral::FourierIntegral() {
  static const auto previous_handler = gsl_set_error_handler_off();
  static_cast<void>(previous_handler);
  workspace_.reset(gsl_integration_workspace_alloc(most_intervals));
  cycles_.reset(gsl_integration_workspace_alloc(most_intervals));
  cosine_.reset(gsl_integration_qawo_table_alloc(1.0, 1.0, GSL_INTEG_COSINE, bisections));
  sine_.reset(gsl_integration_qawo_table_alloc(1.0, 1.0, GSL_INTEG_SINE, bisections));
  if (!workspace_ || !cycles_ || !cosine_ || !sine_) throw std::bad_alloc();
}

Integral FourierIntegral::to_infinity(const Function& f, double a, Weight weight,
                                      double tolerance) {
  gsl_function function = wrap(f);
  const Table& table = weight == Weight::cosine ? cosine_ : sine_;
  return with_looser_tolerances(
      [&](double goal, Integral& result) {
        return gsl_integration_qawf(&function, a, goal, most_intervals, workspace_.get(),
                                    cycles_.get(), table.get(), &result.value, &result.error);
      },
      tolerance);
}

Integral FourierIntegral::between(const Function& f, double a, double b, double tolerance) {
  gsl_function function = wrap(f);
  return with_looser_tolerances(
      [&](double goal, Integral& result) {
        return gsl_integration_qag(&function, a, b, goal, 0.0, most_intervals, GSL_INTEG_GAUSS61,
                                   workspace_.get(), &result.value, &result.error);
      },
      tolerance);
}

}  // namespace porowave::reference
