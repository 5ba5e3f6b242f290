#pragma once

#include <functional>
#include <string>

#include "verification/gate/gate.hpp"
#include "verification/process/scratch_directory.hpp"

namespace porowave::verification::gate_fixtures {

/// A study of two kernels, four seeds and three levels, and stores with errors made up for it.
struct Trial {
  explicit Trial(const std::string& rest = "", int first_seed = 1)
      : document(TomlDocument::parse(
            "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
            "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\n"
            "intrinsic_permeability = 1.0e-11\nfluid_viscosity = 1.0e-3\n"
            "[column]\nlength = 0.1\nnear = \"drained_traction\"\nfar = \"rigid_sealed\"\n"
            "[load]\nshape = \"step\"\nmagnitude = 1.0\n"
            "[time]\nend = 1.0e-5\n[study]\nname = \"trial\"\n"
            "[axes]\n\"discretization.kernel\" = [\"bspline1\", \"bspline2\"]\n"
            "\"discretization.seed\" = { first = " +
                std::to_string(first_seed) +
                ", count = 4 }\n"
                "\"discretization.elements\" = [50, 100, 200]\n"
                "[refine]\nby = \"discretization.elements\"\n" +
                rest,
            "trial.toml")),
        study(read_study(document)),
        rules(read_gate_rules(document, study)) {}

  using ErrorOf = std::function<double(const solver::Discretization&)>;
  /// A new store in which all errors of a case are `error`; `edit` may change rows, or drop them by
  /// returning false.
  Store store_with(
      const ErrorOf& error,
      const std::function<bool(Record&)>& edit = [](Record&) { return true; }) const {
    Store store = Store::create_or_open(directory.file("store" + std::to_string(stores++)));
    std::vector<Record> records;
    for (const StudyCase& one : study.cases) {
      Record record;
      record.id = one.id;
      record.specification = one.specification;
      record.steps = 1;
      record.measures.assign(measure_names().size(), error(one.scene.discretization));
      record.measures[*measure_index("reference_error")] = 1e-12;
      if (edit(record)) records.push_back(record);
    }
    store.add(records);
    return store;
  }
  std::vector<Group> groups_with(const ErrorOf& error) const {
    return groups_of(study, store_with(error));
  }

  TomlDocument document;
  Study study;
  GateRules rules;
  ScratchDirectory directory;
  mutable int stores = 0;
};

/// (100/n)^order with a scatter of 5 % that depends on seed and level.
inline double scattered(const solver::Discretization& d, double order) {
  const double phase = 1.7 * static_cast<double>(d.seed) + 0.1 * d.elements;
  return 0.01 * std::pow(100.0 / d.elements, order) * std::exp(0.05 * std::sin(phase));
}

}  // namespace porowave::verification::gate_fixtures
