/// Files a .geo script may read beside itself. A script that says Include or Merge is refused (meshes/mesh_kind.h); but
/// gmsh has other words that open a file (ShapeFromFile, a field's FileName), and more of them with each version.
#pragma once
#include <string>
#include <vector>

namespace rimpact {

/// Every regular file that stands in quotes in the script, absolute or relative to the script's own folder, and what
/// the .geo files among them name. Sorted, absolute, without the script itself; empty for a file that is no .geo or
/// cannot be read. A name that only looks like a file costs a hash and nothing else.
std::vector<std::string> files_named_in(const std::string &script);

} // namespace rimpact
