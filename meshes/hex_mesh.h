/// A mesh of 27-node hexahedra whose nodes lie on the exact surfaces, with named groups. No deal.II here.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace rimpact::meshes {

/// Names of docs/interface.md ("Fields and meshes"); the value is the gmsh physical tag.
enum class Volume { plate = 1, rim, pad, foot, upper_slider };
enum class Surface {
  dish = 11,
  rim_wall,
  pad_face,
  pad_top,
  foot_seat,
  foot_cap,
  socket,
  slider_side,
  top,
  fixed,
  symmetry,
  sector_end,
  pad_side,
  foot_recess
};
inline constexpr std::size_t n_volumes = 5, n_surfaces = 14;
std::string to_string(Volume); ///< as in scene::mesh_group_names
std::string to_string(Surface);

struct BoundaryFace {
  std::array<unsigned, 4> corners; ///< node indices
  Surface group;
};

/// Nodes [m]. Connectivity in gmsh's order for the 27-node hexahedron (8 corners, 12 edges, 6 faces, 1
/// centre); corners alone make the linear mesh. Ungrouped boundary faces are traction free and not listed.
struct HexMesh {
  std::vector<std::array<double, 3>> nodes;
  std::vector<std::array<unsigned, 27>> cells;
  std::vector<Volume> volumes; ///< one a cell
  std::vector<BoundaryFace> faces;
};

struct MeshQuality {
  std::size_t n_cells, n_nodes;
  double min_scaled_jacobian; ///< over corners, (0, 1]
  double worst_aspect;        ///< longest over shortest edge
  int n_components;           ///< connected pieces: touching bodies must not be welded
};
MeshQuality quality(const HexMesh &mesh);
/// Throws DataError naming the first inverted cell.
void check_cells(const HexMesh &mesh);
/// As check_cells, and for a required group that is missing or a wrong number of components.
void check(const HexMesh &mesh, int expected_components, const std::vector<Surface> &required);
/// gmsh .msh (version 2.2, ASCII, cells of 8 nodes or of all 27, $PhysicalNames). Throws IoError.
void write_msh(const HexMesh &mesh, const std::string &path, bool curved = false);

} // namespace rimpact::meshes
