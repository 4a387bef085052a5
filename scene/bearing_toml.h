/// Bearings from TOML: a file of its own, or a scene's [bearing], which starts from a built-in one, a file or nothing.
#pragma once
#include "io/files/error.h"
#include "io/files/toml_reader.h"
#include "scene/scene.h"
#include <fmt/format.h>

namespace rimpact::scene {

/// What a scene or bearing is called when its file does not say: the file's name without .toml.
std::string name_from(const std::string &origin);
/// The text at a dotted key; empty where there is none.
std::string text_at(const TomlFile &file, const std::string &path);

/// A bearing of someone's own: from a file, or written out under a name that no built-in one has.
bool has_own_bearing(const TomlFile &file);
/// The bearing that [bearing] of a scene starts from, before its overrides. Throws InputError.
Bearing base_bearing(const TomlFile &file, const std::string &folder);
/// Reads the bearing's keys, which stand behind `prefix`, over what `bearing` holds. Throws InputError, DataError.
void read_bearing(const TomlFile &file, TomlReader &reader, const std::string &prefix, const std::string &folder,
                  Bearing &bearing);

/// Runs a check whose messages open with a key, and puts the key's place in front.
template <class Check> void with_location(const TomlFile &file, const std::string &prefix, const Check &check) {
  try {
    check();
  } catch (const InputError &error) {
    const std::string sentence = error.what(), key = sentence.substr(0, sentence.find_first_of(" :"));
    const std::string inner = prefix.empty() ? key : prefix + "." + key;
    const bool in_prefix = file.find(inner) != nullptr;
    throw InputError(fmt::format("{}: {}", file.location(in_prefix ? inner : key), sentence));
  }
}

} // namespace rimpact::scene
