#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace porowave::fixtures {

/// Material and load of the column of these tests; `permeability` in m².
inline std::string column_text(const std::string& permeability) {
  return "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
         "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\n"
         "intrinsic_permeability = " +
         permeability +
         "\nfluid_viscosity = 1.0e-3\n[column]\nlength = 0.1\nnear = \"drained_traction\"\n"
         "far = \"rigid_sealed\"\n[load]\nshape = \"step\"\nmagnitude = 1.0\n";
}

/// The lines of a text, without their ends.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace porowave::fixtures
