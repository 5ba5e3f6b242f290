#pragma once

// Cases as texts, and the messages for them, for the tests of Case.

#include <boost/test/unit_test.hpp>
#include <string>

#include "reference/problem/errors.hpp"
#include "reference/problem/toml_document.hpp"
#include "solver/case.hpp"

namespace porowave::solver::test {

// Every key that a case may have, each with a value that is not its default. Tests name its lines:
// [discretization] starts at 20, [time] at 34.
inline const std::string full = R"([material]
porosity = 0.4
grain_density = 2650.0
fluid_density = 1000.0
constrained_modulus = 5.0e9
fluid_bulk_modulus = 2.2e9
intrinsic_permeability = 1.0e-11
fluid_viscosity = 1.0e-3

[column]
length = 0.1
near = "sealed_traction"
far = "rigid_drained"

[load]
shape = "smooth_ramp"
magnitude = 2.0
duration = 1.0e-5

[discretization]
elements = 200
transfer = "mls"
kernel = "wendland_c4"
support_radius = 2.75
basis_order = 2
points_per_element = 3
placement = "jittered"
jitter = 0.25
seed = 12345678901
empty_elements = [0.05, 0]
strain = "cell"
scheme = "galerkin"

[time]
end = 4.0e-5
courant = 0.25
flip = 0.75
path = "points"
)";

inline const std::string problem_only = full.substr(0, full.find("[discretization]"));
inline const std::string least = problem_only + "[discretization]\nelements = 2\n[time]\nend = 1\n";

inline Case read(const std::string& text) {
  return read_case(TomlDocument::parse(text, "case.toml"));
}

inline std::string with(const std::string& from, const std::string& to, std::string text = full) {
  const auto at = text.find(from);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, "nothing to replace: " << from);
  return text.replace(at, from.size(), to);
}

inline std::string message_for(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// The message for the full case with one line replaced.
inline std::string refusal(const std::string& from, const std::string& to) {
  return message_for(with(from, to));
}

}  // namespace porowave::solver::test
