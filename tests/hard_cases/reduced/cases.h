/// The hard cases of the reduced model: scenes, and what must come out of them.
#pragma once
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <functional>
#include <string>
#include <vector>

namespace rimpact::hard_cases {

struct Case {
  std::string name;
  scene::Scene scene;
  bool must_be_right = true; ///< false: must end with a status, and a reason when it is not "done"
  /// What is known without integrating, besides agreement with CVODE and the energy balance: a number that
  /// has to vanish within `bound`.
  std::string fact = {};
  std::function<double(const reduced::ReducedRun &)> deviation = {};
  double bound = 0;
};

std::vector<Case> cases();

} // namespace rimpact::hard_cases
