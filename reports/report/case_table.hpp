#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verification/order/error_table.hpp"
#include "verification/store/record.hpp"

namespace porowave::reports {

/// Something in which the groups of a study differ: a key of the case, or several keys that change
/// together (methods).
struct TableAxis {
  std::vector<std::string> keys;    ///< "discretization.kernel"; "program.numerics" is the build
  std::string title;                ///< "kernel"; of several keys "method"
  std::vector<std::string> values;  ///< for people, in their natural order
  bool of_problem = false;          ///< changes what is solved, not how: errors do not compare
};

/// The cases of one level of a group; one a seed.
struct TableLevel {
  double spacing = 1.0;  ///< element length in m (StudyTable::spacing_is_length) or 1/elements
  std::string text;      ///< value of the key of refinement: "200"
  std::vector<std::size_t> rows;  ///< in StudyTable::rows, by seed
};

/// Cases that differ only in level and seed.
struct TableGroup {
  std::vector<std::size_t> at;     ///< its value on every axis
  std::string name;                ///< "kernel = bspline2, placement = random"; "all cases"
  std::vector<TableLevel> levels;  ///< coarse to fine
};

/// What a store holds of one study.
struct StudyTable {
  std::string study;
  std::vector<verification::Record> rows;
  std::vector<std::string> seeds;  ///< of every row; "" without one
  std::vector<TableAxis> axes;     ///< those of the problem last
  std::vector<TableGroup> groups;  ///< in the order of their values
  std::string refined_by;          ///< "discretization.elements"
  bool spacing_is_length = true;
  std::vector<std::pair<std::string, std::string>> constants;  ///< keys that do not vary

  std::string value(const TableGroup& group, std::size_t axis) const {
    return axes[axis].values[group.at[axis]];
  }
};

struct CaseTableOptions {
  std::string store = "store";  ///< its name in messages
  /// Key of refinement; another than elements is a length, a time or a number that falls.
  std::string refined_by = "discretization.elements";
  /// What the rows' provenance stands for: rows with one specification and different builds are
  /// told apart by it.
  std::map<std::string, std::string> numerics;  ///< by id of provenance
};

/// The rows of a store by study, in the order of their names. Works for any rows: those of one
/// level, of no seed, a single one, none. Throws InputError if a specification is not TOML.
std::vector<StudyTable> case_tables(std::vector<verification::Record> rows,
                                    const CaseTableOptions& options = {});

/// Errors of a measure over levels and seeds (all seeds of the group), NaN where there is none.
verification::ErrorTable errors_of(const StudyTable& table, const TableGroup& group,
                                   std::size_t measure);

}  // namespace porowave::reports
