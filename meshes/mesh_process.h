/// Foreign mesh files are read by a program of their own, rimpact-gmsh, which is confined and may crash without harm.
#pragma once
#include "meshes/mesh_file.h"

namespace rimpact::meshes {

/// As read_mesh(), in a process apart. Throws DataError as that does, for a script that is not allowed (mesh_kind.h),
/// and with the signal's name where the reader dies of the file; IoError when rimpact-gmsh does not lie beside this
/// program.
DrawnMesh read_mesh_apart(const scene::OwnMesh &own, const DrawingUse &use);

/// What rimpact-gmsh does: a request from `input`, its answer to `output` (file descriptors). Returns its exit code.
int serve_mesh(int input, int output);

} // namespace rimpact::meshes
