#include "buildings/frame_source.h"
#include "buildings/builtin_buildings.h"
#include "buildings/frame_tables.h"
#include "buildings/plane_frame.h"
#include "buildings/regular_building.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/toml_file.h"
#include "scene/isolator_catalogue.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::buildings {

namespace {
Frame made_at(const std::string &where) {
  const std::string text = building_text(where);
  if (is_plane_frame(text, where)) return make_frame(parse_plane_frame(text, where));
  return make_frame(parse_building(text, where));
}
} // namespace

Frame load_frame(const std::string &where) {
  std::error_code none;
  if (std::filesystem::is_directory(where, none)) return read_tables(where);
  Frame frame = made_at(where);
  frame.validate();
  return frame;
}

std::string bearing_named(const std::string &name, const std::string &folder) {
  namespace fs = std::filesystem;
  std::error_code none;
  for (const auto &path : {fs::path(folder) / name, fs::path(name)})
    if (fs::is_regular_file(path, none)) return fs::absolute(path, none).lexically_normal().string();
  return name;
}

namespace {
bool has_isolator(const std::string &where) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(where, none)) return false;
  return TomlFile(read_file(where), where).find("isolator");
}

/// A triple pendulum of the catalogue, in the scene's space and with its points.
void take_triple(const std::string &name, scene::Scene &s) {
  const scene::Isolator given = s.isolator;
  s.reduced.model = scene::ModelKind::tfp, s.isolator = scene::builtin_isolator(name);
  s.isolator.space = given.space, s.isolator.points = given.points, s.isolator.rim = given.rim;
  s.isolator.step_tolerance = given.step_tolerance;
  s.isolator.inner.own_rims = given.inner.own_rims; // the scene's laws, as its [reduced]
  s.isolator.inner.rims = given.inner.rims;
}

bool is_of_catalogue(const std::string &where) {
  const auto names = scene::builtin_isolator_names();
  return std::find(names.begin(), names.end(), where) != names.end();
}

scene::Scene own_bearing(const std::string &where, const scene::Scene &scene) {
  scene::Scene s = scene;
  const auto model = parse<scene::ModelKind>(where);
  const bool triple = model == scene::ModelKind::tfp && s.isolator.name.empty() && !s.triple();
  if (triple || is_of_catalogue(where)) {
    take_triple(triple ? scene::default_triple : where, s);
  } else if (model && *model != scene::ModelKind::physical) {
    s.reduced.model = *model;
  } else if (has_isolator(where)) {
    const scene::Scene own = scene::load_scene(where);
    s.isolator = own.isolator, s.reduced = own.reduced;
  } else {
    s.reduced.model = scene::ModelKind::physical, s.bearing = scene::load_bearing(where);
  }
  return s;
}
} // namespace

IsolatorUse isolator_use(const Frame &frame) {
  IsolatorUse use{frame.inelastic(), false};
  for (const Node &node : frame.nodes) {
    if (!node.supported || node.bearing.empty()) continue;
    const auto model = parse<scene::ModelKind>(node.bearing);
    const bool by_name = (model && *model != scene::ModelKind::physical) || is_of_catalogue(node.bearing);
    use.whole = use.whole || by_name;
    use.springs = use.springs || by_name || has_isolator(node.bearing);
  }
  return use;
}

std::vector<scene::Scene> bearings_of(const Frame &frame, const scene::Scene &scene) {
  std::vector<scene::Scene> list;
  for (std::size_t i = 0; i < frame.nodes.size(); ++i) {
    const Node &node = frame.nodes[i];
    if (!node.supported) continue;
    try {
      list.push_back(node.bearing.empty() ? scene : own_bearing(node.bearing, scene));
    } catch (const Error &error) {
      throw InputError(fmt::format("the bearing under node {}: {}", i + 1, error.what()));
    }
  }
  return list;
}

} // namespace rimpact::buildings
