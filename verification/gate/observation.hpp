#pragma once

#include <string>
#include <vector>

#include "verification/order/error_table.hpp"
#include "verification/store/store.hpp"
#include "verification/study/study.hpp"

namespace porowave::verification {

/// The cases of a study that differ only in level and seed, with their rows.
struct Group {
  std::string name;                ///< values of the other axes; "all cases" if there are none
  std::vector<TomlValue> levels;   ///< of the axis of refinement, coarse to fine
  std::vector<double> spacing;     ///< 1/elements, or the value of another axis of refinement
  std::vector<std::string> seeds;  ///< one "" if the study has no axis of seeds
  /// [level][seed]; status `failed` and an empty id where the study has no such case.
  std::vector<std::vector<Record>> records;
  std::vector<std::string> missing;    ///< cases without a row, or failed (memory, a file): why
  std::vector<std::string> broken;     ///< cases that broke down or were refused, with their reason
  std::vector<TomlValue> coordinates;  ///< of the first case, on all axes of the study
  std::size_t cases = 0;
};

/// The groups of a study in the order in which it lists them.
std::vector<Group> groups_of(const Study& study, const Store& store);

/// The errors of one measure. NaN where there is none.
ErrorTable errors_of(const Group& group, std::size_t measure);

}  // namespace porowave::verification
