#include "app/verbs/library_versions.h"

namespace rimpact::app {

LibraryVersions library_versions() {
  return {{{"finite elements", "none"}}, ""};
}

} // namespace rimpact::app
