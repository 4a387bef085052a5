/// A linear building on alike bearings by implicit steps, whatever `simulate` would take.
#pragma once
#include "buildings/implicit_run.h"
#include "buildings/linear_structure.h"

namespace rimpact::buildings {

inline Summary by_implicit_steps(const BuildingModel &model, const scene::Scene &s, std::size_t n_bearings) {
  MountedBuilding building(model, s, std::vector<scene::Scene>(n_bearings, s), linear_structure(model, s.load.gravity));
  ImplicitRun run(building, s);
  BuildingRecorder recorder(building, nullptr, s.reduced.output_step);
  run.run(s.excitation.duration, recorder);
  Summary summary;
  recorder.summarise(summary);
  return summary;
}

} // namespace rimpact::buildings
