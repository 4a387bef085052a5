/// What `version` says of libraries. Two definitions: the light program answers where there is no finite-element one.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace rimpact::app {

struct LibraryVersions {
  std::vector<std::pair<std::string, std::string>> rows; ///< name, version
  std::string warning;                                   ///< "": none
};
LibraryVersions library_versions();

} // namespace rimpact::app
