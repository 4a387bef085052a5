/// Where the slave points of a contact are, what of the master lies opposite, and which equations they couple.
#pragma once
#include "fe_contact/engine/discretisation.h"
#include "fe_contact/engine/face_points.h"
#include "fe_contact/engine/master_faces.h"
#include "fe_contact/laws/coulomb.h"
#include "fe_contact/laws/master_surface.h"
#include "fe_contact/solver/equations.h"
#include "fe_contact/solver/sparsity.h"
#include <optional>
#include <vector>

namespace rimpact::fe {

/// A body that presses on its own image: what lies at x is met by what lies at c + S (x - c), S of signs, where the
/// centre c moves with three dofs. A half turn about y has S = (-1, 1, -1), an inversion -1 thrice. Both passes of the
/// pair are the same one here, so each point has half its area.
struct OwnImage {
  Eigen::Vector3d centre; ///< where it is without displacement [m]
  Eigen::Vector3d signs;
  int dof; ///< first of the centre's three
};

struct SurfaceContactOptions {
  CoulombContact law;
  int points = 4;       ///< Gauss points a direction and slave face
  int carrier_dof = -1; ///< first of the rigid carrier's three dofs; -1: the surface stands still
  std::optional<meshes::Surface> carrier_faces{}; ///< or: whose displacement carries the surface
  std::optional<OwnImage> image{};                ///< of the carrier, whose faces are of the same body
  double margin = 0.01;                           ///< pairs of faces nearer than this are coupled in the matrix [m]
};

/// The nodes a point couples, with the derivatives of their weights by (xi, eta) of the carrier's face.
struct PointCoupling {
  static constexpr int most = 2 * FaceShapes::max_nodes + 1;
  Eigen::Vector3d y;                                                     ///< relative position [m]
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();                 ///< dy/dw, w = sum of N u
  Eigen::Matrix<double, 2, 3> dxi = Eigen::Matrix<double, 2, 3>::Zero(); ///< d(xi, eta)/dw
  Eigen::Vector3d second[3]; ///< of the carrier's displacement by (xi, eta), see Opposite
  int n = 0, n_slave = 0, carrier_face = -1;
  Eigen::Vector3d slave_signs = Eigen::Vector3d::Ones(); ///< of the first n_slave nodes' weights, by component
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
  double pass_share() const { return pass_share_; } ///< of a point's area that the points have: 1; on its own image 1/2
  /// Of point k at dof displacements u; the search begins at carrier face `guess`. Empty where nothing is
  /// opposite, up to `beyond` past the carrier's free edges [half widths of a face].
  std::optional<PointCoupling> couple(std::size_t k, const Eigen::VectorXd &u, int guess, double beyond) const;
  /// Relative position by the present opposite, else as that face, or the first, moves and turns [m].
  Eigen::Vector3d relative_position(std::size_t k, const Eigen::VectorXd &u, int opposite) const;
  Eigen::Vector3d position_by_motion(std::size_t k, const Eigen::VectorXd &u, int opposite) const; ///< the latter
  /// Whether a point for which no face is found may be on the master's surface, judged by the face last opposite.
  bool is_candidate(std::size_t k, const Eigen::VectorXd &u, int opposite) const;
  /// Equations coupled by each slave face and what is opposite or near it at dof displacements u; the pairs are
  /// remembered as those the pattern holds. `opposite`: the state's, where the search begins.
  Couplings couplings(const Equations &equations, const Eigen::VectorXd &u, const std::vector<int> &opposite);
  /// Whether the pattern holds this pair of a slave and a carrier face.
  bool in_pattern(std::size_t face, int carrier_face) const;
  /// Shortest time until an open point touches at dof velocities v [s]; infinity when none closes.
  double time_to_touch(const Eigen::VectorXd &u, const Eigen::VectorXd &v, const std::vector<int> &opposite) const;
  /// Mean stiffness of the faces' nodes over their area [Pa/m], from the diagonal of the solid's stiffness (of this
  /// rank).
  double stiffness_per_area(const Equations &equations, const Eigen::VectorXd &diagonal) const;

private:
  Eigen::Vector3d position(const FacePoint &point, const Eigen::VectorXd &u) const; ///< as the carrier sees it
  /// A way or a velocity of the slave as the carrier sees it: beside a rigid one's own, or as its image's.
  Eigen::Vector3d seen(const Eigen::Vector3d &slave, const Eigen::VectorXd &by_dof) const;

  const Discretisation &space_;
  MasterSurface master_;
  int carrier_dof_;
  double carrier_weight_ = -1;                      ///< of these dofs
  Eigen::Vector3d signs_ = Eigen::Vector3d::Ones(); ///< of the slave's displacement
  Eigen::Vector3d image_of_origin_{0, 0, 0};        ///< of an image's frame [m]
  double pass_share_ = 1;
  double margin_;
  std::size_t points_a_face_;
  std::vector<const Face *> faces_;
  std::vector<FacePoint> points_;
  std::optional<MasterFaces> carrier_;
  std::vector<std::vector<int>> pairs_; ///< carrier faces in the pattern, by slave face, sorted
};

} // namespace rimpact::fe
