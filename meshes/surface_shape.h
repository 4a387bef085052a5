/// Radius, centre and axis of a surface that gmsh has open, from its points, normals and curvatures. Private to the
/// meshes.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

namespace rimpact::meshes {

struct SurfaceShape {
  std::string kind;
  std::optional<double> radius, around;
  std::optional<Eigen::Vector3d> centre, axis;
};
/// The members that the kind has, see surface_list.h.
SurfaceShape surface_shape(int surface);

} // namespace rimpact::meshes
