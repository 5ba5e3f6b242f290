# A stand-in for your solver: the saturated column by finite differences on a staggered grid.
#
#   n_s rho_s dv_s/dt = ds/dx - n_s dp/dx + d (v_f - v_s)     ds/dt = E dv_s/dx
#   n_f rho_f dv_f/dt =       - n_f dp/dx - d (v_f - v_s)     dp/dt = -(K/n_f) (n_s dv_s/dx + n_f dv_f/dx)
#
# with s the effective stress and d = n_f^2 mu/kappa. Stresses live at the middles of the elements,
# velocities at their ends; velocity Verlet in time, the drag exactly. Second order in both.
# Ends: drained and loaded by a sin^4 pulse at x = 0, rigid and sealed at x = len.

function load(t) {
  return t < duration ? -magnitude * sin(3.14159265358979323846 * t / duration) ^ 4 : 0
}

# Velocities over half a step, by the stresses of time t.
function accelerate(t,    j, ds, dp) {
  for (j = 0; j < elements; ++j) {  # the last velocity stays zero
    ds = j == 0 ? (s[0] - load(t)) / (0.5 * h) : (s[j] - s[j - 1]) / h
    dp = j == 0 ? p[0] / (0.5 * h) : (p[j] - p[j - 1]) / h
    vs[j] += 0.5 * dt * (ds - n_s * dp) / m_s
    vf[j] -= 0.5 * dt * dp / fluid_density
  }
}

# The two velocities approach each other over half a step.
function drag(    j, w) {
  for (j = 0; j < elements; ++j) {
    w = (vf[j] - vs[j]) * (1 - exp(-0.5 * dt * d * (1 / m_s + 1 / m_f)))
    vs[j] += w * m_f / (m_s + m_f)
    vf[j] -= w * m_s / (m_s + m_f)
  }
}

function strain(    i, es, ef) {
  for (i = 0; i < elements; ++i) {
    es = dt * (vs[i + 1] - vs[i]) / h
    ef = dt * (vf[i + 1] - vf[i]) / h
    s[i] += constrained_modulus * es
    p[i] -= fluid_bulk_modulus / n_f * (n_s * es + n_f * ef)
  }
}

BEGIN {
  n_f = porosity
  n_s = 1 - n_f
  m_s = n_s * grain_density
  m_f = n_f * fluid_density
  d = n_f * n_f * fluid_viscosity / intrinsic_permeability
  h = len / elements

  # The fast wave without drag limits the time step.
  trace = (constrained_modulus + n_s * n_s * fluid_bulk_modulus / n_f) / m_s \
          + n_f * fluid_bulk_modulus / m_f
  det = constrained_modulus * n_f * fluid_bulk_modulus / (m_s * m_f)
  c1 = sqrt(0.5 * (trace + sqrt(trace * trace - 4 * det)))
  steps = int(end * c1 / (courant * h)) + 1
  dt = end / steps

  for (i = 0; i < elements; ++i) s[i] = p[i] = 0
  for (j = 0; j <= elements; ++j) vs[j] = vf[j] = 0
  for (k = 0; k < steps; ++k) {
    accelerate(k * dt)
    drag()
    strain()
    drag()
    accelerate((k + 1) * dt)
  }

  print "x,volume,effective_stress,pore_pressure,solid_velocity,fluid_velocity"
  for (i = 0; i < elements; ++i) {
    printf "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", (i + 0.5) * h, h, s[i], p[i],
           0.5 * (vs[i] + vs[i + 1]), 0.5 * (vf[i] + vf[i + 1])
  }
}
