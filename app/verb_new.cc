// rimpact new DIR: a commented case folder.
#include "app/verb.h"
#include "scene/response.h"
#include "scene/scene.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {

void add_new(CLI::App &app, Console &console) {
  struct Options {
    std::string folder, bearing = "shfps-225", scene = "ricker-0.78g-1.0s";
  };
  auto *verb = app.add_subcommand("new", "a commented case folder: bearing.toml, scene.toml");
  auto options = std::make_shared<Options>();
  verb->add_option("DIR", options->folder, "the folder to make")->required();
  verb->add_option("--bearing", options->bearing, "a built-in bearing");
  verb->add_option("--scene", options->scene, "a built-in scene");
  console.add_common(*verb);
  verb->callback([options, &console] {
    const std::string bearing = scene::to_toml(scene::load_bearing(options->bearing));
    std::string text = scene::builtin_scene_text(options->scene);
    const std::string place = "name = \"shfps-225\"";
    if (const auto at = text.find(place); at != std::string::npos)
      text.replace(at, place.size(), "file = \"bearing.toml\"");
    else
      text = "[bearing]\nfile = \"bearing.toml\"\n\n" + text;
    std::error_code error;
    std::filesystem::create_directories(options->folder, error);
    for (const char *name : {"bearing.toml", "scene.toml"})
      if (std::filesystem::exists(options->folder + "/" + name))
        throw InputError(options->folder + "/" + name + " exists already; choose another folder");
    scene::write_text(bearing, options->folder + "/bearing.toml");
    scene::write_text(text, options->folder + "/scene.toml");
    scene::load_scene(options->folder + "/scene.toml"); // what was written can be read
    console.message(fmt::format("next: rimpact check {0}/scene.toml; rimpact run {0}/scene.toml -o {0}/run",
                                options->folder));
    console.data(options->folder + "/scene.toml\n");
  });
}

} // namespace rimpact::app
