#include "reference/problem/problem.hpp"

#include "reference/problem/toml_document.hpp"

namespace porowave {

double Problem::stress_scale() const {
  const double impedance = material.mixture_density() * material.undrained_speed();
  return column.near == NearEnd::velocity ? load.peak() * impedance : load.peak();
}

double Problem::velocity_scale() const {
  return stress_scale() / (material.mixture_density() * material.undrained_speed());
}

Problem read_problem(const TomlDocument& document) {
  return {read_material(document), read_column(document), read_load(document)};
}

Problem load_problem(const std::string& path) {
  const TomlDocument document = TomlDocument::load(path);
  document.only({"material", "column", "load", "discretization", "time", "study", "axes", "refine",
                 "exclude", "gate", "known_failure", "adapter"});
  return read_problem(document);
}

}  // namespace porowave
