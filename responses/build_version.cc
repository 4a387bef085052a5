#include "responses/build_version.h"
#include "responses/git_hash.h"

namespace rimpact {

std::string build_version() {
  return "rimpact " RIMPACT_VERSION ", commit " RIMPACT_GIT_HASH;
}

} // namespace rimpact
