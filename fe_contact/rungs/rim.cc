#include "fe_contact/rungs/rim.h"

#include "fe_contact/rungs/bearing_model.h"
#include "meshes/rim_mesh.h"
#include <algorithm>

namespace rimpact::fe {
namespace {

using meshes::Surface;

void hold_sector(Supports &supports, RimState) {
  for (int i = 0; i < 3; ++i) supports.fix(Surface::fixed, i);
  supports.slide_on(Surface::sector_end);
}

/// The edge of a slider between two dishes lies on its dish: squeezed, it cannot give way downwards.
Pair edge_on_dish(const BearingModel &model, SurfaceContactOptions options) {
  const scene::ContactFriction &mu = model.bearing.contact;
  options.law.friction =
      FrictionCoefficient{mu.steel_ertalyte, mu.steel_ertalyte_slow.value_or(mu.steel_ertalyte), mu.rate, {}};
  options.carrier_faces = Surface::dish;
  return {Role::dish, Surface::slider_side,
          dish(scene::make_surface(model.bearing.surface), model.bearing.surface.planar_radius), options};
}

std::vector<Pair> wall_alone(const BearingModel &model, RimState) {
  // An edge bites on cells of its rounding's size; ten times as stiff, contact gives back a third of the energy that it
  // gave back before, in three fifths of the iterations (window of 0.1 m/s on dcfp-155).
  const bool edge = model.bearing.double_concave();
  Pair wall = wall_pair(model, edge ? 0.0025 : 0.006, edge ? 16 : 4);
  wall.options.margin = 0.003; // the slider comes and goes radially and moves little along the wall [m]
  if (!model.bearing.double_concave()) return {wall};
  return {wall, edge_on_dish(model, wall.options)};
}

StepOptions rim_steps() {
  StepOptions options;
  options.newton.tolerance = 1e-5;
  options.newton.max_iterations = 15;
  options.newton.finest_forcing = 1e-6;
  options.newton.first_forcing = 1e-3;
  options.newton.eliminates = true; // thin cells of the slider's edge
  options.gap_tolerance = options.slip_tolerance = 3e-5;
  options.max_augmentations = 3;
  options.expects = true;
  return options;
}

} // namespace

const Rung rungs::rim{
    .name = scene::Rung::rim,
    .dish = DishKind::law,
    .carried = {meshes::Volume::upper_slider},
    .mesh = meshes::rim_mesh,
    .hold = hold_sector,
    .pairs = wall_alone,
    .steps = rim_steps(),
};

Pair wall_pair(const BearingModel &model, double cell, double stiffer) {
  const scene::Bearing &bearing = model.bearing;
  const scene::ContactFriction &mu = bearing.contact;
  const double softer = std::min(bearing.rim_steel().E, bearing.steel_of(scene::SteelPart::slider).E);
  SurfaceContactOptions options =
      penalised(model, softer, cell, {mu.rim, mu.rim_slow.value_or(mu.rim), mu.rate}, stiffer);
  options.carrier_faces = Surface::rim_wall;
  const double radius = bearing.wall_radius();
  return {Role::wall, Surface::slider_side,
          cylinder(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), radius, Side::inside), options};
}

} // namespace rimpact::fe
