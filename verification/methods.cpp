#include "verification/methods.hpp"

#include <fmt/format.h>

namespace porowave::verification {

namespace {

using solver::Case;
using solver::Scheme;
using solver::Strain;
using solver::TransferName;

Method shape_method(Case scene, TransferName transfer, std::string_view kernel) {
  solver::Discretization& d = scene.discretization;
  d.scheme = Scheme::galerkin;
  d.transfer = transfer;
  d.shape = *solver::shape_from_name(kernel);
  d.kernel = solver::kernel_from_name(kernel).value_or(solver::kernel_name<solver::BSpline1>);
  d.support_radius = solver::visit_shape(d.shape, [](auto s) { return decltype(s)::reach(0.0); });
  d.basis_order = 0;
  d.strain = Strain::cell;
  if (transfer == TransferName::apic) scene.time.flip = 0.0;
  const auto word = solver::transfer_names[static_cast<std::size_t>(transfer)];
  return {fmt::format("{} {}", word, kernel), scene};
}

Method mls_method(Case scene, std::string_view kernel, Strain strain) {
  solver::Discretization& d = scene.discretization;
  d.scheme = Scheme::galerkin;
  d.transfer = TransferName::mls;
  d.kernel = *solver::kernel_from_name(kernel);
  d.support_radius = solver::natural_radius(d.kernel);
  d.basis_order = 1;
  d.strain = strain;
  return {fmt::format("mls {}{}", kernel, strain == Strain::recovered ? ", recovered" : ""), scene};
}

Method staggered_method(Case scene, int basis_order, int time_order) {
  solver::Discretization& d = scene.discretization;
  d.scheme = Scheme::staggered4;
  d.transfer = TransferName::mls;
  d.kernel = solver::kernel_name<solver::WendlandC2>;
  d.basis_order = basis_order;
  d.support_radius = basis_order == 3 ? 2.5 : 2.0;
  d.strain = Strain::cell;
  scene.time.order = time_order;
  return {fmt::format("staggered4 basis {}, time {}", basis_order, time_order), scene};
}

}  // namespace

std::vector<Method> every_method(const Case& column) {
  std::vector<Method> methods;
  for (const auto kernel : solver::shape_names()) {
    methods.push_back(shape_method(column, TransferName::shape, kernel));
  }
  for (const auto kernel : {"bspline1", "bspline2", "bspline3"}) {
    methods.push_back(shape_method(column, TransferName::apic, kernel));
  }
  for (const Strain strain : {Strain::cell, Strain::recovered}) {
    for (const auto kernel : solver::kernel_names()) {
      methods.push_back(mls_method(column, kernel, strain));
    }
  }
  for (const int basis_order : {2, 3}) {
    for (const int time_order : {2, 4}) {
      methods.push_back(staggered_method(column, basis_order, time_order));
    }
  }
  return methods;
}

}  // namespace porowave::verification
