/// The reduced models a scene may name (reduced.model). A new model is one file and one line in simulate.cc.
#pragma once
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"

namespace rimpact::reduced {

struct ReducedModel {
  scene::ModelKind kind; ///< its word is the name
  std::string description;
  ReducedRun (*simulate)(const scene::Scene &scene);
};
const std::vector<ReducedModel> &reduced_models();
const ReducedModel &reduced_model(scene::ModelKind kind);

} // namespace rimpact::reduced
