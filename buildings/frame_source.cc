#include "buildings/frame_source.h"
#include "buildings/frame_tables.h"
#include "buildings/regular_building.h"
#include "files/error.h"
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::buildings {

Frame load_frame(const std::string &where) {
  std::error_code none;
  if (std::filesystem::is_directory(where, none)) return read_tables(where);
  return make_frame(load_building(where));
}

std::vector<scene::Bearing> bearings_of(const Frame &frame, const scene::Scene &scene) {
  std::vector<scene::Bearing> list;
  for (std::size_t i = 0; i < frame.nodes.size(); ++i) {
    const Node &node = frame.nodes[i];
    if (!node.supported) continue;
    try {
      list.push_back(node.bearing.empty() ? scene.bearing : scene::load_bearing(node.bearing));
    } catch (const Error &error) {
      throw InputError(fmt::format("the bearing under node {}: {}", i + 1, error.what()));
    }
  }
  return list;
}

} // namespace rimpact::buildings
