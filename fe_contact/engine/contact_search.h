/// Where the slave points of a contact are, what of the master lies opposite, and which equations they couple.
#pragma once
#include "fe_contact/engine/discretisation.h"
#include "fe_contact/engine/face_points.h"
#include "fe_contact/engine/master_faces.h"
#include "fe_contact/laws/coulomb.h"
#include "fe_contact/laws/master_surface.h"
#include "fe_contact/solver/equations.h"
#include <optional>
#include <vector>

namespace rimpact::fe {

struct SurfaceContactOptions {
  CoulombContact law;
  int points = 4;       ///< Gauss points a direction and slave face
  int carrier_dof = -1; ///< first of the rigid carrier's three dofs; -1: the surface stands still
  std::optional<meshes::Surface> carrier_faces{}; ///< or: whose displacement carries the surface
  double margin = 0.01;                           ///< pairs of faces nearer than this are coupled in the matrix [m]
};

/// The nodes a point couples, with the derivatives of their weights by (xi, eta) of the carrier's face.
struct PointCoupling {
  static constexpr int most = 2 * FaceShapes::max_nodes;
  Eigen::Vector3d y;                                                     ///< relative position [m]
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();                 ///< dy/dw, w = sum of N u
  Eigen::Matrix<double, 2, 3> dxi = Eigen::Matrix<double, 2, 3>::Zero(); ///< d(xi, eta)/dw
  Eigen::Vector3d second[3]; ///< of the carrier's displacement by (xi, eta), see Opposite
  int n = 0, carrier_face = -1;
  int dofs[most];
  double N[most], dN[most][2];
  bool inside = true;
  void add(int dof, double value, double by_xi = 0, double by_eta = 0) {
    dofs[n] = dof;
    N[n] = value;
    dN[n][0] = by_xi;
    dN[n++][1] = by_eta;
  }
};

/// Finds them, by each slave point.
class ContactSearch {
public:
  /// How far past a free edge a point that crosses it within the step still sees the surface [half widths of a face].
  static constexpr double reach_past_edges = 0.5;

  ContactSearch(const Discretisation &space, meshes::Surface slave, MasterSurface master,
                const SurfaceContactOptions &options);

  const MasterSurface &master() const { return master_; }
  const std::vector<const Face *> &faces() const { return faces_; } ///< slave
  const std::vector<FacePoint> &points() const { return points_; }  ///< of the faces, one after the other
  std::size_t points_a_face() const { return points_a_face_; }
  /// Of point k at dof displacements u; the search begins at carrier face `guess`. Empty where nothing is
  /// opposite, up to `beyond` past the carrier's free edges [half widths of a face].
  std::optional<PointCoupling> couple(std::size_t k, const Eigen::VectorXd &u, int guess, double beyond) const;
  /// Relative position by the present opposite, else by the carrier's rough displacement [m].
  Eigen::Vector3d relative_position(std::size_t k, const Eigen::VectorXd &u, int opposite) const;
  /// Whether a point for which no face is found may be on the master's surface, judged by the face last opposite.
  bool is_candidate(std::size_t k, const Eigen::VectorXd &u, int opposite) const;
  /// Equations coupled by each slave face and what is opposite or near it at dof displacements u; the pairs are
  /// remembered as those the pattern holds. `opposite`: the state's, where the search begins.
  std::vector<std::vector<int>> couplings(const Equations &equations, const Eigen::VectorXd &u,
                                          const std::vector<int> &opposite);
  /// Whether the pattern holds this pair of a slave and a carrier face.
  bool in_pattern(std::size_t face, int carrier_face) const;
  /// Shortest time until an open point touches at dof velocities v [s]; infinity when none closes.
  double time_to_touch(const Eigen::VectorXd &u, const Eigen::VectorXd &v, const std::vector<int> &opposite) const;
  /// Mean stiffness of the faces' nodes over their area [Pa/m], from the diagonal of the solid's stiffness (of this
  /// rank).
  double stiffness_per_area(const Equations &equations, const Eigen::VectorXd &diagonal) const;

private:
  Eigen::Vector3d position(const FacePoint &point, const Eigen::VectorXd &u) const;

  const Discretisation &space_;
  MasterSurface master_;
  int carrier_dof_;
  double margin_;
  std::size_t points_a_face_;
  std::vector<const Face *> faces_;
  std::vector<FacePoint> points_;
  std::optional<MasterFaces> carrier_;
  std::vector<std::vector<int>> pairs_; ///< carrier faces in the pattern, by slave face, sorted
};

} // namespace rimpact::fe
