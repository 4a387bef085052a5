/// The two files of a new case folder.
#pragma once
#include <string>

namespace rimpact::scene {

struct CaseFiles {
  std::string bearing, scene; ///< texts of bearing.toml and scene.toml; no bearing of a scene of rigid bodies
};
/// From a bearing (a built-in one's name or a file) and a built-in scene. `name`: what the bearing is called from now
/// on. A scene of rigid bodies has its own in [isolator] and takes neither. The scene has a [load], its mass left to
/// follow from the weight where the two say the same, and every key of [reduced] and of its kind of [excitation]; those
/// it leaves to their defaults are commented out.
CaseFiles new_case(const std::string &name, const std::string &bearing, const std::string &scene);

} // namespace rimpact::scene
