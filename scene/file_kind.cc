#include "scene/file_kind.h"

#include "io/files/text.h"
#include "scene/bearing_catalogue.h"
#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

constexpr std::array bearing_tables{"surface", "slider", "rim", "plate", "pad", "foot", "material", "contact"};
constexpr std::array scene_tables{"bearing", "load", "excitation", "model", "reduced", "isolator", "superstructure"};

/// The first of the tables that stands at the root of the file itself, whatever was set beside it; null: none.
template <class Names> const char *first_of(const TomlFile &file, const Names &names) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const char *name) {
    const auto *node = file.find(name);
    return node && !file.is_set(name) && node->source().begin.line > 0; // a table that a setting made has no line
  });
  return found == names.end() ? nullptr : *found;
}

} // namespace

void require_scene(const TomlFile &file) {
  if (const auto *bearing = file.find("bearing"); bearing && bearing->is_string()) {
    const std::string given = bearing->as_string()->get();
    const auto names = builtin_bearing_names();
    const bool built_in = std::find(names.begin(), names.end(), given) != names.end();
    throw InputError(fmt::format("{}: bearing must be a table, got the string \"{}\": write the line [bearing] and "
                                 "under it the line {} = \"{}\"",
                                 file.location("bearing"), given.substr(0, 60), built_in ? "name" : "file",
                                 given.substr(0, 200)));
  }
  const auto table = std::find_if(bearing_tables.begin(), bearing_tables.end(),
                                  [&](const char *name) { return file.find(name) != nullptr; });
  if (table == bearing_tables.end()) return;
  const char *own = first_of(file, bearing_tables);
  if (!own || first_of(file, scene_tables))
    throw InputError(
        fmt::format("{}: [{}] is of a bearing: in a scene it is bearing.{}", file.location(*table), *table, *table));
  throw InputError(fmt::format("{0}: this is a bearing file ([{1}]), where a scene is wanted: name it in a scene, "
                               "[bearing] with file = \"{2}\" (rimpact "
                               "new DIR writes one), or give it to rimpact main",
                               file.location(own), own, file.origin()));
}

void require_bearing(const TomlFile &file) {
  const char *table = first_of(file, scene_tables);
  if (!table || first_of(file, bearing_tables)) return;
  const auto *named = file.find("bearing.file");
  throw InputError(
      fmt::format("{}: this is a scene ([{}]), where a bearing is wanted: give {}", file.location(table), table,
                  named && named->is_string() ? "the file it names, " + named->as_string()->get()
                                              : std::string("a built-in bearing's name or the file of its [bearing]")));
}

void require_run(const TomlFile &file) {
  if (!first_of(file, scene_tables) && !first_of(file, bearing_tables)) return;
  const bool is_scene = first_of(file, scene_tables) != nullptr;
  throw InputError(fmt::format("{0}: this is a {1}, where a run is wanted: {2}", file.origin(),
                               is_scene ? "scene" : "bearing file",
                               is_scene ? "run it first, rimpact run " + file.origin() + " -o DIR, and give DIR"
                                        : std::string("run a scene of it first and give the run's folder")));
}

} // namespace rimpact::scene
