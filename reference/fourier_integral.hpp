#pragma once

#include <gsl/gsl_integration.h>

#include <functional>
#include <memory>

namespace porowave::reference {

/// An integral and GSL's estimate of its error; NaN and infinity if GSL gave up.
struct Integral {
  double value;
  double error;
};

/// Integrals with weight cos(y) or sin(y) to infinity, and plain ones, by GSL's adaptive rules
/// (gsl_integration_qawf, _qag; Piessens et al., QUADPACK, 1983). Owns the workspaces: not to be
/// used by two threads at once. The first object switches off GSL's error handler, which would end
/// the program, for the whole process; return codes are looked at instead.
class FourierIntegral {
 public:
  using Function = std::function<double(double)>;
  enum class Weight { cosine, sine };

  FourierIntegral();

  /// integral_a^infinity f(y) weight(y) dy, to an absolute error of `tolerance`.
  Integral to_infinity(const Function& f, double a, Weight weight, double tolerance);
  /// integral_a^b f(y) dy, to an absolute error of `tolerance`.
  Integral between(const Function& f, double a, double b, double tolerance);

 private:
  template <auto release>
  struct Release {
    template <class T>
    void operator()(T* pointer) const {
      release(pointer);
    }
  };
  using Workspace =
      std::unique_ptr<gsl_integration_workspace, Release<gsl_integration_workspace_free>>;
  using Table =
      std::unique_ptr<gsl_integration_qawo_table, Release<gsl_integration_qawo_table_free>>;

  Workspace workspace_;
  Workspace cycles_;
  Table cosine_;
  Table sine_;
};

}  // namespace porowave::reference
