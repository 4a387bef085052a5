/// The heat of sliding on the dishes of a bearing of several bodies, where friction goes by it. A step goes by the
/// temperatures that the one before it has left.
#pragma once
#include "laws/friction/sliding_heat.h"
#include "reduced_models/rigid_body/bearing_parts.h"
#include "reduced_models/rigid_body/stepper.h"
#include "scene/scene.h"

namespace rimpact::reduced::rigid {

class HeatMemory {
public:
  /// The steel of every set takes its temperature at the start.
  HeatMemory(const scene::Scene &scene, const Parts &parts, System &system);
  /// After an accepted step to `t`: the steel at each dish's vertex takes the friction of the step's end while the
  /// slider covers it.
  void pass(System &system, const MotionState &state, double t);
  double warmest() const { return warmest_; } ///< so far, of all sets [degrees Celsius]

private:
  bool counts_;
  friction::SlidingHeat heat_;
  std::array<double, max_sets> radius_{}; ///< of each set's sliding face [m]
  double warmest_, until_ = 0;
  std::array<friction::HeatModes, max_sets> modes_{};
};

} // namespace rimpact::reduced::rigid
