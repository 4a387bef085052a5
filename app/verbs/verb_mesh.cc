// rimpact mesh BEARING -o FILE.msh, or of a scene's run
#include "app/console/child_process.h"
#include "app/jobs/given_case.h"
#include "app/jobs/mesh_check.h"
#include "app/verbs/catalogue.h"
#include "app/verbs/fe_verb_texts.h"
#include "app/words/set_keys.h"
#include "fe_contact/drive/run.h"
#include "io/files/json_text.h"
#include "meshes/rim_mesh.h"
#include "meshes/surface_list.h"
#include "responses/identity.h"
#include "scene/scene.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {

namespace {

struct MeshOptions {
  std::string bearing, scene, file, picture, listed;
  bool whole = false, curved = false;
};

/// A bearing alone is meshed for rung `rim`: by its dimensions and the mesh's level.
std::string not_of_a_bearing(const std::string &key) {
  const bool read = is_in(key, "bearing") || key == "model.mesh";
  return read ? "" : "a bearing alone is meshed for rung `rim`; --scene SCENE meshes what a scene's run is solved on";
}

/// The bearing under --set; the rest of the scene around it is not read.
scene::Scene bearing_under_settings(const std::string &bearing, Console &console) {
  scene::load_bearing(bearing); // a scene is refused
  scene::Scene scene = given_case(bearing, console.settings()).scene;
  refuse_unread(console.overrides, "mesh BEARING", not_of_a_bearing);
  std::erase(scene.remarks, scene.load_remark);
  for (const auto &remark : scene.remarks) console.warn(remark);
  return scene;
}

meshes::HexMesh rim_mesh(const MeshOptions &options, Console &console) {
  if (!console.rung.empty())
    throw InputError("--rung " + console.rung + " needs --scene: a bearing alone is meshed for rung `rim`");
  const auto scene = bearing_under_settings(options.bearing.empty() ? "shfps-225" : options.bearing, console);
  meshes::MeshOrder mesh;
  mesh.level = scene.model.mesh;
  mesh.half = !options.whole;
  return meshes::rim_mesh(scene.bearing, mesh);
}

/// `scene`: that of the mesh, as resolved.
meshes::HexMesh scene_mesh(const MeshOptions &options, scene::Scene &scene, Console &console) {
  if (!options.bearing.empty())
    throw InputError(options.bearing + " beside --scene: the mesh is of one of them; --set bearing.file=... gives the "
                                       "scene another bearing");
  if (options.whole) console.overrides.push_back("model.symmetry=\"whole\"");
  scene = console.load(options.scene);
  fe::check_supported(scene);
  return fe::mesh_of(scene, planning::make_plan(scene));
}

/// Which surface of a drawing is which.
void list_drawing(const MeshOptions &options, Console &console) {
  if (!options.bearing.empty() || !options.scene.empty() || !options.file.empty() || !options.picture.empty())
    throw InputError("--surfaces lists a drawing and makes no mesh: it goes with no bearing, --scene, -o or --png");
  const auto bodies = meshes::list_surfaces(options.listed);
  console.data(console.json ? json_text(bodies) : meshes::describe_surfaces(bodies));
}

void make_mesh(const MeshOptions &options, Console &console) {
  if (options.file.empty()) throw InputError("mesh needs -o FILE.msh, or --surfaces FILE to list a drawing");
  if (!console.calibration.empty() || !console.inner_calibration.empty())
    throw InputError("--calibration, --inner-calibration: a mesh has no impact element");
  std::error_code none;
  for (const auto &input : {options.bearing, options.scene})
    if (std::filesystem::equivalent(input, options.file, none))
      throw InputError("-o " + options.file + " would replace what is meshed; choose another file");
  scene::Scene scene;
  const bool of_bearing = options.scene.empty();
  const auto mesh = of_bearing ? rim_mesh(options, console) : scene_mesh(options, scene, console);
  const auto q = meshes::quality(mesh);
  meshes::write_msh(mesh, options.file, options.curved);
  if (!options.picture.empty() && python({"report.mesh_picture", options.file, options.picture}) != 0)
    throw IoError("the picture " + options.picture + " was not made");
  auto table = quality_table(options.file, q);
  if (!of_bearing) table["identity"] = to_json(identity_of(scene));
  table["warnings"] = console.warnings();
  console.data(console.json
                   ? json_text(table)
                   : fmt::format("{}: {} hexahedra, {} nodes, smallest scaled Jacobian {:.3f}, worst aspect {:.1f}\n",
                                 options.file, q.n_cells, q.n_nodes, q.min_scaled_jacobian, q.worst_aspect));
}

void add_mesh(CLI::App &verb, Console &console) {
  auto options = std::make_shared<MeshOptions>();
  verb.add_option("BEARING", options->bearing, "a TOML file or a built-in bearing (default: shfps-225)");
  verb.add_option("--scene", options->scene,
                  "instead: what a scene's run is solved on, by any rung, own meshes included");
  verb.add_option("-o,--output", options->file, "the .msh file to write");
  verb.add_option("--surfaces", options->listed,
                  "instead: list bodies and surfaces of a .step, .geo or .msh with kind, radius and centre");
  verb.add_option("--png", options->picture, "a picture of the mesh");
  verb.add_flag(
      "--curved", options->curved,
      "27-node cells with the exact surfaces, not straight 8-node ones: what [model.own_mesh] takes back as it was");
  verb.add_flag("--whole", options->whole, "not just the symmetric half");
  console.add_common(verb);
  console.add_json(verb);
  console.add_overrides(verb);
  console.add_model(verb);
  verb.callback([options, &console] {
    options->listed.empty() ? make_mesh(*options, console) : list_drawing(*options, console);
  });
}

} // namespace

const Verb mesh_verb{text_of_mesh, add_mesh};

} // namespace rimpact::app
