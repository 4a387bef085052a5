#include "meshes/mesh_kind.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include "scene/script_permission.h"
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::meshes {
namespace {

/// Beginnings of gmsh's words that run programs, touch other files, end the process, or parse text made by the script.
constexpr std::array leaving{"System", "NonBlocking",  "Onelab", "Include",    "Merge",     "Print",
                             "Save",   "ListFromFile", "Exit",   "Abort",      "Parse",     "Plugin",
                             "GetEnv", "CreateDir",    "Solver", "General",    "GetString", "GetNumber",
                             "Read",   "ShowAll",      "Draw",   "FileExists", "OpenFile"};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Comments and strings become blanks; lines stay where they are.
std::string code_of(std::string_view script) {
  std::string code(script);
  enum { outside, line, block, string } state = outside;
  char quote = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i], next = i + 1 < code.size() ? code[i + 1] : '\0';
    if (state == outside && c == '/' && next == '/')
      state = line;
    else if (state == outside && c == '/' && next == '*')
      state = block, code[i + 1] = ' ';
    else if (state == outside && (c == '"' || c == '\''))
      state = string, quote = c;
    else if (state == outside)
      continue;
    else if (state == block && c == '*' && next == '/')
      state = outside, code[i + 1] = ' ';
    else if ((state == line && c == '\n') || (state == string && (c == quote || c == '\n')))
      state = outside;
    if (c != '\n') code[i] = ' ';
  }
  return code;
}

bool ends_with(const std::string &file, std::initializer_list<const char *> endings) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

} // namespace

MeshKind mesh_kind(std::string_view content) {
  for (const auto line : lines_of(content.substr(0, 4096))) {
    const auto first = trim(line);
    if (first.empty()) continue;
    if (first == "$MeshFormat" || first == "$Comments") return MeshKind::msh;
    return first.rfind("ISO-10303-21", 0) == 0 ? MeshKind::step : MeshKind::script;
  }
  return MeshKind::script;
}

std::string call_that_leaves(std::string_view script) {
  const std::string code = code_of(script);
  int line = 1;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code[i] == '\n') ++line;
    if (!is_word(code[i]) || (i > 0 && is_word(code[i - 1]))) continue;
    std::size_t end = i;
    while (end < code.size() && is_word(code[end])) ++end;
    const std::string word = code.substr(i, end - i);
    for (const char *begin : leaving)
      if (word.rfind(begin, 0) == 0) return fmt::format("{} in line {}", word, line);
  }
  return {};
}

bool scripts_allowed() {
  return std::getenv(scene::script_permission) != nullptr;
}

MeshKind require_safe(const std::string &file) {
  const auto fail = [&](const std::string &what) { throw DataError(fmt::format("{}: {}", file, what)); };
  const std::string content = read_file(file);
  const MeshKind kind = mesh_kind(content);
  if (kind == MeshKind::msh && !ends_with(file, {".msh"})) fail("begins as a .msh file; give it that ending");
  if (kind == MeshKind::step && !ends_with(file, {".step", ".stp"}))
    fail("begins as a STEP file; give it the ending .step");
  if (kind != MeshKind::script) return kind;
  if (ends_with(file, {".msh"})) fail("is no .msh file: it does not begin with $MeshFormat");
  if (ends_with(file, {".step", ".stp"})) fail("is no STEP file: it does not begin with ISO-10303-21");
  if (!ends_with(file, {".geo"})) fail("is no mesh that can be read: .msh, .step, or .geo");
  if (!scripts_allowed())
    fail("a .geo file is a program that gmsh runs; if you know where it comes from, allow it with --allow-script, or "
         "save it as .msh in gmsh");
  if (const std::string call = call_that_leaves(content); !call.empty())
    fail(call + " leaves the script (programs, other files, the end of the reader); only geometry and meshing may "
                "stand in it: save it as .msh in gmsh");
  return kind;
}

} // namespace rimpact::meshes
