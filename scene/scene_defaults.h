/// Defaults of a scene that follow from its other keys.
#pragma once
#include "io/files/toml_reader.h"
#include "scene/keys.h"

namespace rimpact::scene {

/// Fills what the file leaves out and follows from what it gives: the mass from the weight or the weight from the mass,
/// an excitation's centre and duration, friction. Adds to the scene's remarks what no key gave and an engineer must
/// know. `own_bearing`: the bearing is from a file of someone's own, not a built-in one with changes.
void set_dependent_defaults(const TomlFile &file, bool own_bearing, Scene &scene);

/// Of a bearing whose keys stand behind `prefix`: materials' keys that hang together, a sphere's half-width, the
/// socket's radius where the default does not fit the slider. Throws InputError.
void set_dependent_defaults(const TomlFile &file, const std::string &prefix, Bearing &bearing);

} // namespace rimpact::scene
