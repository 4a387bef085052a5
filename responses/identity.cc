#include "responses/identity.h"
#include "responses/physics_version.h"

#include "io/files/digest.h"
#include "io/files/text.h"
#include "io/records/near_fault_pulse.h"
#include "io/records/record.h"
#include "io/records/record_corrections.h"
#include "responses/script_files.h"
#include "scene/toml_writer.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact {
namespace {

/// A line up to its comment; a # in quotes begins none.
std::string_view without_comment(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line[i] == '\\')
      ++i;
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == '#' && !quoted)
      return line.substr(0, i);
  }
  return line;
}

std::string shortened(const std::string &value) {
  return value.size() <= 60 ? value : value.substr(0, 57) + "...";
}

} // namespace

std::map<std::string, std::string> resolved_keys(const std::string &toml) {
  std::map<std::string, std::string> keys;
  std::string section, *open = nullptr; // the value of an array that goes on over several lines
  for (const auto line : lines_of(toml)) {
    const std::string_view text = trim(without_comment(line));
    if (text.empty()) continue;
    if (const auto equals = text.find('='); open) {
      *open += " " + std::string(text);
    } else if (text.front() == '[' && text.back() == ']') {
      section = std::string(text.substr(1, text.size() - 2)) + ".";
      continue;
    } else if (equals != std::string_view::npos) {
      open = &keys[section + std::string(trim(text.substr(0, equals)))];
      *open = trim(text.substr(equals + 1));
    }
    if (open && (open->front() != '[' || open->back() == ']')) open = nullptr;
  }
  return keys;
}

std::string scene_differences(const std::string &there, const std::string &here) {
  constexpr std::size_t told = 3;
  auto old_keys = resolved_keys(there);
  std::vector<std::string> sentences;
  for (const auto &[key, value] : resolved_keys(here)) {
    const auto old = old_keys.find(key);
    if (old == old_keys.end())
      sentences.push_back(fmt::format("{} is not set there and {} here", key, shortened(value)));
    else if (old->second != value)
      sentences.push_back(fmt::format("{} is {} there and {} here", key, shortened(old->second), shortened(value)));
    if (old != old_keys.end()) old_keys.erase(old);
  }
  for (const auto &[key, value] : old_keys)
    sentences.push_back(fmt::format("{} is {} there and not set here", key, shortened(value)));
  std::stable_partition(sentences.begin(), sentences.end(),
                        [](const std::string &sentence) { return sentence.starts_with("name is "); });
  const std::size_t more = sentences.size() > told ? sentences.size() - told : 0;
  sentences.resize(sentences.size() - more);
  return fmt::format("{}{}", fmt::join(sentences, ", "), more ? fmt::format(", and {} more", more) : "");
}

std::vector<std::string> input_files(const scene::Scene &scene) {
  std::vector<std::string> files;
  if (scene.excitation.kind == scene::ExcitationKind::record)
    for (const auto *name : {&scene.excitation.x_file, &scene.excitation.y_file, &scene.excitation.z_file})
      if (!name->empty() && !is_builtin_record(*name))
        for (const auto &file : files_of_record(*name)) files.push_back(file);
  if (scene.excitation.kind == scene::ExcitationKind::path) files.push_back(scene.excitation.path_file);
  if (scene.reduced.impact_law->pushed) files.push_back(scene.reduced.impact_curve);
  if (!scene.model.own_mesh.any()) return files;
  files.push_back(scene.model.own_mesh.file);
  for (const auto &named : files_named_in(files.back())) files.push_back(named);
  return files;
}

Identity identity_of(const scene::Scene &scene) {
  Identity identity;
  std::string keys;
  for (const auto &[key, value] : resolved_keys(to_toml(scene))) keys += key + " = " + value + "\n";
  identity.scene = sha256(keys);
  for (const auto &file : input_files(scene)) identity.inputs[file] = sha256_of_file(file);
  identity.build = physics_version();
  return identity;
}

nlohmann::json to_json(const Identity &identity) {
  return {{"scene", identity.scene}, {"inputs", identity.inputs}, {"build", identity.build}};
}

std::optional<Identity> identity_from(const nlohmann::json &json) {
  try {
    return Identity{json.at("scene").get<std::string>(), json.at("inputs").get<std::map<std::string, std::string>>(),
                    json.at("build").get<std::string>()};
  } catch (const nlohmann::json::exception &) {
    return {};
  }
}

std::string changes(const Identity &kept, const Identity &now) {
  std::vector<std::string> sentences;
  if (kept.scene != now.scene) sentences.push_back("the scene changed");
  for (const auto &[file, hash] : now.inputs) {
    const auto old = kept.inputs.find(file);
    if (old == kept.inputs.end() && kept.scene == now.scene) // a script names a file that was not there
      sentences.push_back(fmt::format("the file {} was not read", file));
    else if (old != kept.inputs.end() && old->second != hash)
      sentences.push_back(fmt::format("the file {} changed", file));
  }
  if (kept.build != now.build) sentences.push_back("it was computed by another version of the program");
  return fmt::format("{}", fmt::join(sentences, ", "));
}

} // namespace rimpact
