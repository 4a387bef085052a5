/// What a folder holds from an earlier run, and whether that is a result of the scene at hand.
#pragma once
#include "responses/choices.h"
#include "responses/identity.h"
#include "responses/physics_version.h"
#include <nlohmann/json.hpp>
#include <string>

namespace rimpact {

struct KeptRun {
  bool any = false; ///< there is a result or a checkpoint
  bool finite_elements = false;
  std::optional<RunStatus> status; ///< whatever the run was of; empty: none that can be read
  bool killed = false;             ///< it has a checkpoint and no summary
  bool other_name = false;         ///< its scene has another name: it is not the same one edited
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
/// damaged or a value has another type than docs/interface.md says.
nlohmann::json read_summary(const std::string &folder);

/// A text of a folder's summary.json. Throws DataError where the key holds something else.
std::string text_in(const nlohmann::json &summary, const char *key, const std::string &folder);
[[noreturn]] void refuse_word(const std::string &word, const std::vector<std::string> &known, const char *key,
                              const std::string &folder);
/// One of a table's words in a folder's summary.json; none: the key is not there. Throws DataError.
template <Worded E>
std::optional<E> word_in(const nlohmann::json &summary, const char *key, const std::string &folder) {
  if (!summary.contains(key)) return {};
  const std::string written = text_in(summary, key, folder);
  if (const auto known = parse<E>(written)) return known;
  refuse_word(written, words<E>(), key, folder);
}

/// A folder of many runs.
enum class Collection { sweep, main_job, study, geometry_study };
constexpr auto choices(Collection) {
  using enum Collection;
  return choices_of<Collection>(
      {{sweep, "a sweep"}, {main_job, "a main job"}, {study, "a study"}, {geometry_study, "a geometry study"}});
}
/// What stands in the folder; empty: no collection, or a run.
std::optional<Collection> collection_in(const std::string &folder);

/// Removes what runs leave (results, checkpoint, fields, pictures, report), but for scene.toml, which may be what is
/// run; other files stay. Throws IoError.
void remove_run(const std::string &folder);
/// Removes what a new run of the same scene would not write anew, or not at once: checkpoint, fields, pictures, report.
void remove_by_products(const std::string &folder);
/// The half written files of a run that was killed, which may be all that it left.
void remove_unfinished(const std::string &folder);

} // namespace rimpact
