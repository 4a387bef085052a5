/// What `check` says of a scene's own mesh. Two definitions: the light program has no gmsh and becomes the
/// finite-element one, which reads the mesh.
#pragma once
#include "app/console/console.h"
#include "fe_contact/planning/plan.h"
#include "meshes/hex_mesh.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

struct MeshCheck {
  std::string sentence;
  nlohmann::json table;
};
/// Keys of a mesh's quality; defined in the finite-element program alone.
nlohmann::json quality_table(const std::string &file, const meshes::MeshQuality &quality);
/// Throws DataError for a mesh that does not fit bearing or rung.
MeshCheck check_own_mesh(const scene::Scene &scene, const planning::Plan &plan, const Console &console);

} // namespace rimpact::app
