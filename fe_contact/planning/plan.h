/// The plan of a finite-element run, made from the scout (the reduced model) before anything is solved
/// (docs/guide/finite-elements.md): symmetric half or whole, which arcs of the rim take part, steps, expected time and
/// memory.
#pragma once
#include "scene/scene.h"
#include <nlohmann/json.hpp>
#include <optional>

namespace rimpact::planning {

/// Longest step at rest, where only the shaking's inertia forces change [s].
constexpr double longest_resting_step = 0.05;

/// An expected meeting of slider and rim, from the scout.
struct ExpectedImpact {
  double touch_time;     ///< [s]
  double direction_deg;  ///< of the contact on the rim
  double approach_speed; ///< [m/s], radial
  double tangential_speed;
};

struct Plan {
  scene::Rung rung = scene::Rung::rim;
  long expected_steps = 0;    ///< of rungs rigid-dish and full
  double moves_from = 0;      ///< the scout sees no sliding before [s]
  double rests_from = 0;      ///< the scout sees no sliding any more [s]; 0: no motion to scout
  bool moves_in_time = true;  ///< false: a quasi-static path
  bool half = true;           ///< symmetric half about each arc's plane
  bool rim_takes_part = true; ///< the scout sees a touch, or comes within `margin` of it
  double closest_gap = 0.0;   ///< smallest gap of the scout [m]
  std::vector<ExpectedImpact> impacts;
  std::vector<double> sectors{
      0}; ///< where slider and rim may meet and are meshed for it, rungs rigid-dish and full [rad]
  double sector_half_angle = 1.0; ///< meshed on either side of each [rad]
  double step_in_contact = 1e-3;  ///< longest step in contact [s]; the error control shortens it
  int mesh = 1;
  long expected_dofs = 0;
  double expected_seconds = 0, expected_memory_bytes = 0;
  double expected_iterations = 0;  ///< of Newton
  double fastest = 0, slowest = 0; ///< [s], range of expected_seconds
  bool timed_here = false;         ///< by runs of this kind on this machine
  std::vector<std::string> notes;  ///< sentences for the user: pad pressure, grazing, critical amplitude ...
};
Plan make_plan(const scene::Scene &scene);
std::string describe(const Plan &plan); ///< as printed by `check` and before a run
nlohmann::json to_json(const Plan &plan);

} // namespace rimpact::planning
