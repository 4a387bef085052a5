/// Scenes the tests of the double concave models start from.
#pragma once
#include "reduced_models/bearings/physical_model.h"
#include <cmath>

namespace rimpact::reduced::testing {

using scene::ExcitationKind;

/// Appendix B's specimen: R 0.75 m, slider 85 mm high, C_t 0.175 m, W 150 kN; its slider as good as
/// weightless.
inline scene::Scene specimen(scene::ModelKind model = scene::ModelKind::lir_dcfp) {
  scene::Scene s;
  s.reduced.model = model;
  s.load.vertical = 150e3, s.load.mass = 150e3 / 9.81;
  s.isolator.radius = 0.75, s.isolator.capacity = 0.175;
  s.isolator.slider_diameter = 0.14, s.isolator.top_height = 0.045, s.isolator.bottom_height = 0.040;
  s.isolator.top_wall = 0.030, s.isolator.bottom_wall = 0.010;
  s.isolator.slider_mass = 0.01, s.isolator.mu_interface = 0.126;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.066;
  s.reduced.k_i = 1e10;
  return s;
}

inline scene::Scene cyclic(scene::Scene s, double amplitude, double cycles = 1) {
  s.excitation.kind = ExcitationKind::cyclic;
  s.excitation.amplitude = amplitude, s.excitation.cycles = cycles;
  return s;
}

/// 200 t under a Ricker pulse of 1.5 s.
inline scene::Scene shaken(scene::ModelKind model, double amplitude_g) {
  scene::Scene s;
  s.reduced.model = model;
  s.reduced.mu_fast = s.reduced.mu_slow = 0.05;
  s.load.mass = 2e5, s.load.vertical = s.load.mass * s.load.gravity;
  s.excitation.amplitude_g = amplitude_g, s.excitation.period = 1.5, s.excitation.centre = 3;
  return s;
}

/// The same on a slider higher than it is wide.
inline scene::Scene slender(double amplitude_g, double rim_height) {
  scene::Scene s = shaken(scene::ModelKind::dcfp, amplitude_g);
  s.isolator.slider_diameter = 0.15, s.isolator.top_height = s.isolator.bottom_height = 0.12;
  s.isolator.rim_height = rim_height;
  return s;
}

/// The same under a vertical acceleration above g.
inline scene::Scene lifted() {
  scene::Scene s = shaken(scene::ModelKind::lir_dcfp, 0.3);
  s.excitation.kind = ExcitationKind::record;
  s.excitation.x = {0.01, {}}, s.excitation.z = {0.01, {}};
  for (int i = 0; i < 150; ++i) {
    s.excitation.x.values.push_back(1.0 * std::sin(4 * i * 0.01));
    s.excitation.z.values.push_back(11.5 * std::sin(20 * i * 0.01));
  }
  s.excitation.duration = 1.5;
  s.isolator.step_tolerance = 1e-6; // landings
  return s;
}

} // namespace rimpact::reduced::testing
