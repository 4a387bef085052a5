#include "scene/rim_identity.h"

#include "io/files/key_list.h"
#include "io/files/text.h"
#include "io/files/value_differences.h"
#include "scene/bearing_keys.h"
#include "scene/keys.h"
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include <cstdint>
#include <fmt/format.h>
#include <map>

namespace rimpact::scene {
namespace {

/// FNV-1a: short and the same on every machine; nobody gains by a collision here.
std::uint64_t digest(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325u) {
  for (const unsigned char c : text) hash = (hash ^ c) * 0x100000001b3u;
  return hash;
}

/// Of the values, not of the remarks beside them.
std::string digest_of_values(const Bearing &bearing) {
  std::uint64_t hash = digest("");
  const std::string text = to_toml(bearing);
  for (const auto line : lines_of(text)) hash = digest(trim(line.substr(0, line.find('#'))), hash);
  return fmt::format("{:016x}", hash);
}

/// The steel as the force knows it: how far it is trusted, and where its numbers are from, shape none.
Material force_of(Material steel) {
  steel.strain_limit.reset();
  steel.fracture = {}, steel.grade = Material{}.grade, steel.hardness_HB = 0;
  return steel;
}

void leave_the_force(Bearing &bearing) {
  for (const auto &[table, steel] : steels_of(bearing)) *steel = force_of(*steel);
}

/// What shapes the force of an impact; all else is as in a bearing by default.
Bearing rim_of(const Bearing &bearing) {
  Bearing rim;
  rim.name.clear();
  rim.surface = bearing.surface, rim.slider = bearing.slider, rim.rim = bearing.rim, rim.plate = bearing.plate;
  rim.rim.connection = {}; // whether it bears the force is another question
  rim.steel = bearing.steel, rim.part_steels = bearing.part_steels;
  leave_the_force(rim);
  rim.contact.rim = bearing.contact.rim;
  rim.contact.rim_slow = bearing.contact.rim_slow;
  if (rim.contact.rim_slow) rim.contact.rate = bearing.contact.rate;
  return rim;
}

std::map<std::string, std::string> by_key(const std::string &values) {
  std::map<std::string, std::string> result;
  for (const auto line : lines_of(values))
    if (const auto equals = line.find(" = "); equals != std::string_view::npos)
      result.emplace(line.substr(0, equals), line.substr(equals + 3));
  return result;
}

} // namespace

std::string rim_identity(const Bearing &bearing) {
  return digest_of_values(rim_of(bearing));
}

std::string rim_values(const Bearing &bearing) {
  KeyList list;
  Bearing rim = rim_of(bearing);
  visit(list, rim);
  std::string text;
  for (const auto &entry : list.entries) text += fmt::format("{} = {}\n", entry.path(), entry.value);
  return text;
}

std::string rim_differences(const std::string &a, const std::string &b) {
  std::string text;
  for (const auto &[key, there, here] : value_differences(by_key(a), by_key(b)))
    text += fmt::format("{}{} {} and {}", text.empty() ? "" : ", ", key, there, here);
  return text;
}

std::string bearing_identity(const Bearing &bearing) {
  Bearing whole = bearing;
  whole.name.clear();
  leave_the_force(whole);
  whole.rim.connection = {}, whole.assumed = {};
  return digest_of_values(whole);
}

} // namespace rimpact::scene
