/// What a scene, and with it a folder and a file, may be called.
#pragma once
#include <string>
#include <string_view>

namespace rimpact::scene {

struct Scene;

bool is_utf8(std::string_view text);
/// The text with every byte that is not UTF-8 and every control character, but line ends and tabs, replaced: what may
/// go to a terminal or into JSON.
std::string printable(std::string_view text);

/// Throws InputError for a name that leads out of a folder ("/", "." or "..") or is not UTF-8, and for files whose
/// names are not: scene.toml could not be read back.
void check_names(const Scene &scene);

/// The name as a folder's: control characters and leading dots, dashes and blanks become "_", at most 100 bytes are
/// kept. Never empty.
std::string folder_name(const std::string &scene_name);

} // namespace rimpact::scene
