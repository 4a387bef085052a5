// The one unit that is compiled anew when any source that shapes a result has changed.
#include "scene/identity.h"
#include "scene/physics_hash.h"

namespace rimpact::scene {

const std::string &physics_version() {
  static const std::string version = RIMPACT_PHYSICS;
  return version;
}

} // namespace rimpact::scene
