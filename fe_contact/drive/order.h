/// What a scene and its plan ask of a rung: its mesh, its model, the tolerances of its steps.
#pragma once
#include "fe_contact/planning/plan.h"
#include "fe_contact/rungs/bearing_model.h"
#include "fe_contact/rungs/catalogue.h"
#include "scene/scene.h"

namespace rimpact::fe {

meshes::MeshOrder mesh_order(const scene::Scene &scene, const planning::Plan &plan);
ModelOptions model_options(const scene::Scene &scene);
/// The rung's own, with the scene's damping of the time stepping.
StepOptions step_options(const Rung &rung, const scene::Scene &scene);
/// Those of steps in time: the shortest ones renew the multipliers by their share only.
StepOptions step_options(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan);

} // namespace rimpact::fe
