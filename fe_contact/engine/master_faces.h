/// Faces of a deformable body that carry an exact master surface: a point x of another body is pulled back to
/// the body's reference configuration, y = x - u_m at the place opposite, where the exact surface is known. The
/// look-up works on reference faces, so its tree is built once and sliding over face edges is nothing special.
#pragma once
#include "fe_contact/engine/discretisation.h"
#include "fe_contact/engine/face_geometry.h"
#include <memory>

namespace rimpact::fe {

/// The place opposite a point, w = x - u_m held at that place.
struct Opposite {
  int face = -1;                   ///< -1: none
  FaceShapes shapes;               ///< of that face, there
  Eigen::Vector3d y;               ///< the point, pulled back [m]
  Eigen::Matrix3d inverse;         ///< dy/dw: the inverse of (I + grad u_m)
  Eigen::Matrix<double, 2, 3> dxi; ///< d(xi, eta)/dw [1/m]
  Eigen::Vector3d second[3];       ///< second derivatives of u_m: xixi, xieta, etaeta [m]
  bool inside = false;             ///< on the faces; else past a free edge, by no more than was allowed
};

class MasterFaces {
public:
  MasterFaces(const Discretisation &space, meshes::Surface group);
  ~MasterFaces();
  MasterFaces(MasterFaces &&) noexcept;

  /// Opposite of x at dof displacements u, `guess` the face to try first (-1: none); past free edges up to
  /// `beyond` half widths of a face; none where the place is not found within a nanometre.
  Opposite find(const Eigen::Vector3d &x, const Eigen::VectorXd &u, int guess, double beyond) const;
  /// x pulled back with the displacement of a face's middle (-1: the group's first): good enough to look up what is
  /// near.
  Eigen::Vector3d approximate_pull_back(const Eigen::Vector3d &x, const Eigen::VectorXd &u, int face = -1) const;
  /// x pulled back as a face's middle moves and turns: where a body that turns would have carried a point beyond its
  /// edges.
  Eigen::Vector3d rigid_pull_back(const Eigen::Vector3d &x, const Eigen::VectorXd &u, int face = -1) const;
  /// How much a face's displacements differ from its middle's at most: what `approximate_pull_back` errs by near that
  /// face [m].
  double displacement_spread(const Eigen::VectorXd &u, int face) const;
  /// Faces within `margin` of a box of pulled-back points [m].
  std::vector<int> near(const Eigen::Vector3d &low, const Eigen::Vector3d &high, double margin) const;
  const Face &face(int i) const { return *faces_[i]; }

private:
  struct Tree;
  struct Place {
    int face = -1;
    Projection projection;
    bool inside = false;
  };
  Place place_on(int face, const Eigen::Vector3d &y) const; ///< of this face alone; `inside`: the point keeps it
  Place locate(const Eigen::Vector3d &y, int guess, double beyond) const;
  struct Start {
    int face; ///< to try first, -1: none
    Eigen::Vector3d y;
  };
  template <typename Search>
  Opposite solve_opposite(const Eigen::Vector3d &x, const Eigen::VectorXd &u, const Start &from,
                          const Search &search) const;

  const Discretisation &space_;
  std::vector<const Face *> faces_;
  std::vector<FaceNodes> nodes_;                ///< reference positions
  std::vector<std::array<bool, 4>> open_edges_; ///< xi-, xi+, eta-, eta+ border no other face
  std::unique_ptr<Tree> tree_;
};

} // namespace rimpact::fe
