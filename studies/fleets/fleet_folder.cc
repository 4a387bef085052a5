#include "studies/fleets/fleet_folder.h"

#include "io/files/digest.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/folder_lock.h"
#include "io/files/json_text.h"
#include "io/records/record_corrections.h"
#include "io/records/record_file.h"
#include "io/records/record_library.h"
#include "responses/kept_run.h"
#include "responses/response.h"
#include "scene/toml_writer.h"
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <set>
#include <thread>

namespace rimpact::fleets {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Sought beside the sweep, as those of file_keys, and on their shelf.
constexpr std::array record_keys{"excitation.x", "excitation.y", "excitation.z"};

std::set<std::string> swept_files(const std::string &where, const Sweep &sweep) {
  std::set<std::string> files;
  const std::array beside{fs::path(sweep.origin).parent_path(),
                          fs::is_directory(where) ? fs::path(where) : fs::path(where).parent_path(), fs::path(),
                          fs::path(records_shelf())};
  for (std::size_t i = 0; i < sweep.keys.size(); ++i) {
    const auto is_among = [&](const auto &keys) {
      return std::find(keys.begin(), keys.end(), sweep.keys[i]) != keys.end();
    };
    const bool is_record = is_among(record_keys);
    if (!is_record && !is_among(file_keys)) continue;
    std::set<std::string> names;
    for (const auto &run : sweep.runs)
      if (const auto *text = std::get_if<std::string>(&run[i].cell); text && !text->empty()) names.insert(*text);
    for (const auto &name : names)
      for (const auto &folder : beside) {
        const std::string path = fs::absolute(folder / name).lexically_normal().string();
        std::error_code none;
        if (fs::is_directory(path, none))
          files.insert(path + "/calibration.json");
        else if (!is_record)
          files.insert(path);
        else if (fs::is_regular_file(record_name(path).file, none))
          for (const auto &file : files_of_record(path)) files.insert(file);
      }
  }
  std::erase_if(files, [](const auto &file) {
    std::error_code none;
    return !fs::is_regular_file(file, none);
  });
  return files;
}

/// The scene file itself: a key of it may matter in other runs than the first.
std::string text_of_scene(const std::string &where) {
  std::error_code none;
  const fs::path path = fs::is_directory(where, none) ? fs::path(where) / "scene.toml" : fs::path(where);
  return fs::is_regular_file(path, none) ? read_file(path.string()) : "";
}

json to_json(const FleetIdentity &identity) {
  json result = to_json(identity.rows);
  result["sweep"] = identity.sweep, result["values"] = identity.values;
  return result;
}

json read_fleet(const std::string &path) {
  const json fleet = json::parse(read_file(path), nullptr, false);
  const auto is = [&](const char *key, auto test) { return fleet.contains(key) && (fleet[key].*test)(); };
  const bool identity = fleet.is_object() && fleet.contains("identity") &&
                        (fleet["identity"].is_object() || fleet["identity"].is_string());
  if (!identity || !is("scene", &json::is_string) || !is("n_runs", &json::is_number) || !is("keys", &json::is_array))
    throw DataError(path +
                    " is damaged: it does not say what the sweep is of; choose another folder with -o, or --force");
  return fleet;
}

struct Verdict {
  bool other = false;  ///< another sweep
  std::string changed; ///< why its rows are not kept; empty: they are
};
Verdict judge(const json &kept, const FleetIdentity &now, const Sweep &sweep) {
  const json &id = kept["identity"];
  const auto rows = identity_from(id);
  if (kept["scene"] != now.scene_name) return {true, {}};
  if (!rows)
    return {kept["keys"] != json(sweep.keys) || kept["n_runs"] != json(sweep.runs.size()),
            "it was made by an older version, which did not note the files it read"};
  if (id.value("sweep", json()) != now.sweep) return {true, {}};
  const std::string changed = changes(*rows, now.rows);
  const bool same_files = rows->inputs == now.rows.inputs;
  if (id.value("values", json()) != now.values)
    return {same_files, changed.empty() ? "the records are others" : changed + " since"};
  if (changed.empty()) return {false, same_files ? "" : "the files it reads are others"};
  return {false, changed + " since"};
}

void remove_rows(const std::string &folder) {
  for (const auto &entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string(), ending = entry.path().extension().string();
    const bool ours = name == "table.csv" || name == "table.h5" || name == "limits.json" ||
                      name.starts_with("fractiles.") ||
                      (name.starts_with("table-") && (ending == ".csv" || ending == ".h5"));
    if (ours) fs::remove(entry.path());
  }
}

/// Shards begin together: one of them looks at the folder at a time.
FolderLock wait_to_open(const std::string &folder) {
  for (int tries = 0;; ++tries) {
    try {
      return FolderLock(folder, "opening");
    } catch (const IoError &) {
      if (tries == 200) throw;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

} // namespace

FleetIdentity fleet_identity(const std::string &where, const std::vector<std::string> &overrides, const Sweep &sweep,
                             const scene::Scene &first, const FleetModel &model) {
  std::string definition = fmt::format("{}\n", sweep.runs.size()), values;
  for (const auto &assignment : overrides) definition += assignment + "\n";
  for (const auto &key : sweep.keys) definition += key + "\n";
  if (!model.name.empty()) definition += model.name + "\n";
  for (const auto &run : sweep.runs)
    for (const auto &value : run) values += value.toml + "\n";
  FleetIdentity identity{where, sha256(definition), sha256(values), identity_of(first)};
  // Of the first run only what the sweep does not set: a value swept is no change of the scene.
  auto keys = resolved_keys(scene::to_toml(first));
  for (const auto &key : sweep.keys) keys.erase(key);
  std::string text = text_of_scene(where);
  for (const auto &[key, value] : keys) text += key + " = " + value + "\n";
  identity.rows.scene = sha256(text);
  for (const auto &file : swept_files(where, sweep)) identity.rows.inputs[file] = sha256_of_file(file);
  identity.rows.inputs.insert(model.inputs.begin(), model.inputs.end());
  return identity;
}

void open_folder(const FleetIdentity &identity, const Sweep &sweep, const FleetOptions &options) {
  const auto lock = wait_to_open(options.folder);
  const std::string path = options.folder + "/fleet.json";
  std::error_code none;
  const auto what = collection_in(options.folder);
  const bool run = fs::exists(options.folder + "/summary.json", none);
  if (!options.force && (run || (what && *what != Collection::sweep)))
    throw InputError(fmt::format("{} holds {}; choose another folder with -o, or --force", options.folder,
                                 run ? "a run" : word(*what)));
  if (fs::exists(path, none)) {
    const Verdict verdict =
        options.force ? Verdict{false, "--force was given"} : judge(read_fleet(path), identity, sweep);
    if (verdict.other)
      throw InputError(fmt::format("{} holds a sweep of another scene or other values ({}); choose another folder with "
                                   "-o, or replace it with --force",
                                   options.folder, path));
    if (verdict.changed.empty()) return;
    remove_rows(options.folder);
    if (options.remark && !options.force)
      options.remark(fmt::format("{}: every run is made again, because {}", options.folder, verdict.changed));
  }
  const json fleet = {{"identity", to_json(identity)}, {"version", RIMPACT_VERSION},  {"scene", identity.scene_name},
                      {"sweep", sweep.origin},         {"n_runs", sweep.runs.size()}, {"keys", sweep.keys}};
  write_atomically(json_text(fleet), path);
}

void require_still_ours(const FleetIdentity &identity, const std::string &folder) {
  const std::string path = folder + "/fleet.json";
  if (!fs::exists(path)) throw IoError(path + " is gone: another process has cleared the folder");
  const json fleet = json::parse(read_file(path), nullptr, false);
  if (!fleet.is_object() || fleet.value("identity", json()) != to_json(identity))
    throw IoError(folder + " was taken by the same sweep with other inputs or by another version: this one ends, so "
                           "that their rows do not mix");
}

} // namespace rimpact::fleets
