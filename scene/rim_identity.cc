#include "scene/rim_identity.h"

#include "files/text.h"
#include "scene/scene.h"
#include <cstdint>
#include <fmt/format.h>

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

} // namespace

std::string rim_identity(const Bearing &bearing) {
  Bearing rim;
  rim.name.clear();
  rim.surface = bearing.surface, rim.slider = bearing.slider, rim.rim = bearing.rim, rim.plate = bearing.plate;
  rim.steel = bearing.steel, rim.steel.strain_limit.reset();
  rim.contact.rim = bearing.contact.rim;
  rim.contact.rim_slow = bearing.contact.rim_slow;
  if (rim.contact.rim_slow) rim.contact.rate = bearing.contact.rate;
  return digest_of_values(rim);
}

std::string bearing_identity(const Bearing &bearing) {
  Bearing whole = bearing;
  whole.name.clear();
  whole.steel.strain_limit.reset(), whole.assumed = {};
  return digest_of_values(whole);
}

} // namespace rimpact::scene
