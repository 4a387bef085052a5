/// Keys that a scene's file gives and its run does not read.
#pragma once
#include "files/toml_file.h"
#include "scene/scene.h"

namespace rimpact::scene {

/// A remark that names the keys of the settings which are given, differ from their defaults, and belong to another kind
/// of excitation, another model or another law; empty where there are none. Where --set changes such a choice, what the
/// file says for the one it replaces is no slip and goes unsaid.
std::string unread_keys(const TomlFile &file, const Scene &scene);

} // namespace rimpact::scene
