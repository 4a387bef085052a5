// The one unit that is compiled anew when any source that shapes a result has changed.
#include "responses/physics_version.h"
#include "responses/physics_hash.h"

namespace rimpact {

const std::string &physics_version() {
  static const std::string version = RIMPACT_PHYSICS;
  return version;
}

} // namespace rimpact
