/// Scenes the tests of the double concave models start from.
#pragma once
#include "reduced_models/physical_model.h"

namespace rimpact::reduced::testing {

using scene::ExcitationKind;

/// Appendix B's specimen: R 0.75 m, slider 85 mm high, C_t 0.175 m, W 150 kN; its slider as good as
/// weightless.
inline scene::Scene specimen(const std::string &model = "lir-dcfp") {
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

} // namespace rimpact::reduced::testing
