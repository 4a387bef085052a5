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

std::vector<Pair> wall_alone(const BearingModel &model, RimState) {
  std::vector<Pair> pairs = wall_pairs(model, 0.006, 4);
  // The slider comes and goes radially and moves little along the wall.
  for (Pair &pair : pairs) pair.options.margin = 0.003; // [m]
  return pairs;
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

namespace {

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

/// The edge of a slider between two dishes lies on its dish: squeezed, it cannot give way downwards.
Pair edge_on_dish(const BearingModel &model, SurfaceContactOptions options) {
  const scene::ContactFriction &mu = model.bearing.contact;
  options.law.friction =
      FrictionCoefficient{mu.steel_ertalyte, mu.steel_ertalyte_slow.value_or(mu.steel_ertalyte), mu.rate, {}};
  options.law.friction.reference_pressure = mu.reference_pressure;
  if (model.turns() && !model.options.friction) options.law.friction = {}; // as the face beside it
  options.carrier_faces = Surface::dish;
  return {Role::edge, Surface::slider_side,
          dish(scene::make_surface(model.bearing.surface), model.bearing.surface.planar_radius), options};
}

} // namespace

std::vector<Pair> wall_pairs(const BearingModel &model, double cell, double stiffer) {
  if (!model.bearing.double_concave()) return {wall_pair(model, cell, stiffer)};
  // An edge bites on cells of its rounding's size; ten times as stiff, contact gives back a third of the energy that it
  // gave back before, in three fifths of the iterations (window of 0.1 m/s on dcfp-155).
  const Pair wall = wall_pair(model, 0.0025, 16);
  return {wall, edge_on_dish(model, wall.options)};
}

} // namespace rimpact::fe
