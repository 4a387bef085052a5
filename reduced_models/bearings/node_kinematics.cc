#include "reduced_models/bearings/node_kinematics.h"

namespace rimpact::reduced {

using Eigen::Vector3d;

namespace {

enum Block { uJ = 0, rJ = 3, uI = 6, rI = 9 };

} // namespace

KinematicMatrix displacement_matrix(const NodeHeights &l, const NodalVector &u) {
  const Vector3d d = u.segment<3>(uJ) - u.segment<3>(uI);
  const double arm = d.z() + l.below;
  KinematicMatrix S;
  S << 1, 0, 0, 0, -l.above, 0, -1, 0, 0, 0, -arm, d.y(), //
      0, 1, 0, l.above, 0, 0, 0, -1, 0, arm, 0, -d.x(),   //
      0, 0, 1, 0, 0, 0, 0, 0, -1, -d.y(), d.x(), 0;
  return S;
}

KinematicMatrix velocity_matrix(const NodeHeights &l, const NodalVector &u) {
  const Vector3d d = u.segment<3>(uJ) - u.segment<3>(uI), r = u.segment<3>(rI);
  const double arm = d.z() + l.below;
  KinematicMatrix S;
  S << 1, r.z(), -r.y(), 0, -l.above, 0, -1, -r.z(), r.y(), 0, -arm, d.y(), //
      -r.z(), 1, r.x(), l.above, 0, 0, r.z(), -1, -r.x(), arm, 0, -d.x(),   //
      r.y(), -r.x(), 1, 0, 0, 0, -r.y(), r.x(), -1, -d.y(), d.x(), 0;
  return S;
}

NodalVector nodal_forces(const NodeHeights &heights, const NodalVector &u, const Vector3d &force) {
  return velocity_matrix(heights, u).transpose() * force;
}

void add_nodal_moments(Response &response, const NodeHeights &heights) {
  constexpr const char *axes[] = {"x", "y", "z"};
  const auto read = [&](const std::string &name, std::size_t i) {
    Vector3d v;
    for (int k = 0; k < 3; ++k) v[k] = response.series(name + "_" + axes[k])[i];
    return v;
  };
  for (std::size_t i = 0; i < response.size(); ++i) {
    NodalVector u = NodalVector::Zero();
    u.segment<3>(uJ) = read("displacement", i);
    const NodalVector F = nodal_forces(heights, u, read("force", i));
    for (int k = 0; k < 3; ++k) {
      response.append(std::string("moment_below_") + axes[k], F[rI + k]);
      response.append(std::string("moment_above_") + axes[k], F[rJ + k]);
    }
  }
}

} // namespace rimpact::reduced
