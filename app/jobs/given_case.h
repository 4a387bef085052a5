/// What a verb is given as a bearing, a scene or a case folder: bearing, load and settings, and where each comes from.
#pragma once
#include "scene/scene.h"
#include <nlohmann/json.hpp>

namespace rimpact::app {

struct GivenCase {
  scene::Scene scene;
  std::string origin;                        ///< the file, or the built-in's name
  std::string bearing_from;                  ///< "own/bearing.toml", "built-in", ...
  std::string vertical_from, mass_from;      ///< "own/scene.toml:5:15", "--set load.mass_kg=...", "default: ..."
  bool built_in = false;                     ///< a built-in scene or bearing
  bool has_motion = false, has_rung = false; ///< given by the file or by --set
  std::vector<std::string> warnings;         ///< the scene's remarks, and a load that nobody gave

  nlohmann::json bearing_json() const;
  nlohmann::json load_json() const;
  std::string load_line() const;
  std::string head() const; ///< two lines: bearing and load with their numbers and origins
};

/// `where`: a built-in bearing or scene, a bearing or scene file, or a case folder of `rimpact new`; `overrides` as
/// --set of a scene. A scene has [bearing], [load], [excitation], [model] or [reduced]; a bearing [surface], [slider],
/// [rim] and so on. A bearing under an override is parsed as the scene that names it; without a motion it is a
/// window's. Throws InputError for a file that is both or neither.
GivenCase given_case(const std::string &where, const std::vector<std::string> &overrides);
/// Throws InputError for a scene of rigid bodies, whose bearing [bearing] does not give.
void require_bearing(const scene::Scene &scene, const std::string &verb);

} // namespace rimpact::app
