/// Which physics the program holds.
#pragma once
#include <string>

namespace rimpact {

/// Of the sources of scene/, reduced_models/, meshes/ and fe_contact/: another one may give another result.
const std::string &physics_version();

} // namespace rimpact
