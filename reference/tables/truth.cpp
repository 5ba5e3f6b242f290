#include "reference/tables/truth.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "reference/problem/errors.hpp"

namespace porowave::fixtures {

namespace {

template <class Names>
std::size_t index_of(const Names& names, const std::string& word) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) throw InputError("truth table: unknown word " + word);
  return static_cast<std::size_t>(found - names.begin());
}

TruthRow parse(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cell;
  for (std::string text; std::getline(stream, text, ',');) cell.push_back(text);
  if (cell.size() != 20) throw InputError("truth table: 20 columns expected in " + line);
  const auto number = [&](std::size_t i) { return std::stod(cell[i]); };
  TruthRow row;
  row.id = cell[0];
  row.problem.material = {number(1), number(2), number(3), number(4),
                          number(5), number(6), number(7)};
  if (cell[8] != "inf") row.problem.column.length = number(8);
  row.problem.column.near = static_cast<NearEnd>(index_of(near_end_names, cell[9]));
  row.problem.column.far = static_cast<FarEnd>(index_of(far_end_names, cell[10]));
  const auto shape = static_cast<LoadShape>(index_of(load_shape_names, cell[11]));
  row.problem.load = Load(shape, 1.0, number(12));
  row.x = number(13);
  row.t = number(14);
  row.value = {number(15), number(16), number(17), number(18)};
  row.uncertainty = std::pow(10.0, -number(19));
  return row;
}

}  // namespace

std::vector<TruthRow> read_truth(const std::string& path) {
  std::ifstream file(path);
  std::vector<TruthRow> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.rfind("id,", 0) == 0) continue;
    rows.push_back(parse(line));
  }
  if (rows.empty()) throw InputError("truth table: no rows in " + path);
  return rows;
}

}  // namespace porowave::fixtures
