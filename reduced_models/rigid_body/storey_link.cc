#include "reduced_models/rigid_body/storey_link.h"

namespace rimpact::reduced::rigid {

using Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;

namespace {

/// -dF/dv of the body above, its position following with the weight.
Matrix3d slope(const Storey &storey, double weight, const Matrix2d &d_z) {
  const double elastic = storey.hysteresis ? storey.hysteresis->post_yield : 1.0;
  Matrix3d S = Matrix3d::Zero();
  S.topLeftCorner<2, 2>() = (weight * elastic * storey.stiffness + storey.damping) * Matrix2d::Identity();
  if (storey.hysteresis) S.topLeftCorner<2, 2>() += (1 - elastic) * storey.stiffness * storey.hysteresis->yield * d_z;
  S(2, 2) = weight * storey.axial_stiffness + storey.axial_damping;
  return S;
}

} // namespace

void add_links(const System &system, const Poses &poses, const Vector &velocity, const LinkStage &stage,
               std::vector<LinkForce> &link, Vector &sum, Matrix *tangent) {
  link.resize(system.links.size());
  for (std::size_t i = 0; i < link.size(); ++i) {
    const auto &[storey, below, above] = system.links[i];
    const Vector3d drift = poses[above].position - poses[below].position;
    const Vector3d rate = velocity.segment<3>(6 * above) - velocity.segment<3>(6 * below);
    LinkForce &f = link[i];
    Matrix2d d_z = Matrix2d::Zero();
    f.z = stage.z0[i];
    if (storey.hysteresis && stage.step > 0) {
      const auto step = storey.hysteresis->implicit_step(stage.z0[i], rate.head<2>(), stage.step);
      f.z = step.z, d_z = step.d_rate;
    }
    f.force = storey.force(drift, rate, f.z);
    f.damping_power = storey.damping_power(rate), f.hysteretic_power = storey.hysteretic_power(rate, f.z);
    f.elastic_energy = storey.elastic_energy(drift, f.z), f.hysteretic_energy = storey.hysteretic_energy(f.z);
    sum.segment<3>(6 * above) += f.force, sum.segment<3>(6 * below) -= f.force;
    if (!tangent) continue;
    const Matrix3d S = slope(storey, stage.position_weight, d_z);
    tangent->block<3, 3>(6 * above, 6 * above) -= S, tangent->block<3, 3>(6 * below, 6 * below) -= S;
    tangent->block<3, 3>(6 * above, 6 * below) += S, tangent->block<3, 3>(6 * below, 6 * above) += S;
  }
}

} // namespace rimpact::reduced::rigid
