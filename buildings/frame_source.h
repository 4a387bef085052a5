/// What `rimpact building --frame` names: a built-in building, a TOML file of a regular one, or a folder of tables.
#pragma once
#include "buildings/frame.h"
#include "scene/scene.h"

namespace rimpact::buildings {

/// Throws InputError for a bad building file, DataError for bad tables, each with file and line.
Frame load_frame(const std::string &where);

/// The bearing under each supported node, in the nodes' order: its own, or the scene's. Throws InputError.
std::vector<scene::Bearing> bearings_of(const Frame &frame, const scene::Scene &scene);

} // namespace rimpact::buildings
