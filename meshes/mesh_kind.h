/// What a mesh file is by its content. Data may come from anyone; a script is a program, run only where the user allows
/// it.
#pragma once
#include <string>
#include <string_view>

namespace rimpact::meshes {

enum class MeshKind { msh, step, script };

/// By the first line: `$MeshFormat` (or `$Comments`), `ISO-10303-21`; anything else is what gmsh would run as a script.
MeshKind mesh_kind(std::string_view content);

/// The first word of a gmsh script that leaves it (runs programs, opens other files, ends the reader, parses text it
/// has made), with its line: "SystemCall in line 3". Empty: none. Comments and strings do not count.
std::string call_that_leaves(std::string_view script);

/// Whether --allow-script was given (scene/script_permission.h).
bool scripts_allowed();

/// Reads the file's kind. Throws DataError, naming the cure, for a script that is not allowed or that leaves itself. So
/// it does for data under a script's ending (gmsh goes by the ending), and for anything unreadable.
MeshKind require_safe(const std::string &file);

} // namespace rimpact::meshes
