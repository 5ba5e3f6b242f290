// A column solved by moving least squares with random points, and its error.
#include <iostream>

#include "verification/run.hpp"

using namespace porowave;

int main() {
  solver::Case scene;
  scene.problem.material = {0.4, 2650.0, 1000.0, 5.0e9, 2.2e9, 1.0e-11, 1.0e-3};
  scene.problem.column = {0.1, NearEnd::drained_traction, FarEnd::rigid_sealed};
  scene.problem.load = Load(LoadShape::smooth_ramp, 1.0, 1.0e-5);  // Pa, s
  scene.discretization.elements = 400;
  scene.discretization.placement = solver::Placement::stratified;
  scene.discretization.strain = solver::Strain::recovered;
  scene.time.end = 4.0e-5;  // s

  const auto exact = verification::reference_profile(scene);
  const auto run = verification::run_case(scene, *exact);
  if (run.breakdown) return 4;
  const double error = run.errors[0].field.l2;
  std::cout << "relative L2 error of effective stress: " << error << '\n';
  return error < 2.0e-3 ? 0 : 1;
}
