#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "verification/store/record.hpp"

namespace porowave::reports::report_fixtures {

/// A name with all that HTML, JSON, gnuplot, LaTeX and shells take for more than a letter, of 200
/// characters.
inline std::string nasty_name() {
  std::string name = R"(<b>"R" & 'D'</script> \n {x_1^2} $#% `|~@ )";
  name.resize(200, 'z');
  return name;
}

struct MadeCase {
  std::string kernel = "bspline1";
  double support_radius = 2.0;
  std::string shape = "step";
  int elements = 50;
  int seed = 1;

  std::string specification() const {
    return fmt::format(
        "[column]\nlength = 0.1\n[load]\nshape = \"{}\"\n[discretization]\nelements = {}\nkernel = "
        "\"{}\"\nseed = {}\nsupport_radius = {:#.6g}\n[time]\nend = 1e-05\n",
        shape, elements, kernel, seed, support_radius);
  }
};

/// A row of which all errors are the same.
inline verification::Record row(const MadeCase& made, double error,
                                const std::string& study = "trial") {
  verification::Record record;
  record.specification = made.specification();
  record.study = study;
  record.id =
      fmt::format("{0:016x}{0:016x}", std::hash<std::string>()(study + record.specification));
  record.steps = made.elements;
  record.points = 8 * made.elements;
  record.measures.assign(verification::measure_names().size(), error);
  record.cpu_seconds = 1e-8 * static_cast<double>(record.steps * record.points);
  record.provenance = "p";
  return record;
}

/// Ended by a breakdown, with numbers in it that must not count.
inline verification::Record broken(verification::Record record) {
  record.status = verification::CaseStatus::broke_down;
  record.reason = "step 7: <it> broke \"down\"";
  return record;
}

/// A row of a case that can be run again, with a made up error; `rest` stands in [discretization].
inline verification::Record runnable_row(int elements, double error,
                                         const std::string& rest = "kernel = \"bspline2\"",
                                         double courant = 0.5, const std::string& study = "trial") {
  verification::Record record = row({}, error, study);
  record.specification = fmt::format(
      "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
      "constrained_modulus = 5e9\nfluid_bulk_modulus = 2.2e9\nintrinsic_permeability = 1e-11\n"
      "fluid_viscosity = 1e-3\n[column]\nlength = 0.1\nnear = \"drained_traction\"\n"
      "far = \"rigid_sealed\"\n[load]\nshape = \"smooth_ramp\"\nmagnitude = 1.0\nduration = "
      "1e-5\n[discretization]\nelements = {}\n{}\n[time]\nend = 3e-5\ncourant = {:#.3g}\n",
      elements, rest, courant);
  record.id =
      fmt::format("{0:016x}{0:016x}", std::hash<std::string>()(study + record.specification));
  return record;
}

/// Kernels of first and second order, two radii, three seeds, four levels: errors C h^p e^(± 0.1).
inline std::vector<verification::Record> full_study(const std::string& study = "trial") {
  std::vector<verification::Record> rows;
  for (const std::string kernel : {"bspline1", "bspline2"}) {
    for (const double radius : {2.0, 3.0}) {
      for (int seed = 1; seed <= 3; ++seed) {
        for (const int elements : {25, 50, 100, 200}) {
          const double order = kernel == "bspline1" ? 1.0 : 2.0;
          const double error = 0.1 * radius * std::pow(25.0 / elements, order);
          rows.push_back(row({kernel, radius, "step", elements, seed},
                             error * std::exp(0.1 * (seed - 2)), study));
        }
      }
    }
  }
  return rows;
}

}  // namespace porowave::reports::report_fixtures
