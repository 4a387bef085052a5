#include "fe_contact/runner/stack_model.h"

namespace rimpact::fe {
namespace {

using meshes::Surface;

/// Penalties of the softer side's stiffness over its cells' size.
SurfaceContactOptions frictional(double E, double cell, double mu) {
  return {{E / cell, E / cell, FrictionCoefficient::constant(mu)}};
}

} // namespace

StackModel::StackModel(const scene::Bearing &bearing, const meshes::StackMeshOptions &mesh)
    : half_(mesh.half), space_(meshes::stack_mesh(bearing, mesh), 2), solid_(space_, bearing) {
  Supports supports(space_);
  if (half_) supports.fix(Surface::symmetry, 1);
  for (int i = 0; i < 3; ++i)
    if (half_ && i == 1) {
      supports.fix(Surface::top, 1);
      top_[1] = -1;
    } else {
      top_[i] = supports.tie(Surface::top, i);
    }
  system_.emplace(space_, solid_, supports.number());
  const double h = meshes::size_factor(mesh.level);
  constexpr double pad_cell = 0.012, cap_cell = 0.020; // at level 1 [m]
  const std::shared_ptr<const scene::SlidingSurface> surface = scene::make_surface(bearing.surface);
  system_->add_contact(Surface::pad_face, fe::dish(surface, bearing.surface.planar_radius),
                       frictional(bearing.ertalyte.E, pad_cell * h, bearing.contact.steel_ertalyte));
  // The socket does not turn, so it carries the sphere; the foot's cap turns under it.
  auto joint = frictional(bearing.steel.E, cap_cell * h, bearing.contact.steel_steel);
  joint.carrier_faces = Surface::socket;
  system_->add_contact(Surface::foot_cap, sphere(Eigen::Vector3d::Zero(), bearing.foot.cap_radius, Side::inside), joint);
}

Eigen::Vector3d StackModel::top_of(const Eigen::VectorXd &by_equation) const {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (top_[i] >= 0) result[i] = by_equation[top_[i]];
  return result;
}

Eigen::VectorXd StackModel::dead_load(double vertical) const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(system_->equations().n);
  load[top_[2]] = -vertical / share();
  return load;
}

} // namespace rimpact::fe
