/// Keys that a scene's file gives and its run does not read.
#pragma once
#include "io/files/toml_file.h"
#include "scene/scene.h"

namespace rimpact::scene {

/// The remark on a part of the keys. Those of [isolator] beside a dish stand apart, since a building may read them.
enum class UnreadPart { scene, isolator, springs };

/// A remark that names the keys which are given, differ from their defaults and are not read; empty where there are
/// none. They belong to another kind of excitation, dish, model or law, or have no effect by such a choice. Where --set
/// changes the choice, what the file says for the one it replaces is no slip and goes unsaid. To be asked once the
/// scene's defaults are settled.
std::string unread_keys(const TomlFile &file, const Scene &scene, UnreadPart part);

} // namespace rimpact::scene
