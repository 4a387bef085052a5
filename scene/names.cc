#include "scene/names.h"

#include "io/files/error.h"
#include "scene/scene.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// Bytes of the UTF-8 character that begins at `text`; 0: none does (RFC 3629: no surrogates, no overlong forms).
std::size_t character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto follows = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
    return byte(i) >= low && byte(i) <= high;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const unsigned low = first == 0xE0 ? 0xA0 : 0x80, high = first == 0xED ? 0x9F : 0xBF;
    return follows(1, low, high) && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const unsigned low = first == 0xF0 ? 0x90 : 0x80, high = first == 0xF4 ? 0x8F : 0xBF;
    return follows(1, low, high) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

void require_utf8(const std::string &key, const std::string &value) {
  if (!is_utf8(value))
    throw InputError(
        fmt::format("{} \"{}\" is not valid UTF-8, so that scene.toml could not be read back; rename the file", key,
                    printable(value)));
}

} // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t n = character(text);
    if (n == 0) return false;
    text.remove_prefix(n);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t n = character(text);
    const bool bad = n == 0 || (n == 1 && is_control(text[0]) && text[0] != '\n' && text[0] != '\t');
    result += bad ? std::string_view("?") : text.substr(0, n);
    text.remove_prefix(n == 0 ? 1 : n);
  }
  return result;
}

void check_names(const Scene &scene) {
  const std::string &name = scene.name;
  if (!is_utf8(name))
    throw InputError(fmt::format(
        "name \"{}\" is not valid UTF-8; rename the file, or give the scene a name of its own: name = \"...\"",
        printable(name)));
  if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
    throw InputError(fmt::format("name \"{}\" must be a plain name: not empty, no \"/\", not \".\" or \"..\", because "
                                 "results are kept in a folder of that name",
                                 printable(name)));
  require_utf8("excitation.x", scene.excitation.x_file);
  require_utf8("excitation.y", scene.excitation.y_file);
  require_utf8("excitation.z", scene.excitation.z_file);
  require_utf8("reduced.impact_curve", scene.reduced.impact_curve);
  require_utf8("model.own_mesh.file", scene.model.own_mesh.file);
}

std::string folder_name(const std::string &scene_name) {
  constexpr std::size_t most = 100;
  std::string result;
  for (std::string_view rest = scene_name; !rest.empty();) {
    const std::size_t n = std::max<std::size_t>(1, character(rest));
    if (result.size() + n > most) break;
    const bool leading = result.empty() && (rest[0] == '.' || rest[0] == '-' || rest[0] == ' ');
    result += leading || character(rest) == 0 || (n == 1 && (is_control(rest[0]) || rest[0] == '/'))
                  ? std::string_view("_")
                  : rest.substr(0, n);
    rest.remove_prefix(n);
  }
  return result.empty() ? "scene" : result;
}

} // namespace rimpact::scene
