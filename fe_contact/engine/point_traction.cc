#include "fe_contact/engine/point_traction.h"

#include <unsupported/Eigen/AutoDiff>

namespace rimpact::fe {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Of n derivatives three are by w and, where the carrier deforms, three by nu.
template <int n>
CoulombContact::Result<double> differentiate(const CoulombContact &law, const CarriedDistance &d,
                                             const PointCoupling &coupling, const PointLoad &load,
                                             TractionTangents &tangents) {
  using Derivatives = Eigen::Matrix<double, n, 1>;
  using Dual = Eigen::AutoDiffScalar<Derivatives>;
  const auto both = [](const Vector3d &by_w, const Vector3d &by_nu) {
    Derivatives result;
    result.template head<3>() = by_w;
    if constexpr (n > 3) result.template tail<3>() = by_nu;
    return result;
  };
  const Matrix3d P = (Matrix3d::Identity() - d.normal * d.normal.transpose()) / d.stretch;
  const Dual gap(d.gap, both(d.gradient, -d.gap / d.stretch * d.normal));
  Eigen::Matrix<Dual, 3, 1> normal, moving_slip;
  for (int i = 0; i < 3; ++i) {
    normal[i] = Dual(d.normal[i], both(d.curvature.row(i).transpose(), P.row(i).transpose()));
    moving_slip[i] = Dual(load.slip[i], both(coupling.inverse.row(i).transpose(), Vector3d::Zero()));
  }
  const auto result = law.at(gap, normal, moving_slip, load.multiplier, load.tangential, load.dt);
  CoulombContact::Result<double> values;
  for (int i = 0; i < 3; ++i) {
    values.traction[i] = result.traction[i].value();
    values.friction[i] = result.friction[i].value();
    tangents.by_w.row(i) = result.traction[i].derivatives().template head<3>().transpose();
    if constexpr (n > 3) tangents.by_nu.row(i) = result.traction[i].derivatives().template tail<3>().transpose();
  }
  values.pressure = result.pressure.value();
  values.status = result.status;
  return values;
}

} // namespace

CarriedDistance CarriedDistance::of(const MasterSurface &master, const PointCoupling &coupling) {
  const Distance d = master.distance(coupling.y);
  if (coupling.carrier_face < 0) return {d.gap, d.normal, d.normal, d.curvature};
  const Vector3d nu = coupling.inverse.transpose() * d.normal;
  const double stretch = nu.norm(); // one but for the carrier's strain
  const Vector3d normal = nu / stretch;
  Eigen::Matrix2d bend; // of the carrier's displacement along the normal
  bend << coupling.second[0].dot(nu), coupling.second[1].dot(nu), coupling.second[1].dot(nu),
      coupling.second[2].dot(nu);
  const Matrix3d dnu =
      coupling.inverse.transpose() * d.curvature * coupling.inverse - coupling.dxi.transpose() * bend * coupling.dxi;
  const Matrix3d P = Matrix3d::Identity() - normal * normal.transpose();
  const double gap = d.gap / stretch;
  return {gap, normal, normal - gap / stretch * dnu.transpose() * normal, P * dnu / stretch, nu, stretch};
}

CoulombContact::Result<double> traction_at(const CoulombContact &law, const CarriedDistance &distance,
                                           const PointCoupling &coupling, const PointLoad &load,
                                           TractionTangents &tangents) {
  const auto differentiated = coupling.carrier_face >= 0 ? differentiate<6> : differentiate<3>;
  return differentiated(law, distance, coupling, load, tangents);
}

} // namespace rimpact::fe
