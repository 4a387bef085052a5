#include "meshes/mesh_file.h"

#include "io/files/error.h"
#include "meshes/cell_nodes.h"
#include "meshes/gmsh_groups.h"
#include "meshes/gmsh_session.h"
#include "meshes/tetrahedra.h"
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace rimpact::meshes {
namespace {

namespace mesh = gmsh::model::mesh;
/// gmsh's numbers of element types.
constexpr int triangle3 = 2, quadrangle4 = 3, tetrahedron4 = 4, quadrangle9 = 10, tetrahedron10 = 11, quadrangle8 = 16;

[[noreturn]] void fail(const scene::OwnMesh &own, const std::string &what) {
  throw DataError(fmt::format("{}: {}", own.file, what));
}

/// Elements of one dimension, by their type.
struct Elements {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
  explicit Elements(int dimension, int entity = -1) { mesh::getElements(types, tags, nodes, dimension, entity); }
};

bool all_hexahedra(const Elements &elements) {
  return !elements.types.empty() && std::all_of(elements.types.begin(), elements.types.end(),
                                                [](int type) { return nodes_of_hexahedron(type) > 0; });
}

void set_sizes(const scene::OwnMesh &own, const std::vector<SizeOn> &sizes) {
  mesh::field::setString(mesh::field::add("MathEval", 1), "F", size_expression(own, sizes));
  mesh::field::setAsBackgroundMesh(1);
  for (const char *other : {"Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromPoints"})
    gmsh::option::setNumber(other, 0);
  gmsh::option::setNumber("Mesh.Algorithm", 1); // the others cut across walls that are low and wide
}

/// A geometry without cells is meshed: as it asks (transfinite, extruded) if that gives hexahedra, else by our sizes.
void mesh_geometry(const scene::OwnMesh &own, const std::vector<SizeOn> &sizes) {
  if (!Elements(3).types.empty()) return;
  mesh::generate(3);
  if (all_hexahedra(Elements(3))) return;
  mesh::clear();
  set_sizes(own, sizes);
  mesh::generate(3);
}

class Reader {
public:
  Reader(const scene::OwnMesh &own, const GmshGroups &groups)
      : own_(own), groups_(groups), complete_(drawn_.mesh), divide_(drawn_.mesh) {}
  DrawnMesh read() {
    read_nodes();
    for (std::size_t k = 0; k < n_volumes; ++k)
      for (const int entity : groups_.entities(k)) read_cells(k, Elements(3, entity));
    boundary_.emplace(drawn_.mesh);
    for (std::size_t k = n_volumes; k < n_volumes + n_surfaces; ++k)
      for (const int entity : groups_.entities(k)) read_faces(k, Elements(2, entity));
    return std::move(drawn_);
  }

private:
  void read_nodes() {
    std::vector<std::size_t> tags;
    std::vector<double> x, unused;
    mesh::getNodes(tags, x, unused);
    const double metres = own_.metres();
    for (std::size_t k = 0; k < tags.size(); ++k) {
      number_[tags[k]] = static_cast<unsigned>(drawn_.mesh.nodes.size());
      drawn_.mesh.nodes.push_back({metres * x[3 * k], metres * x[3 * k + 1], metres * x[3 * k + 2]});
    }
  }

  void read_cells(std::size_t group, const Elements &elements) {
    for (std::size_t t = 0; t < elements.types.size(); ++t) {
      const int type = elements.types[t];
      const std::size_t n = type == tetrahedron4 ? 4 : nodes_of_hexahedron(type);
      if (type == tetrahedron10)
        fail(own_,
             fmt::format("group '{}' holds {} tetrahedra of 10 nodes, for which there is no element here: save them "
                         "with 4 (gmsh: Mesh.ElementOrder = 1); each becomes four hexahedra of 27 nodes, which are "
                         "of second order and follow the bearing's walls",
                         groups_.name(group), elements.tags[t].size()));
      if (n == 0)
        fail(own_,
             fmt::format(
                 "group '{}' holds {} cells that are neither hexahedra (of 8, 20 or 27 nodes) nor 4-node tetrahedra",
                 groups_.name(group), elements.tags[t].size()));
      for (std::size_t c = 0; c < elements.tags[t].size(); ++c) {
        std::vector<unsigned> nodes;
        for (std::size_t a = 0; a < n; ++a) nodes.push_back(number_.at(elements.nodes[t][n * c + a]));
        if (type != tetrahedron4)
          add_cell(group, nodes);
        else
          for (const auto &hexahedron : divide_.hexahedra({nodes[0], nodes[1], nodes[2], nodes[3]}))
            add_cell(group, {hexahedron.begin(), hexahedron.end()});
        drawn_.divided = drawn_.divided || type == tetrahedron4;
      }
    }
  }

  void add_cell(std::size_t group, const std::vector<unsigned> &nodes) {
    drawn_.mesh.cells.push_back(complete_(nodes));
    drawn_.mesh.volumes.push_back(static_cast<Volume>(static_cast<int>(Volume::plate) + static_cast<int>(group)));
  }

  void read_faces(std::size_t group, const Elements &elements) {
    if (elements.types.empty())
      fail(own_, fmt::format("group '{}' has no faces: save the surfaces' elements too", groups_.name(group)));
    for (std::size_t t = 0; t < elements.types.size(); ++t) {
      const int type = elements.types[t];
      const std::size_t n = type == triangle3     ? 3
                            : type == quadrangle4 ? 4
                            : type == quadrangle8 ? 8
                            : type == quadrangle9 ? 9
                                                  : 0;
      if (n == 0)
        fail(own_, fmt::format("group '{}' holds faces that are neither quadrangles nor 3-node triangles",
                               groups_.name(group)));
      for (std::size_t f = 0; f < elements.tags[t].size(); ++f) {
        std::array<unsigned, 4> corners{};
        for (std::size_t a = 0; a < std::min<std::size_t>(n, 4); ++a)
          corners[a] = number_.at(elements.nodes[t][n * f + a]);
        if (type != triangle3)
          add_face(group, corners);
        else
          for (const auto &quadrangle : divide_.quadrangles({corners[0], corners[1], corners[2]}))
            add_face(group, quadrangle);
      }
    }
  }

  void add_face(std::size_t group, const std::array<unsigned, 4> &corners) {
    if (!boundary_->has(corners)) {
      const auto &x = drawn_.mesh.nodes[corners[0]];
      fail(own_, fmt::format("a face of group '{}' at ({:.1f}, {:.1f}, {:.1f}) mm is no outer face of a body",
                             groups_.name(group), 1e3 * x[0], 1e3 * x[1], 1e3 * x[2]));
    }
    drawn_.mesh.faces.push_back(
        {corners, static_cast<Surface>(static_cast<int>(Surface::dish) + static_cast<int>(group - n_volumes))});
  }

  const scene::OwnMesh &own_;
  const GmshGroups &groups_;
  DrawnMesh drawn_;
  CellNodes complete_;
  TetrahedraDivision divide_;
  std::map<std::size_t, unsigned> number_; ///< of gmsh's nodes
  std::optional<BoundaryOfCells> boundary_;
};

} // namespace

DrawnMesh read_mesh(const scene::OwnMesh &own, const std::string &path, const DrawingUse &use) {
  const GmshSession session;
  try {
    gmsh::model::add("drawn");
    gmsh::merge(path);
    GmshGroups groups(own);
    const auto number = [](Volume body) {
      return static_cast<std::size_t>(body) - static_cast<std::size_t>(Volume::plate);
    };
    groups.join(number(Volume::plate), number(Volume::rim));
    if (use.pad_is_tied) groups.join(number(Volume::pad), number(Volume::foot));
    mesh_geometry(own, use.sizes);
    return Reader(own, groups).read();
  } catch (const std::string &message) { // what gmsh 4.8 throws
    fail(own, "gmsh cannot read or mesh it: " + message);
  }
}

} // namespace rimpact::meshes
