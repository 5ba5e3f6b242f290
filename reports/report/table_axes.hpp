#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/report/case_keys.hpp"
#include "reports/report/case_table.hpp"

namespace porowave::reports {

struct AxesOfTable {
  std::vector<TableAxis> axes;                   ///< of the method first; those of the problem last
  std::vector<std::vector<std::size_t>> places;  ///< of every case, its value on every axis
  std::vector<std::pair<std::string, std::string>> constants;
};

/// In what the cases differ, apart from the keys in `aside`. Keys that change together (of all
/// combinations of their values fewer than three quarters occur) make one axis, "method".
AxesOfTable axes_of(const std::vector<CaseKeys>& cases, const std::vector<std::string>& aside);

}  // namespace porowave::reports
