/// What a result came from, so that one of other inputs is never taken for it: the resolved scene, the contents of the
/// files it reads, and the sources of the program that shape a result.
#pragma once
#include "scene/scene.h"
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rimpact {

/// Every hash is a SHA-256 of 64 hexadecimal digits.
struct Identity {
  std::string scene;                         ///< of every key and value of the resolved scene; comments do not count
  std::map<std::string, std::string> inputs; ///< of the contents of each file it reads, by absolute name
  std::string build;                         ///< physics_version()
  bool operator==(const Identity &) const = default;
};

/// Records, impact curve and own mesh with the files its script names, by absolute name. A table of the dish and a
/// bearing file stand in the resolved scene itself.
std::vector<std::string> input_files(const scene::Scene &scene);
/// Throws DataError where a file cannot be read any more.
Identity identity_of(const scene::Scene &scene);

/// {"scene", "inputs", "build"}
nlohmann::json to_json(const Identity &identity);
/// None: not an identity, as in results of older versions.
std::optional<Identity> identity_from(const nlohmann::json &json);

/// What changed from one to the other, e.g. "the file /a/x.AT2 changed"; empty: nothing.
std::string changes(const Identity &kept, const Identity &now);

/// Dotted keys and their values of a text that to_toml wrote; comments are left out.
std::map<std::string, std::string> resolved_keys(const std::string &toml);
/// The first few keys that differ, the name before the others: "excitation.scale is 1.0 there and 1.05 here"; empty:
/// none. `there` and `here` as to_toml wrote them.
std::string scene_differences(const std::string &there, const std::string &here);

} // namespace rimpact
