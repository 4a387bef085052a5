/// The built-in scenes: commented TOML, as `rimpact new` writes it.
#pragma once
#include <string>

namespace rimpact::scene {

struct BuiltinScene {
  std::string name, text;
  std::string needs = {}; ///< what the user must bring, said when it is missing
};
/// What to bring for a scene under a record of PEER's.
std::string needs_record(const std::string &scene, const std::string &record, const std::string &file);
/// nullptr when there is none of that name.
const BuiltinScene *find_builtin_scene(const std::string &name);

} // namespace rimpact::scene
