/// The buildings that are built in, one entry each.
#pragma once
#include <string>
#include <vector>

namespace rimpact::buildings {

struct BuiltinBuilding {
  std::string name;
  std::string toml; ///< as a file of the user's would say it
};
const std::vector<BuiltinBuilding> &builtin_buildings();

/// Of a built-in building or a file. Throws InputError where there is neither.
std::string building_text(const std::string &where);

} // namespace rimpact::buildings
