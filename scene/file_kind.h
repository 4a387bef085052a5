/// One kind of TOML file given where another is wanted. All throw InputError with what to do instead.
#pragma once
#include "io/files/toml_reader.h"
#include "scene/keys.h"

namespace rimpact::scene {

/// Refuses a bearing file read as a scene, a bearing's tables among a scene's, and `bearing = "bearing.toml"`.
void require_scene(const TomlFile &file);
/// Refuses a scene read as a bearing file.
void require_bearing(const TomlFile &file);
/// Refuses a scene, or a bearing, where a run is wanted (a run folder or a mapping file).
void require_run(const TomlFile &file);

} // namespace rimpact::scene
