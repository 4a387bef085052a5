/// The physical model of 2.2 as a plain ordinary differential equation, written down apart from
/// reduced_models/: Park-Wen friction, N with the vertical inertia, the `signed` rim law as a branch of the
/// right-hand side, no events. What any integrator of a library can be given. SI units.
#pragma once
#include "scene/scene.h"
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rimpact::work_precision {

using OdeState = std::array<double, 6>; ///< x, y, v_x, v_y, eta_x, eta_y

struct Problem {
  std::string name;
  double R0, a, mass, weight, mu, elastic_slip, k_i, c_i, lateral_capacity;
  double duration, output_step;
  scene::Excitation excitation;
  double gravity;

  /// From a scene on the ellipse with constant friction.
  Problem(const std::string &name, const scene::Scene &scene);
  void rhs(const scene::GroundMotion &ground, double t, const double *y, double *dy) const;
  /// Everything a peer in another language needs.
  nlohmann::json to_json() const;
};

/// Displacements at the output instants [m], and the processor time it took [s].
struct Solution {
  std::vector<double> x, y;
  double seconds;
};

/// SUNDIALS CVODE (BDF, dense Newton) on `problem`: relative tolerance `tolerance`, steps at most 10 ms.
Solution plain_cvode(const Problem &problem, double tolerance);

} // namespace rimpact::work_precision
