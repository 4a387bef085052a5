// rimpact new DIR: a commented case folder.
#include "app/verbs/catalogue.h"
#include "io/files/file.h"
#include "responses/response.h"
#include "scene/new_case.h"
#include "scene/scene.h"
#include <filesystem>
#include <fmt/format.h>
#include <utility>
#include <vector>

namespace rimpact::app {
namespace {

/// The bearing is called as its folder.
std::string name_of(const std::string &folder) {
  const auto path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

void add_new(CLI::App &verb, Console &console) {
  struct NewOptions {
    std::string folder, bearing, scene = "ricker-0.78g-1.0s";
  };
  auto options = std::make_shared<NewOptions>();
  verb.add_option("DIR", options->folder, "the folder to make")->required();
  verb.add_option("--bearing", options->bearing, "a built-in bearing, shfps-225 where none is named");
  verb.add_option("--scene", options->scene, "a built-in scene");
  console.add_common(verb);
  verb.callback([options, &console] {
    const std::string bearing = options->bearing.empty() ? "shfps-225" : options->bearing;
    const auto files = scene::new_case(name_of(options->folder), bearing, options->scene);
    if (files.bearing.empty() && !options->bearing.empty())
      throw InputError(fmt::format("--bearing {}: the bearing of scene {} is of rigid bodies, in its [isolator]",
                                   options->bearing, options->scene));
    std::error_code error;
    std::filesystem::create_directories(options->folder, error);
    std::vector<std::pair<std::string, std::string>> texts{{options->folder + "/scene.toml", files.scene}};
    if (!files.bearing.empty()) texts.emplace_back(options->folder + "/bearing.toml", files.bearing);
    for (const auto &[path, text] : texts)
      if (std::filesystem::exists(path)) throw InputError(path + " exists already; choose another folder");
    for (const auto &[path, text] : texts) write_atomically(text, path);
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
                     .help = "a commented case folder: bearing.toml, scene.toml; of rigid bodies scene.toml alone",
                     .examples = "rimpact new my-case\nrimpact new my-case --scene impact-window"},
                    add_new};

} // namespace rimpact::app
