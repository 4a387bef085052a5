#include "fe_contact/rungs/rigid_dish.h"

#include "fe_contact/rungs/bearing_model.h"
#include "fe_contact/rungs/middle_plane.h"
#include "fe_contact/rungs/rim.h"
#include "meshes/stack_mesh.h"
#include <algorithm>

namespace rimpact::fe {

using meshes::Surface;

const Rung rungs::rigid_dish{
    .name = scene::Rung::rigid_dish,
    .dish = DishKind::exact,
    .carried = stack_bodies(),
    .mesh = meshes::stack_mesh,
    .hold = hold_plate,
    .pairs = stack_pairs,
    .steps = stack_steps(),
};

StepOptions stack_steps() {
  StepOptions options;
  options.newton.tolerance = 1e-5;
  options.newton.finest_forcing = 1e-3;
  options.tolerance_between = 1e-3;
  options.gap_tolerance = 1e-5;
  options.slip_tolerance = 1e-5;
  options.max_augmentations = 4;
  return options;
}

void hold_plate(Supports &supports, RimState rim) {
  if (rim == RimState::held)
    for (const auto volume : {meshes::Volume::rim, meshes::Volume::plate}) supports.fix(volume);
  else
    for (int i = 0; i < 3; ++i)
      for (const Surface group : {Surface::fixed, Surface::sector_end}) supports.fix(group, i);
}

namespace {

/// The pad's back on the recess's bottom and its edge within the recess's wall, which turn with the foot.
std::vector<Pair> seat_pairs(const scene::Bearing &bearing, const SurfaceContactOptions &on_steel) {
  std::vector<Pair> pairs{
      {Role::seat, Surface::pad_top, plane({0, 0, bearing.pad.thickness}, {0, 0, -1}), on_steel},
      {Role::recess, Surface::pad_side,
       cylinder(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), bearing.recess_radius(), Side::inside), on_steel}};
  pairs[0].options.carrier_faces = Surface::foot_seat;
  pairs[1].options.carrier_faces = Surface::foot_recess;
  return pairs;
}

/// The pad's face, or that of a slider between two dishes.
Pair face_on_dish(const BearingModel &model, const FrictionCoefficient &mu) {
  constexpr double pad_cell = 0.012; // at level 1 [m]
  const scene::Bearing &bearing = model.bearing;
  // The pad's pressure changes by megapascals a step: four times as stiff its gap stays below a tolerance. Who asks for
  // a stiffer contact has that by itself.
  const double pad_stiffer = std::clamp(4 / model.options.penalty_scale, 1.0, 4.0);
  return {Role::dish, Surface::pad_face, fe::dish(scene::make_surface(bearing.surface), bearing.surface.planar_radius),
          bearing.has_pad() ? penalised(model, bearing.ertalyte.E, pad_cell, mu, pad_stiffer)
                            : steel_on_steel(model, mu)};
}

} // namespace

std::vector<Pair> stack_pairs(const BearingModel &model, RimState rim) {
  const scene::Bearing &bearing = model.bearing;
  constexpr double cap_cell = 0.020, wall_cell = 0.010; // at level 1 [m]
  const scene::ContactFriction &mu = bearing.contact;
  const auto friction = [&](double fast, const std::optional<double> &slow) {
    return model.options.friction ? FrictionCoefficient{fast, slow.value_or(fast), mu.rate, {}} : FrictionCoefficient{};
  };
  FrictionCoefficient on_dish = friction(mu.steel_ertalyte, mu.steel_ertalyte_slow);
  on_dish.reference_pressure = mu.reference_pressure;
  std::vector<Pair> pairs{face_on_dish(model, on_dish)};
  if (bearing.has_pad()) {
    pairs.push_back({Role::socket, Surface::foot_cap,
                     sphere(Eigen::Vector3d::Zero(), bearing.foot.cap_radius, Side::inside),
                     penalised(model, bearing.steel_of(scene::SteelPart::slider).E, cap_cell,
                               friction(mu.steel_steel, mu.steel_steel_slow))});
    // The socket does not turn, so it carries the sphere; the foot's cap turns under it.
    pairs.back().options.carrier_faces = Surface::socket;
    if (bearing.pad_is_seated())
      for (const Pair &pair : seat_pairs(bearing, pairs.front().options)) pairs.push_back(pair);
  }
  if (model.slips()) pairs.push_back(halves_pair(model));
  if (rim == RimState::solid)
    for (const Pair &pair : wall_pairs(model, wall_cell, 1)) pairs.push_back(pair);
  return pairs;
}

} // namespace rimpact::fe
