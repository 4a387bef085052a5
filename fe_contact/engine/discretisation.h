/// A mesh of hexahedra made into displacement nodes, quadrature data and boundary faces, in plain arrays.
/// deal.II builds it (triangulation, Lagrange elements, curved mapping); the hot loops never see deal.II.
///
/// Nodes are the support points of FE_Q(degree); dof = 3 node + component. Total Lagrangian: gradients are
/// taken once, in the reference configuration. SI units.
#pragma once
#include "fe_contact/engine/serendipity.h"
#include "fe_contact/solver/equations.h"
#include "meshes/hex_mesh.h"
#include <array>
#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rimpact::fe {

/// Shape gradients and weights of all cells at one quadrature.
struct QuadratureData {
  int n_points = 0;              ///< per cell
  std::vector<double> gradients; ///< [cell][point][direction][node]
  std::vector<double> weights;   ///< JxW [m^3], [cell][point]
};

/// A boundary face: (degree+1)^2 nodes in lexicographic order of its own coordinates (xi fast, eta slow),
/// each in
/// [-1, 1]; `orientation` makes orientation * (x_xi cross x_eta) point out of the solid.
struct Face {
  meshes::Surface group;
  unsigned cell;
  std::vector<unsigned> nodes;
  double orientation;
};

class Discretisation {
public:
  /// Which cells are serendipity cells, [cell], of a discretisation that has none yet.
  using CellChoice = std::function<std::vector<char>(const Discretisation &)>;
  /// degree 1 or 2; geometry is always the 27-node one. `serendipity`: of degree 2, none without it.
  Discretisation(const meshes::HexMesh &mesh, int degree, const CellChoice &serendipity = {});
  ~Discretisation();
  Discretisation(const Discretisation &) = delete;

  int degree, nodes_per_cell;
  std::size_t n_cells, n_nodes;
  std::vector<Eigen::Vector3d> positions;     ///< of the nodes, reference configuration [m]
  std::vector<unsigned> cell_nodes;           ///< [cell][local node]
  std::vector<meshes::Volume> volumes;        ///< [cell]
  NodePlaces node_places;                     ///< of a cell's local nodes, in steps of 1 / degree along its axes
  std::vector<InterpolatedNode> interpolated; ///< middles that serendipity cells do without
  std::vector<char> is_interpolated;          ///< [node]
  QuadratureData full, reduced;               ///< Gauss, degree + 1 and degree points a direction
  /// Shape values at the full points, [point][local node]: of the geometry, and of displacements in cells of 27 nodes.
  std::vector<double> full_values;
  /// What the reduced points have, carried on linearly to the full ones: weights, [full point][reduced point].
  std::vector<double> reduced_to_full;
  std::vector<Face> faces; ///< of all groups

  std::vector<double> displacement_values(std::size_t cell) const; ///< full_values, of the cell's displacements
  std::size_t n_dofs() const { return 3 * n_nodes; }
  std::vector<const Face *> faces_of(meshes::Surface group) const;
  std::vector<unsigned> nodes_of(meshes::Surface group) const; ///< sorted, unique

  /// One nodal or cell field of a VTU file; `values` has 1 or 3 components per node, or 1 per cell; NaN where a
  /// field of one component a node is not defined.
  struct Field {
    std::string name;
    int components;
    bool per_cell;
    std::vector<double> values;
  };
  void write_vtu(const std::string &path, const std::vector<Field> &fields) const;

private:
  void read_cells();
  void read_faces();
  void leave_middles_out(const std::vector<char> &serendipity);
  void keep_middles_off_their_edges();
  bool keeps_a_face(std::size_t cell) const; ///< its middle, that is
  SerendipityShapes shapes_of(std::size_t cell) const;
  struct DealII;
  std::unique_ptr<DealII> dealii_;
};

} // namespace rimpact::fe
