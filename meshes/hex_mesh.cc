#include "meshes/hex_mesh.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "meshes/hex_order.h"
#include "scene/own_mesh_settings.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <Eigen/LU>
#include <fmt/format.h>
#include <numeric>
#include <set>

namespace rimpact::meshes {
namespace {

Eigen::Vector3d at(const HexMesh &mesh, unsigned node) {
  return Eigen::Map<const Eigen::Vector3d>(mesh.nodes[node].data());
}

/// Jacobian of the 27-node map at a point of [-1, 1]^3.
Eigen::Matrix3d jacobian(const HexMesh &mesh, const std::array<unsigned, 27> &cell, const Eigen::Vector3d &xi) {
  double N[3][3], dN[3][3];
  for (int d = 0; d < 3; ++d) {
    const double x = xi[d];
    N[d][0] = x * (x - 1) / 2, N[d][1] = 1 - x * x, N[d][2] = x * (x + 1) / 2;
    dN[d][0] = x - 0.5, dN[d][1] = -2 * x, dN[d][2] = x + 0.5;
  }
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  for (int a = 0; a < 27; ++a) {
    const auto &p = hex27[a];
    const Eigen::RowVector3d gradient(dN[0][p[0]] * N[1][p[1]] * N[2][p[2]], N[0][p[0]] * dN[1][p[1]] * N[2][p[2]],
                                      N[0][p[0]] * N[1][p[1]] * dN[2][p[2]]);
    J += at(mesh, cell[a]) * gradient;
  }
  return J;
}

int components(const HexMesh &mesh) {
  std::vector<unsigned> parent(mesh.nodes.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](unsigned k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (const auto &cell : mesh.cells)
    for (const unsigned node : cell) parent[root(node)] = root(cell[0]);
  std::set<unsigned> roots;
  for (const auto &cell : mesh.cells) roots.insert(root(cell[0]));
  return roots.size();
}

} // namespace

std::string to_string(Volume volume) {
  return scene::mesh_group_names[static_cast<std::size_t>(volume) - static_cast<std::size_t>(Volume::plate)];
}

std::string to_string(Surface surface) {
  return scene::mesh_group_names[n_volumes + static_cast<std::size_t>(surface) -
                                 static_cast<std::size_t>(Surface::dish)];
}

MeshQuality quality(const HexMesh &mesh) {
  MeshQuality result{mesh.cells.size(), mesh.nodes.size(), 1.0, 1.0, components(mesh)};
  for (const auto &cell : mesh.cells) {
    double shortest = 1e300, longest = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const auto &p = hex27[corner];
      const Eigen::Matrix3d J = jacobian(mesh, cell, Eigen::Vector3d(p[0] - 1, p[1] - 1, p[2] - 1));
      result.min_scaled_jacobian =
          std::min(result.min_scaled_jacobian, J.determinant() / (J.col(0).norm() * J.col(1).norm() * J.col(2).norm()));
    }
    for (const auto &face : hex_faces)
      for (int e = 0; e < 4; ++e) {
        const double length = (at(mesh, cell[face[e]]) - at(mesh, cell[face[(e + 1) % 4]])).norm();
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
      }
    result.worst_aspect = std::max(result.worst_aspect, longest / shortest);
  }
  return result;
}

void check_cells(const HexMesh &mesh) {
  const double g = std::sqrt(0.6), points[3] = {-g, 0, g};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k < 27; ++k)
      if (!(jacobian(mesh, mesh.cells[c], {points[k % 3], points[k / 3 % 3], points[k / 9]}).determinant() > 0)) {
        const auto centre = mesh.nodes[mesh.cells[c][26]];
        throw DataError(fmt::format(
            "mesh: cell {} of '{}' at ({:.1f}, {:.1f}, {:.1f}) mm is inverted; check "
            "the bearing's dimensions; of a drawn mesh, the cell, or whether its straight edges are too long for the "
            "curved surface (finer cells, or 27-node ones)",
            c, to_string(mesh.volumes[c]), 1e3 * centre[0], 1e3 * centre[1], 1e3 * centre[2]));
      }
}

void check(const HexMesh &mesh, int expected_components, const std::vector<Surface> &required) {
  check_cells(mesh);
  const int found = components(mesh);
  if (found != expected_components)
    throw DataError(fmt::format("mesh: {} connected pieces where {} were expected", found, expected_components));
  for (const Surface group : required)
    if (std::none_of(mesh.faces.begin(), mesh.faces.end(), [&](const auto &face) { return face.group == group; }))
      throw DataError("mesh: group '" + to_string(group) + "' is missing");
}

void write_msh(const HexMesh &mesh, const std::string &path, bool curved) {
  std::set<int> volumes, surfaces;
  for (const auto volume : mesh.volumes) volumes.insert(static_cast<int>(volume));
  for (const auto &face : mesh.faces) surfaces.insert(static_cast<int>(face.group));
  std::string text =
      fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n", volumes.size() + surfaces.size());
  for (const int tag : surfaces) text += fmt::format("2 {} \"{}\"\n", tag, to_string(static_cast<Surface>(tag)));
  for (const int tag : volumes) text += fmt::format("3 {} \"{}\"\n", tag, to_string(static_cast<Volume>(tag)));
  const int n_nodes = curved ? 27 : 8, hexahedron = curved ? 12 : 5;
  std::vector<unsigned> number(mesh.nodes.size(), 0);
  std::string nodes;
  unsigned count = 0;
  for (const auto &cell : mesh.cells)
    for (int a = 0; a < n_nodes; ++a)
      if (number[cell[a]] == 0) {
        number[cell[a]] = ++count;
        const auto &x = mesh.nodes[cell[a]];
        nodes += fmt::format("{} {:.17g} {:.17g} {:.17g}\n", count, x[0], x[1], x[2]);
      }
  text += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n", count, nodes,
                      mesh.faces.size() + mesh.cells.size());
  std::size_t element = 0;
  for (const auto &face : mesh.faces) { // four corners suffice to say which face it is
    const int tag = static_cast<int>(face.group);
    text += fmt::format("{} 3 2 {} {}", ++element, tag, tag);
    for (const unsigned node : face.corners) text += fmt::format(" {}", number[node]);
    text += '\n';
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int tag = static_cast<int>(mesh.volumes[c]);
    text += fmt::format("{} {} 2 {} {}", ++element, hexahedron, tag, tag);
    for (int a = 0; a < n_nodes; ++a) text += fmt::format(" {}", number[mesh.cells[c][a]]);
    text += '\n';
  }
  write_atomically(text + "$EndElements\n", path);
}

} // namespace rimpact::meshes
