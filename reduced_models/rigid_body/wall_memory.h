/// What impacts have left on all rims and stops of a bearing of several bodies, where its rim yields.
#pragma once
#include "reduced_models/rigid_body/rim_memory.h"
#include "reduced_models/rigid_body/stepper.h"

namespace rimpact::reduced::rigid {

class WallMemory {
public:
  /// After an accepted step: dents grow where walls are pressed, and the system learns what its contacts meet next.
  void press(System &system, const MotionState &state);

private:
  std::vector<RimMemory> dents_; ///< of each contact
};

} // namespace rimpact::reduced::rigid
