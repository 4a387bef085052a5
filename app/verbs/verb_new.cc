// rimpact new DIR: a commented case folder.
#include "app/verbs/catalogue.h"
#include "io/files/file.h"
#include "responses/response.h"
#include "scene/new_case.h"
#include "scene/scene.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

/// The bearing is called as its folder.
std::string name_of(const std::string &folder) {
  const auto path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

void add_new(CLI::App &verb, Console &console) {
  struct NewOptions {
    std::string folder, bearing = "shfps-225", scene = "ricker-0.78g-1.0s";
  };
  auto options = std::make_shared<NewOptions>();
  verb.add_option("DIR", options->folder, "the folder to make")->required();
  verb.add_option("--bearing", options->bearing, "a built-in bearing");
  verb.add_option("--scene", options->scene, "a built-in scene");
  console.add_common(verb);
  verb.callback([options, &console] {
    const auto files = scene::new_case(name_of(options->folder), options->bearing, options->scene);
    std::error_code error;
    std::filesystem::create_directories(options->folder, error);
    for (const char *name : {"bearing.toml", "scene.toml"})
      if (std::filesystem::exists(options->folder + "/" + name))
        throw InputError(options->folder + "/" + name + " exists already; choose another folder");
    write_atomically(files.bearing, options->folder + "/bearing.toml");
    write_atomically(files.scene, options->folder + "/scene.toml");
    const auto scene = scene::load_scene(options->folder + "/scene.toml"); // what was written can be read
    console.message(scene.rigid_bodies()
                        ? fmt::format("next: rimpact reduced {0}/scene.toml -o {0}/run", options->folder)
                        : fmt::format("next: rimpact check {0}/scene.toml; rimpact run {0}/scene.toml -o {0}/run",
                                      options->folder));
    console.data(options->folder + "/scene.toml\n");
  });
}

} // namespace

const Verb new_verb{{.name = "new",
                     .help = "a commented case folder: bearing.toml, scene.toml",
                     .examples = "rimpact new my-case\nrimpact new my-case --scene impact-window"},
                    add_new};

} // namespace rimpact::app
