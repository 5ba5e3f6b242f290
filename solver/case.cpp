#include "solver/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "reference/problem/toml_document.hpp"

namespace porowave::solver {

namespace {

constexpr int most_elements = 10'000'000;
constexpr int most_points_per_element = 1000;

// A word of the interface that this version does not offer is refused by name.
void refuse_if(TomlSection& section, std::string_view key, std::string_view word,
               std::string_view instead) {
  if (section.is_text(key) && section.text(key) == word) {
    section.refuse(key, fmt::format("{}: \"{}\" is not available in this version", instead, word));
  }
}

void read_shape_transfer(TomlSection& section, Discretization& d) {
  d.kernel = kernel_name<BSpline1>;
  d.support_radius = natural_radius(d.kernel);
  d.basis_order = 0;
  if (section.has("kernel") && section.text("kernel") != "bspline1") {
    section.refuse("kernel", "\"bspline1\" with transfer = \"shape\", the linear shape functions");
  }
  if (section.has("support_radius") &&
      (section.is_text("support_radius") || section.number("support_radius", {}) != 1.0)) {
    section.refuse("support_radius", "1 with transfer = \"shape\", which has no other support");
  }
  if (section.has("basis_order")) {
    section.refuse("basis_order", "no basis_order with transfer = \"shape\", which has no basis");
  }
}

void read_mls_transfer(TomlSection& section, Discretization& d) {
  constexpr auto names = kernel_names();
  refuse_if(section, "kernel", "gimp", "a B-spline or Wendland kernel");
  const auto fallback = static_cast<std::size_t>(kernel_name<BSpline2>);
  d.kernel = KernelName{section.choice_or("kernel", fallback, names)};
  refuse_if(section, "support_radius", "adaptive", "a number");
  const Range radius{1.0 / d.points_per_element, static_cast<double>(d.elements)};
  d.support_radius = section.number_or("support_radius", natural_radius(d.kernel), {});
  if (!radius.contains(d.support_radius)) {
    const auto expected =
        fmt::format("{}: from the point spacing of {:g} to the {} elements of the column",
                    radius.text(), radius.low, d.elements);
    section.refuse("support_radius", expected);
  }
  d.basis_order = static_cast<int>(section.integer_or("basis_order", 1, 0, 2));
}

std::vector<double> read_empty_elements(TomlSection& section, const Problem& problem) {
  const double length = problem.column.length.value_or(std::numeric_limits<double>::infinity());
  return section.numbers_or("empty_elements", {}, Range::between(0.0, length));
}

Discretization read_discretization(const TomlDocument& document, const Problem& problem) {
  auto section = document.section("discretization");
  Discretization d;
  d.elements = static_cast<int>(section.integer("elements", 2, most_elements));
  // The points of a phase are numbered by an int.
  const int most_points =
      std::min(most_points_per_element, std::numeric_limits<int>::max() / d.elements);
  d.points_per_element = static_cast<int>(
      section.integer_or("points_per_element", d.points_per_element, 1, most_points));
  refuse_if(section, "transfer", "apic", "\"shape\" or \"mls\"");
  constexpr std::array<std::string_view, 2> transfers = {"shape", "mls"};
  d.transfer = static_cast<TransferName>(section.choice_or("transfer", 1, transfers));
  if (d.transfer == TransferName::shape) {
    read_shape_transfer(section, d);
  } else {
    read_mls_transfer(section, d);
  }
  d.placement = static_cast<Placement>(section.choice_or("placement", 0, placement_names));
  if (d.placement != Placement::jittered && section.has("jitter")) {
    section.refuse("jitter", "no jitter unless placement = \"jittered\"");
  }
  d.jitter = section.number_or("jitter", d.jitter, Range::between(0.0, 1.0));
  d.seed = static_cast<std::uint64_t>(
      section.integer_or("seed", 1, 0, std::numeric_limits<long>::max()));
  d.empty_elements = read_empty_elements(section, problem);
  refuse_if(section, "strain", "recovered", "\"cell\"");
  refuse_if(section, "scheme", "staggered4", "\"galerkin\"");
  constexpr std::array<std::string_view, 1> strains = {"cell"};
  constexpr std::array<std::string_view, 1> schemes = {"galerkin"};
  section.choice_or("strain", 0, strains);
  section.choice_or("scheme", 0, schemes);
  section.done();
  return d;
}

TimeSettings read_time(const TomlDocument& document) {
  auto section = document.section("time");
  TimeSettings time;
  time.end = section.number("end", Range::positive());
  refuse_if(section, "courant", "auto", "a number > 0 and <= 1");
  time.courant = section.number_or("courant", time.courant, Range{0.0, 1.0, true, false});
  time.flip = section.number_or("flip", time.flip, Range::between(0.0, 1.0));
  time.path = static_cast<StepPath>(section.choice_or("path", 0, path_names));
  section.done();
  return time;
}

}  // namespace

Case read_case(const TomlDocument& document) {
  document.only({"material", "column", "load", "discretization", "time"});
  const Problem problem = read_problem(document);
  return {problem, read_discretization(document, problem), read_time(document)};
}

Case load_case(const std::string& path) {
  return read_case(TomlDocument::load(path));
}

}  // namespace porowave::solver
