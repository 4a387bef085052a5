/// What `rimpact main` is asked about: a bearing under its load, and where each of them comes from.
#pragma once
#include "scene/scene.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

struct MainTarget {
  scene::Scene scene;                   ///< its bearing, load, [model] and [reduced]; its motion is not run
  std::string bearing_from;             ///< "own/bearing.toml", "built-in", ...
  std::string vertical_from, mass_from; ///< "own/scene.toml:5:15", "--set load.mass_kg=...", "default"
  std::vector<std::string> remarks;     ///< what of the scene is not run
  std::vector<std::string> warnings;    ///< a load that nobody gave

  nlohmann::json bearing_json() const;
  nlohmann::json load_json() const;
  std::string head() const; ///< two lines: bearing and load with their numbers and origins
};

/// `where`: a built-in bearing or scene, a bearing or scene file, or a case folder of `rimpact new`; `overrides` as
/// --set of a scene. A scene has [bearing], [load], [excitation], [model] or [reduced]; a bearing [surface], [slider],
/// [rim] and so on. A bearing under an override is parsed as the scene that names it. The rung is `rim` unless the file
/// or an override asks for another. Throws InputError for a file that is both or neither, for a motion given by --set,
/// for a double concave bearing and a building.
MainTarget main_target(const std::string &where, const std::vector<std::string> &overrides);

} // namespace rimpact::app
