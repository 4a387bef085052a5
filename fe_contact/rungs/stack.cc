#include "fe_contact/rungs/stack.h"

namespace rimpact::fe {
namespace {

using meshes::Surface;

/// Penalties of the softer side's stiffness over its cells' size.
SurfaceContactOptions frictional(double E, double cell, const FrictionCoefficient &mu) {
  return {{E / cell, E / cell, mu}};
}

/// What is held, and the top face's components as the first equations.
Supports supports_of(const StackModel &model, bool with_rim) {
  Supports supports(model.space);
  for (int i = 0; i < 3; ++i)
    if (model.mesh.half && i == 1)
      supports.fix(Surface::top, i);
    else
      supports.tie(Surface::top, i);
  if (model.mesh.half) supports.fix(Surface::symmetry, 1);
  if (with_rim) {
    for (int i = 0; i < 3; ++i)
      for (const Surface group : {Surface::fixed, Surface::sector_end}) supports.fix(group, i);
  } else {
    for (const auto volume : {meshes::Volume::rim, meshes::Volume::plate}) supports.fix(volume);
  }
  return supports;
}

} // namespace

StackModel::StackModel(const scene::Bearing &bearing, const meshes::StackMeshOptions &mesh, bool friction,
                       double penalty_scale)
    : bearing(bearing), mesh(mesh), friction(friction), penalty_scale(penalty_scale),
      space(meshes::stack_mesh(bearing, mesh), 2), solid(space, bearing) {}

double StackModel::own_mass() const {
  double mass = 0;
  for (const auto volume : {meshes::Volume::pad, meshes::Volume::foot, meshes::Volume::upper_slider})
    mass += share() * solid.mass_of(volume);
  return mass;
}

StackSystem::StackSystem(const StackModel &model, bool with_rim)
    : StackSystem(model, with_rim, supports_of(model, with_rim)) {}

StackSystem::StackSystem(const StackModel &model, bool with_rim, Supports supports)
    : ContactSystem(model.space, model.solid, supports.number()), model_(model), with_rim_(with_rim) {
  const unsigned any = model.space.nodes_of(Surface::top).front();
  for (int i = 0; i < 3; ++i) top_.equation[i] = equations().of_dof[3 * any + i];
  const scene::Bearing &bearing = model.bearing;
  const double reach = meshes::size_factor(model.mesh.level) / model.penalty_scale;
  constexpr double pad_cell = 0.012, cap_cell = 0.020, wall_cell = 0.010; // at level 1 [m]
  const scene::ContactFriction &mu = bearing.contact;
  const auto friction = [&](double fast, const std::optional<double> &slow) {
    return model.friction ? FrictionCoefficient{fast, slow.value_or(fast), mu.rate} : FrictionCoefficient{};
  };
  const std::shared_ptr<const scene::SlidingSurface> surface = scene::make_surface(bearing.surface);
  auto sliding = frictional(bearing.ertalyte.E, pad_cell * reach, friction(mu.steel_ertalyte, mu.steel_ertalyte_slow));
  if (model.full()) sliding.carrier_faces = Surface::dish;
  add_contact(Surface::pad_face, fe::dish(surface, bearing.surface.planar_radius), sliding);
  // The socket does not turn, so it carries the sphere; the foot's cap turns under it.
  auto joint = frictional(bearing.steel.E, cap_cell * reach, friction(mu.steel_steel, mu.steel_steel_slow));
  joint.carrier_faces = Surface::socket;
  add_contact(Surface::foot_cap, sphere(Eigen::Vector3d::Zero(), bearing.foot.cap_radius, Side::inside), joint);
  if (!with_rim) return;
  auto wall = frictional(bearing.steel.E, wall_cell * reach, {mu.rim, mu.rim_slow.value_or(mu.rim), mu.rate});
  wall.carrier_faces = Surface::rim_wall;
  add_contact(Surface::slider_side,
              cylinder(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(),
                       bearing.surface.planar_radius + bearing.rim.ledge, Side::inside),
              wall);
}

void StackSystem::carry(double mass) {
  add_mass(3 * model_.space.nodes_of(Surface::top).front(), mass / model_.share());
}

Eigen::VectorXd StackSystem::dead_load(double vertical) const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(equations().n);
  load[top_.equation[2]] = -vertical / model_.share();
  return load;
}

} // namespace rimpact::fe
