#include "app/verbs/library_versions.h"
#include "fe_contact/drive/run.h"
#include "fe_contact/drive/versions.h"

namespace rimpact::app {

LibraryVersions library_versions() {
  return {fe::component_versions(), fe::blas_warning()};
}

} // namespace rimpact::app
