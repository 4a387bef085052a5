/// In what two resolved scenes differ, and whether their responses can be compared all the same.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rimpact::app {

struct Difference {
  std::string key, a, b; ///< as the scene files write them; "-": that scene has no such key
  bool comparable;       ///< a setting of the model; false: another bearing, load or excitation
};

/// Of two scene texts, resolved. Names, marks of assumption and the strain limit are no difference; how long a scene
/// lasts is one that can be compared (metrics are taken over the time that both have). Those that cannot be compared
/// come first.
std::vector<Difference> differences(const std::string &scene_a, const std::string &scene_b);

nlohmann::json to_json(const std::vector<Difference> &differences);

} // namespace rimpact::app
