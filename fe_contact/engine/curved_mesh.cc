#include "fe_contact/engine/curved_mesh.h"

#include "meshes/hex_order.h"
#include <algorithm>
#include <array>
#include <deal.II/grid/grid_tools.h>
#include <map>

namespace rimpact::fe {
namespace {

using namespace dealii;

constexpr int gmsh_corner_of_dealii[8] = {0, 1, 3, 2, 4, 5, 7, 6};

/// Key of an edge or face: its sorted vertex numbers.
using VertexSet = std::array<unsigned, 4>;
VertexSet key(std::vector<unsigned> vertices) {
  vertices.resize(4, numbers::invalid_unsigned_int);
  std::sort(vertices.begin(), vertices.end());
  return {vertices[0], vertices[1], vertices[2], vertices[3]};
}

/// Where the curved mesh puts every vertex, edge middle, face middle (by their vertices) and cell centre.
struct CurvedPoints {
  std::vector<unsigned> vertex_of_node; ///< HexMesh node -> triangulation vertex, or invalid
  std::vector<Point<3>> vertices;
  std::map<VertexSet, Point<3>> middles;
  std::map<std::vector<unsigned>, Point<3>> centres; ///< by the cell's sorted vertices
};

CurvedPoints curved_points(const meshes::HexMesh &mesh) {
  CurvedPoints points;
  points.vertex_of_node.assign(mesh.nodes.size(), numbers::invalid_unsigned_int);
  const auto point = [&](unsigned node) {
    return Point<3>(mesh.nodes[node][0], mesh.nodes[node][1], mesh.nodes[node][2]);
  };
  for (const auto &cell : mesh.cells)
    for (int corner = 0; corner < 8; ++corner)
      if (points.vertex_of_node[cell[corner]] == numbers::invalid_unsigned_int) {
        points.vertex_of_node[cell[corner]] = points.vertices.size();
        points.vertices.push_back(point(cell[corner]));
      }
  for (const auto &cell : mesh.cells) {
    const auto vertex = [&](int corner) { return points.vertex_of_node[cell[corner]]; };
    for (int e = 0; e < 12; ++e)
      points.middles[key({vertex(meshes::hex27_edges[e][0]), vertex(meshes::hex27_edges[e][1])})] = point(cell[8 + e]);
    for (int f = 0; f < 6; ++f) {
      const auto &c = meshes::hex27_faces[f];
      points.middles[key({vertex(c[0]), vertex(c[1]), vertex(c[2]), vertex(c[3])})] = point(cell[20 + f]);
    }
    std::vector<unsigned> all(8);
    for (int corner = 0; corner < 8; ++corner) all[corner] = vertex(corner);
    std::sort(all.begin(), all.end());
    points.centres[all] = point(cell[26]);
  }
  return points;
}

void make_triangulation(const meshes::HexMesh &mesh, const CurvedPoints &points, Triangulation<3> &triangulation) {
  std::vector<CellData<3>> cells(mesh.cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (int v = 0; v < 8; ++v) cells[c].vertices[v] = points.vertex_of_node[mesh.cells[c][gmsh_corner_of_dealii[v]]];
    cells[c].material_id = static_cast<types::material_id>(mesh.volumes[c]);
    cells[c].manifold_id = c; // remembers the cell's place in HexMesh; no manifold is attached
  }
  GridTools::consistently_order_cells(cells);
  SubCellData boundary;
  triangulation.create_triangulation(points.vertices, cells, boundary);
  std::map<VertexSet, types::boundary_id> group_of;
  for (const auto &face : mesh.faces) {
    std::vector<unsigned> vertices;
    for (const unsigned node : face.corners) vertices.push_back(points.vertex_of_node[node]);
    group_of[key(vertices)] = static_cast<types::boundary_id>(face.group);
  }
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary()) {
        const auto found = group_of.find(
            key({face->vertex_index(0), face->vertex_index(1), face->vertex_index(2), face->vertex_index(3)}));
        if (found != group_of.end()) face->set_boundary_id(found->second);
      }
}

/// The 27 support points of one cell in deal.II's hierarchic order (vertices, lines, quads, interior).
std::vector<Point<3>> support_points(const Triangulation<3>::cell_iterator &cell, const CurvedPoints &points) {
  std::vector<Point<3>> result;
  std::vector<unsigned> all;
  for (unsigned v = 0; v < 8; ++v) {
    result.push_back(points.vertices[cell->vertex_index(v)]);
    all.push_back(cell->vertex_index(v));
  }
  for (unsigned l = 0; l < 12; ++l)
    result.push_back(points.middles.at(key({cell->line(l)->vertex_index(0), cell->line(l)->vertex_index(1)})));
  for (unsigned f = 0; f < 6; ++f) {
    const auto face = cell->face(f);
    result.push_back(points.middles.at(
        key({face->vertex_index(0), face->vertex_index(1), face->vertex_index(2), face->vertex_index(3)})));
  }
  std::sort(all.begin(), all.end());
  result.push_back(points.centres.at(all));
  return result;
}

} // namespace

void make_curved_mesh(const meshes::HexMesh &mesh, Triangulation<3> &triangulation, MappingQCache<3> &mapping) {
  const CurvedPoints curved = curved_points(mesh);
  make_triangulation(mesh, curved, triangulation);
  mapping.initialize(triangulation, [&](const auto &cell) { return support_points(cell, curved); });
}

} // namespace rimpact::fe
