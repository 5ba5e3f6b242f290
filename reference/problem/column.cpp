#include "reference/problem/column.hpp"

#include "reference/problem/toml_document.hpp"

namespace porowave {

Column read_column(const TomlDocument& document) {
  auto section = document.section("column");
  Column column;
  column.near = static_cast<NearEnd>(section.choice("near", near_end_names));
  column.far = static_cast<FarEnd>(section.choice("far", far_end_names));
  if (column.far == FarEnd::half_space) {
    if (section.has("length")) section.refuse("length", "no length with far = \"half_space\"");
  } else {
    column.length = section.number("length", Range::positive());
  }
  section.done();
  return column;
}

}  // namespace porowave
