// rimpact mesh BEARING -o FILE.msh, or of a scene's run
#include "app/mesh_check.h"
#include "app/sibling.h"
#include "app/verb.h"
#include "fe_contact/drive/run.h"
#include "files/json_text.h"
#include "meshes/rim_mesh.h"
#include "scene/scene.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {

namespace {

struct MeshOptions {
  std::string bearing = "shfps-225", scene, file, picture;
  bool whole = false, curved = false;
};

meshes::HexMesh rim_mesh(const MeshOptions &options, const Console &console) {
  if (!console.rung.empty())
    throw InputError("--rung " + console.rung + " needs --scene: a bearing alone is meshed for rung `rim`");
  const auto bearing = scene::load_bearing(options.bearing);
  meshes::MeshOrder mesh;
  if (console.mesh >= 0) mesh.level = console.mesh;
  mesh.half = !options.whole;
  return meshes::rim_mesh(bearing, mesh);
}

meshes::HexMesh scene_mesh(const MeshOptions &options, Console &console) {
  if (options.whole) console.overrides.push_back("model.symmetry=\"whole\"");
  const scene::Scene scene = console.load(options.scene);
  fe::check_supported(scene);
  return fe::mesh_of(scene, planning::make_plan(scene));
}

} // namespace

void add_mesh(CLI::App &app, Console &console) {
  auto *verb = app.add_subcommand("mesh", "mesh the rim sector and the slider of a bearing");
  auto options = std::make_shared<MeshOptions>();
  verb->add_option("BEARING", options->bearing, "a TOML file or a built-in bearing");
  verb->add_option("--scene", options->scene,
                   "instead: what a scene's run is solved on, by any rung, own meshes included");
  verb->add_option("-o,--output", options->file, "the .msh file to write")->required();
  verb->add_option("--png", options->picture, "a picture of the mesh");
  verb->add_flag(
      "--curved", options->curved,
      "27-node cells with the exact surfaces, not straight 8-node ones: what [model.own_mesh] takes back as it was");
  verb->add_flag("--whole", options->whole, "not just the symmetric half");
  console.add_common(*verb);
  console.add_json(*verb);
  console.add_overrides(*verb);
  console.add_model(*verb);
  verb->callback([options, &console] {
    std::error_code none;
    for (const auto &input : {options->bearing, options->scene})
      if (std::filesystem::equivalent(input, options->file, none))
        throw InputError("-o " + options->file + " would replace what is meshed; choose another file");
    const auto mesh = options->scene.empty() ? rim_mesh(*options, console) : scene_mesh(*options, console);
    const auto q = meshes::quality(mesh);
    meshes::write_msh(mesh, options->file, options->curved);
    if (!options->picture.empty() && python({"report.mesh_picture", options->file, options->picture}) != 0)
      throw IoError("the picture " + options->picture + " was not made");
    console.data(console.json
                     ? json_text(quality_table(options->file, q))
                     : fmt::format("{}: {} hexahedra, {} nodes, smallest scaled Jacobian {:.3f}, worst aspect {:.1f}\n",
                                   options->file, q.n_cells, q.n_nodes, q.min_scaled_jacobian, q.worst_aspect));
  });
}

} // namespace rimpact::app
