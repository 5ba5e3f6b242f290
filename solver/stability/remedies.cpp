#include "solver/stability/remedies.hpp"

#include <fmt/format.h>

#include <array>

#include "reference/problem/errors.hpp"
#include "solver/stability/automatic_step.hpp"
#include "solver/stability/run_growth.hpp"

namespace porowave::solver {

namespace {

constexpr std::array courants = {0.8, 0.6, 0.4, 0.2};
constexpr int most_named = 2;
constexpr int many_points = 6;

void add_for_mls(const Case& scene, std::vector<Remedy>& list) {
  const Discretization& d = scene.discretization;
  const auto with = [&](std::string text, auto change) {
    list.push_back({std::move(text), scene});
    change(list.back().scene.discretization);
  };
  const auto recover = [](Discretization& c) { c.strain = Strain::recovered; };
  const auto adapt = [](Discretization& c) {
    c.adaptive_support = true;
    c.support_radius = natural_radius(c.kernel);
  };
  if (d.basis_order == 2) with("basis_order = 1", [](auto& c) { c.basis_order = 1; });
  if (d.strain == Strain::cell) with("strain = \"recovered\"", recover);
  if (!d.adaptive_support) with("support_radius = \"adaptive\"", adapt);
  if (d.strain == Strain::cell && !d.adaptive_support) {
    with("strain = \"recovered\" with support_radius = \"adaptive\"", [&](auto& c) {
      recover(c);
      adapt(c);
    });
  }
  if (d.basis_order == 0) with("basis_order = 1", [](auto& c) { c.basis_order = 1; });
}

void add_for_staggered(const Case& scene, std::vector<Remedy>& list) {
  const auto with = [&](std::string text, int order, double radius) {
    list.push_back({std::move(text), scene});
    list.back().scene.discretization.basis_order = order;
    list.back().scene.discretization.support_radius = radius;
  };
  if (scene.discretization.basis_order == 3) with("basis_order = 2", 2, 2.0);
  if (scene.discretization.support_radius < 3.0) {
    with("support_radius = 3.0", scene.discretization.basis_order, 3.0);
  }
}

void add_points(const Case& scene, std::vector<Remedy>& list) {
  const auto with = [&](std::string text, int points, Placement placement) {
    list.push_back({std::move(text), scene});
    list.back().scene.discretization.points_per_element = points;
    list.back().scene.discretization.placement = placement;
  };
  const Discretization& d = scene.discretization;
  if (d.points_per_element < many_points) {
    const int more = std::min(2 * d.points_per_element, many_points);
    with(fmt::format("points_per_element = {}", more), more, d.placement);
  }
  if (d.placement == Placement::random) {
    with("placement = \"stratified\"", d.points_per_element, Placement::stratified);
  }
  if (d.placement != Placement::uniform) {
    with("placement = \"uniform\"", d.points_per_element, Placement::uniform);
  }
}

bool helps(const Case& scene, double end) {
  try {
    RunGrowth growth(scene, end);
    for (const double courant : courants) {
      if (growth.at(courant) <= tolerated_growth) return true;
    }
  } catch (const BreakdownError&) {
  }
  return false;
}

}  // namespace

std::vector<Remedy> remedies(const Case& scene) {
  std::vector<Remedy> list;
  if (scene.discretization.scheme == Scheme::staggered4) {
    add_for_staggered(scene, list);
  } else if (scene.discretization.transfer == TransferName::mls) {
    add_for_mls(scene, list);
  }
  add_points(scene, list);
  return list;
}

std::string remedies_that_help(const Case& scene, double end) {
  std::string text;
  int named = 0;
  for (const Remedy& remedy : remedies(scene)) {
    if (named == most_named) break;
    if (!helps(remedy.scene, end)) continue;
    text += (named++ > 0 ? " or " : "") + remedy.text;
  }
  return text;
}

}  // namespace porowave::solver
