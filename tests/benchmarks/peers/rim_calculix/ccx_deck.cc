#include "ccx_deck.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace rimpact::verification {
namespace {

using Key = std::array<unsigned, 4>;
Key sorted(Key corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Whether midside node `k` of ccx's order lies on ccx's face `f`: both ends of its edge do.
bool on_face(int k, int f) {
  constexpr int ends[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                               {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  const auto has = [&](int corner) { return std::count(ccx_faces[f], ccx_faces[f] + 4, corner) > 0; };
  return k < 8 ? has(k) : has(ends[k - 8][0]) && has(ends[k - 8][1]);
}

} // namespace

DeckMesh::DeckMesh(const meshes::HexMesh &mesh, int n_nodes) : mesh_(mesh), n_nodes_(n_nodes) {
  if (n_nodes != 8 && n_nodes != 20)
    throw std::invalid_argument(fmt::format("a deck's hexahedra have 8 or 20 nodes, not {}", n_nodes));
  std::map<Key, std::pair<std::size_t, int>> owner;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int f = 0; f < 6; ++f) {
      Key corners;
      for (int i = 0; i < 4; ++i) corners[i] = mesh.cells[c][ccx_faces[f][i]];
      owner[sorted(corners)] = {c, f};
    }
  for (const auto &face : mesh.faces) {
    const auto found = owner.find(sorted(face.corners));
    if (found == owner.end())
      throw std::invalid_argument(fmt::format("a face of {} belongs to no cell", to_string(face.group)));
    const auto [cell, f] = found->second;
    DeckFace entry{cell + 1, f + 1, {}};
    for (int k = 0; k < n_nodes; ++k)
      if (on_face(k, f)) entry.nodes.push_back(mesh.cells[cell][ccx_order[k]]);
    faces_[face.group].push_back(entry);
  }
}

std::string DeckMesh::nodes_and_elements(const std::string &element_type,
                                         const std::map<meshes::Volume, std::string> &others) const {
  std::set<unsigned> used;
  for (const auto &cell : mesh_.cells)
    for (int k = 0; k < n_nodes_; ++k) used.insert(cell[ccx_order[k]]);
  std::string text = "*NODE, NSET=ALL\n";
  for (const unsigned n : used) {
    const auto &x = mesh_.nodes[n];
    text += fmt::format("{}, {:.12e}, {:.12e}, {:.12e}\n", n + 1, 1e3 * x[0], 1e3 * x[1], 1e3 * x[2]);
  }
  const std::set<meshes::Volume> volumes(mesh_.volumes.begin(), mesh_.volumes.end());
  for (const auto volume : volumes) {
    const auto other = others.find(volume);
    text += fmt::format("*ELEMENT, TYPE={}, ELSET={}\n", other == others.end() ? element_type : other->second,
                        to_string(volume));
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      if (mesh_.volumes[c] != volume) continue;
      text += std::to_string(c + 1);
      for (int k = 0; k < n_nodes_; ++k)
        text += fmt::format(",{}{}", k == 12 ? "\n" : " ", mesh_.cells[c][ccx_order[k]] + 1);
      text += "\n";
    }
  }
  return text;
}

std::set<unsigned> DeckMesh::nodes_of(meshes::Surface group) const {
  std::set<unsigned> nodes;
  if (const auto found = faces_.find(group); found != faces_.end())
    for (const auto &face : found->second) nodes.insert(face.nodes.begin(), face.nodes.end());
  return nodes;
}

std::set<unsigned> DeckMesh::nodes_of(meshes::Volume volume) const {
  std::set<unsigned> nodes;
  for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
    for (int k = 0; k < n_nodes_ && mesh_.volumes[c] == volume; ++k) nodes.insert(mesh_.cells[c][ccx_order[k]]);
  return nodes;
}

std::string DeckMesh::surface(meshes::Surface group) const {
  std::string text = fmt::format("*SURFACE, NAME={}, TYPE=ELEMENT\n", to_string(group));
  for (const auto &face : faces_.at(group)) text += fmt::format("{}, S{}\n", face.element, face.face);
  return text;
}

std::string node_set(const std::string &name, const std::set<unsigned> &nodes) {
  std::string text = fmt::format("*NSET, NSET={}\n", name);
  for (const unsigned n : nodes) text += fmt::format("{},\n", n + 1);
  return text;
}

std::string material(const char *name, const scene::Material &data) {
  std::string text = fmt::format("*MATERIAL, NAME={}\n*ELASTIC\n{}, {}\n", name, 1e-6 * data.E, data.nu);
  if (data.yield)
    text += fmt::format("*PLASTIC\n{:.9g}, 0.\n{:.9g}, 2.\n", 1e-6 * *data.yield,
                        1e-6 * *data.yield + 2e-6 * hardening_modulus(data));
  return text;
}

std::string contact(const char *name, const char *slave, const char *master, double stiffness, double mu) {
  std::string text = fmt::format(
      "*SURFACE INTERACTION, NAME={}\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{:g}\n", name, stiffness);
  if (mu > 0) text += fmt::format("*FRICTION\n{:g}, {:g}\n", mu, 0.1 * stiffness);
  return text + fmt::format("*CONTACT PAIR, INTERACTION={}, TYPE=SURFACE TO SURFACE\n{}, {}\n", name, slave, master);
}

} // namespace rimpact::verification
