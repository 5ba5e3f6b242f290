#include "verification/stability/random_scene.hpp"

#include <fmt/format.h>

#include "verification/stability/dice.hpp"

namespace porowave::verification {

namespace {

using namespace solver;

void choose_problem(Dice& dice, Problem& problem) {
  Material& m = problem.material;
  m.porosity = dice.between(0.2, 0.6);
  m.grain_density = 2650.0;
  m.fluid_density = 1000.0;
  m.fluid_bulk_modulus = 2.2e9;
  m.constrained_modulus = m.fluid_bulk_modulus * dice.log_between(1e-4, 1e4);
  m.intrinsic_permeability = dice.log_between(1e-16, 1e-6);
  m.fluid_viscosity = 1e-3;
  problem.column.length = 0.1;
  problem.column.near = static_cast<NearEnd>(dice.integer(0, 3));
  problem.column.far = static_cast<FarEnd>(dice.integer(0, 2));
  problem.load = Load(LoadShape::step, 0.0);
}

void choose_mls(Dice& dice, Discretization& d) {
  d.transfer = TransferName::mls;
  d.kernel = KernelName{static_cast<std::size_t>(dice.integer(0, kernel_count - 1))};
  d.support_radius = natural_radius(d.kernel);
  if (dice.chance(0.3)) d.support_radius = dice.between(d.support_radius, 5.0);
  d.adaptive_support = dice.chance(0.2);
  d.basis_order = dice.chance(0.7) ? 1 : dice.integer(0, 2);
  d.strain = dice.chance(0.4) ? Strain::recovered : Strain::cell;
}

void choose_shape(Dice& dice, Case& scene) {
  Discretization& d = scene.discretization;
  const bool apic = dice.chance(0.3);
  d.transfer = apic ? TransferName::apic : TransferName::shape;
  d.shape = ShapeName{static_cast<std::size_t>(dice.integer(0, apic ? 2 : shape_count - 1))};
  d.basis_order = 0;
  if (apic) {
    scene.time.flip = 0.0;
  } else if (d.shape == shape_name<LinearSpline> && dice.chance(0.3)) {
    d.strain = Strain::recovered;
  }
}

void choose_staggered(Dice& dice, Case& scene) {
  Discretization& d = scene.discretization;
  d.scheme = Scheme::staggered4;
  d.transfer = TransferName::mls;
  d.kernel = kernel_name<WendlandC2>;
  d.basis_order = dice.integer(2, 3);
  d.support_radius = d.basis_order == 3 ? 2.5 : 2.0;
  scene.time.order = dice.chance(0.5) ? 4 : 2;
}

}  // namespace

Case random_scene(std::uint64_t number) {
  Dice dice(number);
  Case scene;
  choose_problem(dice, scene.problem);
  Discretization& d = scene.discretization;
  d.elements = dice.integer(16, 40);
  const double scheme = dice.between(0.0, 1.0);
  if (scheme < 0.6) {
    choose_mls(dice, d);
  } else if (scheme < 0.9) {
    choose_shape(dice, scene);
  } else {
    choose_staggered(dice, scene);
  }
  d.points_per_element = dice.integer(1, 6);
  d.placement = static_cast<Placement>(dice.integer(0, 3));
  d.seed = number;
  if (dice.chance(0.15)) d.empty_elements = {dice.between(0.02, 0.08)};
  if (d.scheme == Scheme::galerkin && d.transfer != TransferName::apic && dice.chance(0.2)) {
    if (dice.chance(0.5)) {
      scene.time.xpic_order = dice.integer(2, 4);
    } else {
      scene.time.flip = dice.between(0.9, 1.0);
    }
  }
  scene.time.end = 1e-5;
  return scene;
}

std::string described(const Case& scene) {
  const Discretization& d = scene.discretization;
  const Material& m = scene.problem.material;
  const std::string how = d.scheme == Scheme::staggered4
                              ? fmt::format("staggered4 (time order {})", scene.time.order)
                              : std::string(transfer_names[static_cast<std::size_t>(d.transfer)]);
  const std::string update = scene.time.xpic_order > 0
                                 ? fmt::format("xpic {}", scene.time.xpic_order)
                                 : fmt::format("flip {:.3g}", scene.time.flip);
  return fmt::format(
      "{} {} radius {:.3g}{} order {}{}, {} x {} {}{}, {}, {} to {}, kappa {:.1e}, E/K_f {:.1e}",
      how, kernel_word(d), d.support_radius, d.adaptive_support ? " adaptive" : "", d.basis_order,
      d.strain == Strain::recovered ? " recovered" : "", d.elements, d.points_per_element,
      solver::name(d.placement), d.empty_elements.empty() ? "" : " gap", update,
      porowave::name(scene.problem.column.near), porowave::name(scene.problem.column.far),
      m.intrinsic_permeability, m.constrained_modulus / m.fluid_bulk_modulus);
}

}  // namespace porowave::verification
