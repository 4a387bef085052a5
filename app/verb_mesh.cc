// rimpact mesh BEARING -o FILE.msh
#include "app/sibling.h"
#include "app/verb.h"
#include "meshes/rim_mesh.h"
#include "scene/scene.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rimpact::app {

void add_mesh(CLI::App &app, Console &console) {
  struct Options {
    std::string bearing = "shfps-225", file, picture;
    int level = 1;
    bool whole = false;
  };
  auto *verb = app.add_subcommand("mesh", "mesh the rim sector and the slider of a bearing");
  auto options = std::make_shared<Options>();
  verb->add_option("BEARING", options->bearing, "a TOML file or a built-in bearing");
  verb->add_option("-o,--output", options->file, "the .msh file to write")->required();
  verb->add_option("--png", options->picture, "a picture of the mesh");
  verb->add_option("--mesh", options->level, "1 | 2 | 3; 0: a draft")->check(CLI::Range(0, 3));
  verb->add_flag("--whole", options->whole, "not just the symmetric half");
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([options, &console] {
    const auto bearing = scene::load_bearing(options->bearing);
    bearing.validate();
    meshes::RimMeshOptions mesh_options;
    mesh_options.level = options->level;
    mesh_options.half = !options->whole;
    const auto mesh = meshes::rim_mesh(bearing, mesh_options);
    const auto q = meshes::quality(mesh);
    meshes::write_msh(mesh, options->file);
    if (!options->picture.empty() && python({"report.mesh_picture", options->file, options->picture}) != 0)
      throw IoError("the picture " + options->picture + " was not made");
    const nlohmann::json table{{"file", options->file},
                               {"cells", q.n_cells},
                               {"nodes", q.n_nodes},
                               {"components", q.n_components},
                               {"min_scaled_jacobian", q.min_scaled_jacobian},
                               {"worst_aspect", q.worst_aspect}};
    console.data(
        console.json
            ? table.dump(2) + "\n"
            : fmt::format(
                  "{}: {} hexahedra, {} nodes, smallest scaled Jacobian {:.3f}, worst aspect {:.1f}\n",
                  options->file, q.n_cells, q.n_nodes, q.min_scaled_jacobian, q.worst_aspect));
  });
}

} // namespace rimpact::app
