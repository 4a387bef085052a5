#include "app/jobs/mesh_check.h"
#include "fe_contact/drive/run.h"
#include <fmt/format.h>

namespace rimpact::app {

nlohmann::json quality_table(const std::string &file, const meshes::MeshQuality &q) {
  return {{"file", file},
          {"cells", q.n_cells},
          {"nodes", q.n_nodes},
          {"components", q.n_components},
          {"min_scaled_jacobian", q.min_scaled_jacobian},
          {"worst_aspect", q.worst_aspect}};
}

MeshCheck check_own_mesh(const scene::Scene &scene, const planning::Plan &plan, const Console &) {
  const auto q = meshes::quality(fe::mesh_of(scene, plan));
  return {fmt::format("own mesh {}: {} hexahedra, {} nodes in {} pieces, smallest scaled Jacobian {:.3f}, worst aspect "
                      "{:.1f}; it fits the bearing\n",
                      scene.model.own_mesh.file, q.n_cells, q.n_nodes, q.n_components, q.min_scaled_jacobian,
                      q.worst_aspect),
          quality_table(scene.model.own_mesh.file, q)};
}

} // namespace rimpact::app
