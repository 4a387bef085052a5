#include "buildings/beam_column.h"
#include <Eigen/Geometry>

namespace rimpact::buildings {
namespace {

/// Adds one plane of bending: translations `t`, rotations `r`; `sign` of the rotation that lifts the far end.
void add_bending(ElementMatrix &k, double EI, double GA, double L, int t, int r, double sign) {
  const double phi = GA > 0 ? 12 * EI / (GA * L * L) : 0, c = EI / (L * L * L * (1 + phi));
  const int dof[] = {t, r, t + 6, r + 6};
  Eigen::Matrix4d b;
  const double s = sign * 6 * L;
  b << 12, s, -12, s,                              //
      s, (4 + phi) * L * L, -s, (2 - phi) * L * L, //
      -12, -s, 12, -s,                             //
      s, (2 - phi) * L * L, -s, (4 + phi) * L * L;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) k(dof[i], dof[j]) += c * b(i, j);
}

void add_axial(ElementMatrix &k, double stiffness, int dof) {
  k(dof, dof) += stiffness, k(dof + 6, dof + 6) += stiffness;
  k(dof, dof + 6) -= stiffness, k(dof + 6, dof) -= stiffness;
}

} // namespace

Eigen::Matrix3d local_axes(const Eigen::Vector3d &from, const Eigen::Vector3d &to, const Eigen::Vector3d &up) {
  Eigen::Matrix3d axes;
  const Eigen::Vector3d x = (to - from).normalized(), y = up.cross(x).normalized();
  axes << x.transpose(), y.transpose(), x.cross(y).transpose();
  return axes;
}

ElementMatrix beam_column_stiffness(const Section &s, const Eigen::Vector3d &from, const Eigen::Vector3d &to,
                                    const Eigen::Vector3d &up) {
  const double L = (to - from).norm();
  ElementMatrix k = ElementMatrix::Zero(), R = ElementMatrix::Zero();
  add_axial(k, s.E * s.area / L, 0);
  add_axial(k, s.G * s.torsion / L, 3);
  add_bending(k, s.E * s.Iz, s.G * s.shear_y, L, 1, 5, 1);
  add_bending(k, s.E * s.Iy, s.G * s.shear_z, L, 2, 4, -1);
  const Eigen::Matrix3d axes = local_axes(from, to, up);
  for (int b = 0; b < 4; ++b) R.block<3, 3>(3 * b, 3 * b) = axes;
  return R.transpose() * k * R;
}

} // namespace rimpact::buildings
