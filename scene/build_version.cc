#include "scene/build_version.h"
#include "scene/git_hash.h"

namespace rimpact::scene {

std::string build_version() { return "rimpact " RIMPACT_VERSION ", commit " RIMPACT_GIT_HASH; }

} // namespace rimpact::scene
