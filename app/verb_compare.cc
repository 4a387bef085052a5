// rimpact compare A B: metrics between two responses.
#include "app/verb.h"
#include "calibration/metrics.h"
#include "scene/scene.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

/// L_c of a run folder's own scene; a bare file is taken for the default bearing unless --capacity says
/// otherwise.
double capacity_of(const std::string &path, double given) {
  if (given > 0) return given;
  const std::string scene_file = path + "/scene.toml";
  return std::filesystem::exists(scene_file) ? scene::load_scene(scene_file).lateral_capacity()
                                             : scene::builtin_bearing("shfps-225").lateral_capacity();
}

} // namespace

void add_compare(CLI::App &app, Console &console) {
  struct Options {
    std::string reference, candidate;
    double capacity_mm = 0;
  };
  auto *verb = app.add_subcommand("compare", "metrics between two responses (run folder, .h5 or .csv each)");
  auto options = std::make_shared<Options>();
  verb->add_option("A", options->reference, "the reference")->required();
  verb->add_option("B", options->candidate, "what is compared with it")->required();
  verb->add_option("--capacity-mm", options->capacity_mm, "L_c, when A is not a run folder");
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([options, &console] {
    const auto a = scene::read_response(options->reference), b = scene::read_response(options->candidate);
    const auto comparison =
        calibration::compare(a, b, capacity_of(options->reference, 1e-3 * options->capacity_mm));
    const auto table = calibration::to_json(comparison);
    if (console.json) return console.data(table.dump(2) + "\n");
    for (const auto &[name, value] : table.items())
      if (value.is_number())
        console.data(fmt::format("{:26s} {:+.6g}\n", name, value.get<double>()));
      else if (value.is_null())
        console.data(fmt::format("{:26s} -\n", name));
    for (const auto &note : comparison.notes) console.message(note);
  });
}

} // namespace rimpact::app
