#include "solver/case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/problem/errors.hpp"
#include "reference/problem/toml_document.hpp"
#include "solver/stability/automatic_step.hpp"

namespace porowave::solver {

namespace {

constexpr int most_elements = 10'000'000;
constexpr int most_points_per_element = 1000;
constexpr int most_xpic_orders = 10;
constexpr int fewest_staggered_elements = 8;
constexpr double highest_max_condition = 1e12;

// A word of the interface that this version does not offer is refused by name.
void refuse_if(TomlSection& section, std::string_view key, std::string_view word,
               std::string_view instead) {
  if (section.is_text(key) && section.text(key) == word) {
    section.refuse(key, fmt::format("{}: \"{}\" is not available in this version", instead, word));
  }
}

template <std::size_t N>
std::string quoted(const std::array<std::string_view, N>& words) {
  return fmt::format("\"{}\"", fmt::join(words, "\", \""));
}

// shape and apic: `allowed` are the words for the shape functions.
template <std::size_t N>
void read_shape(TomlSection& section, const char* transfer, std::string_view fallback,
                const std::array<std::string_view, N>& allowed, Discretization& d) {
  const std::string word = section.text_or("kernel", std::string(fallback));
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end()) {
    section.refuse("kernel",
                   fmt::format("one of {} with transfer = \"{}\"", quoted(allowed), transfer));
  }
  d.shape = *shape_from_name(word);
  d.kernel = kernel_from_name(word).value_or(kernel_name<BSpline1>);
  d.basis_order = 0;
  const auto with = fmt::format("with transfer = \"{}\"", transfer);
  d.support_radius = visit_shape(d.shape, [](auto s) { return decltype(s)::reach(0.0); });
  if (section.has("support_radius") && (section.is_text("support_radius") ||
                                        section.number("support_radius", {}) != d.support_radius)) {
    section.refuse("support_radius",
                   fmt::format("{:g} {}, which has no other support", d.support_radius, with));
  }
  for (const char* key : {"basis_order", "max_condition"}) {
    if (section.has(key)) {
      section.refuse(key, fmt::format("no {} {}, which has no basis", key, with));
    }
  }
}

void read_strain(TomlSection& section, Discretization& d) {
  d.strain = static_cast<Strain>(section.choice_or("strain", 0, strain_names));
  if (d.strain != Strain::recovered) return;
  if (d.transfer == TransferName::apic) {
    section.refuse("strain", "\"cell\" with transfer = \"apic\", whose strain is the affine field");
  }
  if (d.transfer == TransferName::shape && d.shape != shape_name<LinearSpline>) {
    section.refuse("strain",
                   "\"cell\" with shape functions other than \"bspline1\", whose strain "
                   "is not constant in a cell");
  }
}

void read_support(TomlSection& section, Discretization& d) {
  d.support_radius = natural_radius(d.kernel);
  if (section.is_text("support_radius")) {
    if (section.text("support_radius") != "adaptive") {
      section.refuse("support_radius", "a number or \"adaptive\"");
    }
    d.adaptive_support = true;
    return;
  }
  const Range radius{1.0 / d.points_per_element, static_cast<double>(d.elements)};
  d.support_radius = section.number_or("support_radius", d.support_radius, {});
  if (!radius.contains(d.support_radius)) {
    const auto expected =
        fmt::format("{}: from the point spacing of {:g} to the {} elements of the column",
                    radius.text(), radius.low, d.elements);
    section.refuse("support_radius", expected);
  }
}

void read_mls_transfer(TomlSection& section, Discretization& d) {
  static constexpr auto names = kernel_names();
  for (const std::string_view word : {"gimp", "cpgimp"}) {
    if (section.is_text("kernel") && section.text("kernel") == word) {
      section.refuse("kernel", fmt::format("one of {} with transfer = \"mls\"", quoted(names)));
    }
  }
  const auto fallback = static_cast<std::size_t>(kernel_name<BSpline2>);
  d.kernel = KernelName{section.choice_or("kernel", fallback, names)};
  read_support(section, d);
  d.basis_order = static_cast<int>(section.integer_or("basis_order", 1, 0, 2));
  d.max_condition = section.number_or("max_condition", d.max_condition,
                                      {1.0, highest_max_condition, true, false});
}

void read_galerkin_scheme(TomlSection& section, Discretization& d) {
  d.transfer = static_cast<TransferName>(section.choice_or("transfer", 1, transfer_names));
  switch (d.transfer) {
    case TransferName::shape:
      read_shape(section, "shape", "bspline1", shape_names(), d);
      break;
    case TransferName::mls:
      read_mls_transfer(section, d);
      break;
    case TransferName::apic:
      read_shape(section, "apic", "bspline2",
                 std::array<std::string_view, 3>{"bspline1", "bspline2", "bspline3"}, d);
      break;
  }
  read_strain(section, d);
}

// The support of staggered4 always adapts: what a case may give is where it starts.
void read_staggered_scheme(TomlSection& section, Discretization& d) {
  const auto of_scheme = [](std::string_view what) {
    return fmt::format("{} with scheme = \"staggered4\"", what);
  };
  if (section.has("transfer") && section.text("transfer") != "mls") {
    section.refuse("transfer", of_scheme("\"mls\""));
  }
  for (const char* key : {"strain", "max_condition"}) {
    if (section.has(key)) section.refuse(key, of_scheme(fmt::format("no {}", key)));
  }
  if (d.elements < fewest_staggered_elements) {
    section.refuse("elements", of_scheme(fmt::format("at least {}", fewest_staggered_elements)));
  }
  constexpr auto names = kernel_names();
  refuse_if(section, "kernel", "gimp", "a B-spline or Wendland kernel");
  const auto fallback = static_cast<std::size_t>(kernel_name<WendlandC2>);
  d.transfer = TransferName::mls;
  d.kernel = KernelName{section.choice_or("kernel", fallback, names)};
  d.basis_order = static_cast<int>(section.integer_or("basis_order", 2, 2, 3));
  // Cubics want a little more: with radius 2 and four random points a cell some runs blow up.
  d.support_radius = d.basis_order == 3 ? 2.5 : 2.0;
  if (section.is_text("support_radius") && section.text("support_radius") == "adaptive") return;
  d.support_radius =
      section.number_or("support_radius", d.support_radius, Range::between(1.0, 8.0));
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
  constexpr std::array<std::string_view, 2> schemes = {"galerkin", "staggered4"};
  d.scheme = static_cast<Scheme>(section.choice_or("scheme", 0, schemes));
  if (d.scheme == Scheme::staggered4) {
    read_staggered_scheme(section, d);
  } else {
    read_galerkin_scheme(section, d);
  }
  d.placement = static_cast<Placement>(section.choice_or("placement", 0, placement_names));
  if (d.placement != Placement::jittered && section.has("jitter")) {
    section.refuse("jitter", "no jitter unless placement = \"jittered\"");
  }
  d.jitter = section.number_or("jitter", d.jitter, Range::between(0.0, 1.0));
  d.seed = static_cast<std::uint64_t>(
      section.integer_or("seed", 1, 0, std::numeric_limits<long>::max()));
  d.empty_elements = read_empty_elements(section, problem);
  section.done();
  return d;
}

// How velocities go back to the points: flip, or xpic_order, or neither with apic.
void read_velocity_update(TomlSection& section, TransferName transfer, TimeSettings& time) {
  if (transfer == TransferName::apic) {
    for (const char* key : {"flip", "xpic_order"}) {
      if (section.has(key)) {
        section.refuse(key, fmt::format("no {} with transfer = \"apic\", whose points take the "
                                        "velocity of the nodes and its gradient",
                                        key));
      }
    }
    time.flip = 0.0;
    return;
  }
  time.flip = section.number_or("flip", time.flip, Range::between(0.0, 1.0));
  if (!section.has("xpic_order")) return;
  time.xpic_order = static_cast<int>(section.integer("xpic_order", 1, most_xpic_orders));
  if (section.has("flip")) section.refuse("flip", "no flip with xpic_order, which takes its place");
}

// Order of the time step, and what scheme = "staggered4" leaves no choice in.
void read_time_order(TomlSection& section, Scheme scheme, TimeSettings& time) {
  if (section.has("time_order")) {
    if (scheme != Scheme::staggered4) {
      section.refuse("time_order", "no time_order unless scheme = \"staggered4\"");
    }
    time.order = static_cast<int>(section.integer_or("time_order", 2, 2, 4));
    if (time.order == 3) section.refuse("time_order", "2 or 4");
  }
  if (scheme != Scheme::staggered4) return;
  if (time.flip != 1.0) section.refuse("flip", "1 with scheme = \"staggered4\"");
  if (section.has("xpic_order")) {
    section.refuse("xpic_order", "no xpic_order with scheme = \"staggered4\"");
  }
  if (section.is_text("path") && section.text("path") == "points") {
    section.refuse(
        "path", "\"auto\" or \"frozen\" with scheme = \"staggered4\", which eliminates the points");
  }
}

void read_path(TomlSection& section, const Discretization& discretization, TimeSettings& time) {
  time.path = static_cast<StepPath>(section.choice_or("path", 0, path_names));
  if (time.path == StepPath::frozen && discretization.scheme == Scheme::galerkin &&
      !compact_form_available(discretization, time)) {
    section.refuse(
        "path",
        "\"auto\" or \"points\": points can be eliminated with linear shape functions and "
        "no xpic_order");
  }
}

// NaN for "auto", which is settled when the rest of the case is known.
double read_courant(TomlSection& section) {
  const Range range{0.0, 1.0, true, false};
  if (!section.is_text("courant")) {
    return section.number_or("courant", TimeSettings{}.courant, range);
  }
  if (section.text("courant") != "auto") {
    section.refuse("courant", range.text() + ", or \"auto\"");
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TimeSettings read_time(const TomlDocument& document, const Discretization& discretization) {
  auto section = document.section("time");
  TimeSettings time;
  time.end = section.number("end", Range::positive());
  time.courant = read_courant(section);
  read_velocity_update(section, discretization.transfer, time);
  read_time_order(section, discretization.scheme, time);
  read_path(section, discretization, time);
  section.done();
  return time;
}

void choose_courant(const TomlDocument& document, Case& scene) {
  scene.time.courant = TimeSettings{}.courant;
  try {
    scene.time.automatic = automatic_step(scene);
  } catch (const NoStableStep& reason) {
    document.section("time").refuse("courant", reason.what());
  } catch (const BreakdownError& reason) {
    document.section("time").refuse("courant",
                                    fmt::format("a scene that can be stepped; {}", reason.what()));
  }
  scene.time.courant = scene.time.automatic->courant;
}

}  // namespace

Case read_case(const TomlDocument& document) {
  document.only({"material", "column", "load", "discretization", "time"});
  const Problem problem = read_problem(document);
  const Discretization discretization = read_discretization(document, problem);
  Case scene{problem, discretization, read_time(document, discretization)};
  if (std::isnan(scene.time.courant)) choose_courant(document, scene);
  return scene;
}

std::string_view kernel_word(const Discretization& d) {
  return d.transfer == TransferName::mls ? to_string(d.kernel) : to_string(d.shape);
}

bool compact_form_available(const Discretization& d, const TimeSettings& time) {
  const bool linear = d.transfer == TransferName::mls ||
                      (d.transfer == TransferName::shape && d.shape == shape_name<LinearSpline>);
  return linear && time.xpic_order == 0;
}

Case load_case(const std::string& path) {
  return read_case(TomlDocument::load(path));
}

}  // namespace porowave::solver
