/// The reduced models a scene may name (reduced.model). A new model is one file and one line in simulate.cc.
#pragma once
#include "reduced_models/physical_model.h"

namespace rimpact::reduced {

struct ReducedModel {
  std::string name, description;
  ReducedRun (*simulate)(const scene::Scene &scene);
};
const std::vector<ReducedModel> &reduced_models();
/// Throws InputError naming the known models.
const ReducedModel &reduced_model(const std::string &name);

} // namespace rimpact::reduced
