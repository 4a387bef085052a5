#include "scene/rim_identity.h"

#include "scene/scene.h"
#include "scene/text.h"
#include <cstdint>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// FNV-1a: short and the same on every machine; nobody gains by a collision here.
std::uint64_t digest(std::string_view text, std::uint64_t hash = 0xcbf29ce484222325u) {
  for (const unsigned char c : text) hash = (hash ^ c) * 0x100000001b3u;
  return hash;
}

} // namespace

std::string rim_identity(const Bearing &bearing) {
  Bearing rim;
  rim.name.clear();
  rim.surface = bearing.surface, rim.slider = bearing.slider, rim.rim = bearing.rim, rim.plate = bearing.plate;
  rim.steel = bearing.steel, rim.steel.strain_limit.reset();
  rim.contact.rim = bearing.contact.rim;
  std::uint64_t hash = digest("");
  const std::string text = to_toml(rim);
  for (const auto line : lines_of(text)) hash = digest(trim(line.substr(0, line.find('#'))), hash); // values, not remarks
  return fmt::format("{:016x}", hash);
}

} // namespace rimpact::scene
