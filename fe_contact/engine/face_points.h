/// Gauss points of a group of faces, with their shape functions and reference areas.
#pragma once
#include "fe_contact/engine/discretisation.h"
#include "fe_contact/engine/face_geometry.h"

namespace rimpact::fe {

struct FacePoint {
  int face;       ///< index in the group
  double xi, eta; ///< on the face, in [-1, 1]
  FaceShapes shapes;
  double area;            ///< weight times reference area [m^2]
  Eigen::Vector3d normal; ///< outward, reference configuration
};
/// `n` points a direction and face, xi fastest.
std::vector<FacePoint> face_points(const Discretisation &space, const std::vector<const Face *> &faces, int n);

/// Values at the points averaged to the faces' nodes, weighted by area; other nodes are left alone. Points whose
/// value is not finite are passed over.
void average_to_nodes(const std::vector<FacePoint> &points, const std::vector<const Face *> &faces,
                      const std::vector<double> &values, std::vector<double> &nodal);

} // namespace rimpact::fe
