#pragma once

namespace porowave {

class TomlDocument;

/// Saturated porous material of the two-velocity (v_s, v_f) form; SI units.
/// Grains are incompressible, the fluid is linearly compressible, the porosity is constant.
struct Material {
  double porosity = 0.0;                ///< n_f, in (0, 1)
  double grain_density = 0.0;           ///< rho_s, kg/m^3
  double fluid_density = 0.0;           ///< rho_f, kg/m^3
  double constrained_modulus = 0.0;     ///< E_oed = lambda + 2G, Pa
  double fluid_bulk_modulus = 0.0;      ///< K_f, Pa
  double intrinsic_permeability = 0.0;  ///< kappa, m^2
  double fluid_viscosity = 0.0;         ///< mu, Pa s

  double solid_fraction() const { return 1.0 - porosity; }  ///< n_s
  /// n_s rho_s, kg of solid in a m^3 of mixture
  double solid_partial_density() const { return solid_fraction() * grain_density; }
  /// n_f rho_f, kg of fluid in a m^3 of mixture
  double fluid_partial_density() const { return porosity * fluid_density; }
  double mixture_density() const { return solid_partial_density() + fluid_partial_density(); }
  /// K = K_f/n_f, Pa: pressure rise per unit of mixture volume squeezed out of both phases
  double storage_modulus() const { return fluid_bulk_modulus / porosity; }
  /// d = n_f^2 mu/kappa, N s/m^4: Darcy drag per unit of relative velocity
  double drag() const { return porosity * porosity * fluid_viscosity / intrinsic_permeability; }
  /// d (1/(n_s rho_s) + 1/(n_f rho_f)), 1/s: rate at which drag levels the two velocities
  double relaxation_rate() const;
  /// sqrt((E_oed + K_f/n_f)/rho), m/s: one wave, both phases moving together
  double undrained_speed() const;
};

/// Frozen (high-frequency) speeds of the two compression waves.
struct WaveSpeeds {
  double p1;  ///< fast wave, m/s
  double p2;  ///< slow wave, m/s
};

/// c_k from the generalised eigenvalues of D r = (1/c^2) A r; the equations of
/// motion without drag (Verruijt 2010, chapter on waves in saturated soil).
WaveSpeeds wave_speeds(const Material& material);

/// Reads [material]; every value must be positive, the porosity inside (0, 1).
Material read_material(const TomlDocument& document);

}  // namespace porowave
