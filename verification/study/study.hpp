#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reference/problem/toml_document.hpp"
#include "solver/case.hpp"
#include "verification/adapters/adapter.hpp"

namespace porowave::verification {

/// A value for a key of a case.
struct Setting {
  std::string section;  ///< "discretization"
  std::string key;      ///< "kernel"
  TomlValue value;
};

/// One key of a case and the values that it takes; or the methods, by name.
struct Axis {
  std::string section;                             ///< "discretization"; empty for methods
  std::string key;                                 ///< "kernel"; "method"
  std::vector<TomlValue> values;                   ///< of a method its name
  std::vector<std::vector<Setting>> methods = {};  ///< what each name stands for

  std::string name() const { return section.empty() ? key : section + "." + key; }
};

/// One case of a study.
struct StudyCase {
  std::vector<TomlValue> coordinates;  ///< its value on every axis, in the order of Study::axes
  std::string specification;           ///< all of it as TOML, a file that `porowave solve` reads
  std::string id;                      ///< 32 hexadecimal digits of specification and programs
  solver::Case scene;
};

/// A grid of cases: a case file with [study], [axes], [[method]], [refine] and [[exclude]], and
/// with [adapter] if another solver runs them (verification/adapters/adapter.hpp).
///
///   [study] name = "paper"
///   [axes]  "discretization.kernel" = ["bspline1", "bspline2"]        any key of a case
///           "discretization.seed" = { first = 1, count = 16 }
///   [[method]] name = "uGIMP"            keys that change together: the axis "method", which is
///           "discretization.transfer" = "shape"                       the first one
///           "discretization.kernel" = "gimp"
///   [refine] by = "discretization.elements"                           an axis of numbers
///   [[exclude]]                          leaves out cases that have all of these values;
///           "discretization.kernel" = "bspline1"       a list stands for any of its entries
///   [gate], [[known_failure]]            what it is judged by: gate/gate.hpp
struct Study {
  std::string path;
  std::string name;
  std::vector<Axis> axes;
  std::optional<std::size_t> refine;  ///< index of the axis of levels
  std::optional<std::size_t> seed;    ///< index of the axis of replicates, discretization.seed
  std::optional<Adapter> adapter;     ///< whose solver runs the cases; none for ours
  std::vector<StudyCase> cases;       ///< the last axis changes fastest
};

/// Reads a study and makes its cases. Throws InputError, also for a combination of values that no
/// case may have (the message says how to exclude it).
Study read_study(const TomlDocument& document);
Study load_study(const std::string& path);

}  // namespace porowave::verification
