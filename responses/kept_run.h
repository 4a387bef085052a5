/// What a folder holds from an earlier run, and whether that is a result of the scene at hand.
#pragma once
#include "responses/identity.h"
#include <nlohmann/json.hpp>
#include <string>

namespace rimpact {

struct KeptRun {
  bool any = false; ///< there is a result or a checkpoint
  bool finite_elements = false;
  std::string status;      ///< done | stopped | interrupted, whatever the run was of; empty: none that can be read
  bool other_name = false; ///< its scene has another name: it is not the same one edited
  std::string other_scene; ///< keys in which its scene differs, as scene_differences says them; empty: the same scene
  std::string
      changed; ///< why else it is no result of the scene now, e.g. "the file q.AT2 changed since"; empty: it is one
  bool same_program = false; ///< as physics_version() says
  /// Of this very scene, with the same files, by the same program.
  bool is_current() const { return any && other_scene.empty() && changed.empty(); }
};
/// `program`: the physics_version() of the program that would run the scene.
KeptRun kept_run(const std::string &folder, const scene::Scene &scene, const std::string &program = physics_version());

/// A run folder's summary.json; an empty object where there is none. Throws DataError, naming file and key, where it is
/// damaged or a value has another type than INTERFACE says.
nlohmann::json read_summary(const std::string &folder);

/// What another kind of result stands in the folder, e.g. "a sweep"; empty: none, or a run.
std::string collection_in(const std::string &folder);

/// Removes what runs leave (results, checkpoint, fields, pictures, report), but for scene.toml, which may be what is
/// run; other files stay. Throws IoError.
void remove_run(const std::string &folder);
/// Removes what a new run of the same scene would not write anew, or not at once: checkpoint, fields, pictures, report.
void remove_by_products(const std::string &folder);

} // namespace rimpact
