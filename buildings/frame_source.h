/// What `rimpact building --frame` names: a built-in building, a TOML file of a regular one, or a folder of tables.
#pragma once
#include "buildings/frame.h"
#include "scene/scene.h"

namespace rimpact::buildings {

/// Throws InputError for a bad building file, DataError for bad tables, each with file and line, and what
/// Frame::validate throws.
Frame load_frame(const std::string &where);

/// A bearing as a frame names it: its file beside the frame, in `folder`, or in the current folder, by its absolute
/// name, so that a stored frame is read from anywhere; what is no file is a name.
std::string bearing_named(const std::string &name, const std::string &folder);

/// The bearing under each supported node, in the nodes' order, as the scene it would have alone: its own in place of
/// the scene's. A node names "dcfp", "lir-dcfp" or "tfp" (of the scene's [isolator]), or an isolator of the catalogue.
/// Or a scene's TOML file with [isolator], whose [isolator] and [reduced] it then has; or a dish by name or file.
/// Throws InputError.
std::vector<scene::Scene> bearings_of(const Frame &frame, const scene::Scene &scene);

/// What a building reads of the scene's [isolator] where the scene itself is one of a dish.
struct IsolatorUse {
  bool springs; ///< the dishes stand on them: an inelastic frame, or one with bearings of rigid bodies
  bool whole;   ///< a node names a model or an isolator of the catalogue
};
IsolatorUse isolator_use(const Frame &frame);

} // namespace rimpact::buildings
