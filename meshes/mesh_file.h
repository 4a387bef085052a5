/// A bearing drawn elsewhere, read through gmsh.
#pragma once
#include "meshes/drawn_sizes.h"
#include "meshes/hex_mesh.h"
#include "scene/own_mesh_settings.h"

namespace rimpact::meshes {

/// What a scene needs of a drawing.
struct DrawingUse {
  std::vector<SizeOn> sizes = {}; ///< of what is meshed from a geometry, none above own.size
  bool pad_is_tied = true;        ///< pad and foot are one piece, as plate and rim always are
};
struct DrawnMesh {
  HexMesh mesh;         ///< [m], all bodies of the file, where they are drawn
  bool divided = false; ///< made of tetrahedra: corners within curved walls lie on their chords
};
/// Cells are straight where the file has 8-node hexahedra or tetrahedra (divided into four hexahedra each), curved
/// where it has 20 or 27 nodes. A .geo or .step is meshed, as it asks if that gives hexahedra; bodies of one piece that
/// are drawn apart are joined before. Throws DataError naming the file and the group, cell or face that is
/// missing, of another kind, or not a body's boundary. `path`: where the file is read, own.file what it is called.
DrawnMesh read_mesh(const scene::OwnMesh &own, const std::string &path, const DrawingUse &use);

} // namespace rimpact::meshes
