#include "calibration/export/dish.h"
#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/riding_height.h"
#include "scene/assumptions.h"
#include "scene/measured_friction.h"
#include "scene/stack_terms.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

/// Park-Wen's state falls from -1 to 0 in a straight line over q, then nears 1 as exp(-x / q). It so misses 2.5 q mu N
/// of work at a turn; a bilinear element of slip s misses 2 s mu N.
constexpr double slip_of_equal_work = 1.25;
constexpr double rigid_slip = 2e-6; ///< of Coulomb's friction, which has none, for the element's sake [m]

std::vector<double> travels(double last) {
  std::vector<double> all = {0, 0.002 * last, 0.006 * last, 0.02 * last}; // finer where a truss of 1 mm turns
  constexpr int n = 24;
  for (int i = 1; i <= n; ++i) all.push_back(last * i / n);
  return all;
}

void set_friction(Dish &dish, const scene::Scene &scene, const reduced::RidingHeight &height, double capacity) {
  const auto &r = scene.reduced;
  scene::refuse_friction_beyond_speed(
      r.measured, "an exported dish",
      "the elements of OpenSees, SAP2000 and ETABS it is written for go by speed alone");
  const friction::FrictionLaw law = scene::sliding_law(scene); // of what slides, not of its faces
  const double at_rest = law.scale * r.mu_slow, at_speed = law.scale * r.mu_fast;
  const double socket = r.socket_friction ? scene.bearing.contact.steel_steel * reduced::socket_arm(scene.bearing) : 0;
  const auto per_reaction = [&](double mu) {
    return [&height, socket, mu](double x) {
      const double slope = height.at(x, 0).gradient.x();
      return (mu + socket * height.curvatures(x).meridional) * (1 + slope * slope);
    };
  };
  const auto slow = per_reaction(at_rest), fast = per_reaction(at_speed);
  const RidingFriction riding = riding_friction(dish.rider, capacity, fast);
  dish.rises = riding.rises, dish.ride_fast = riding.slides;
  dish.mu_slow = mean_to(capacity, slow), dish.mu_fast = mean_to(capacity, fast);
  dish.ride_slow = std::max(0.0, dish.ride_fast - (dish.mu_fast - dish.mu_slow));
  dish.face_slow = r.measured.scale * r.mu_slow, dish.face_fast = r.measured.scale * r.mu_fast;
  dish.face_rate = r.rate, dish.rate = law.face_share * r.rate;
  dish.elastic_slip = r.friction == scene::Friction::park_wen ? slip_of_equal_work * r.elastic_slip : rigid_slip;
  for (std::size_t i = 0; i < dish.travel.size(); ++i) {
    const double x = dish.travel[i], f = fast(x) / (1 + dish.slope[i] * dish.slope[i]);
    dish.left.push_back(dish.slope[i] - dish.rider.slope(x) + f * fast(x) * dish.slope[i]);
  }
}

std::vector<std::string> stack_of(const scene::ReducedSettings &r) {
  std::vector<std::string> all;
  if (r.finite_pad) all.push_back("the pad's size in the dish's table");
  if (r.socket_friction) all.push_back("the socket's friction in the coefficient of friction");
  if (r.friction == scene::Friction::park_wen)
    all.push_back(fmt::format("the pad's elastic slip, {:.3g} mm, as a slip of equal work", 1e3 * r.elastic_slip));
  return all;
}

} // namespace

double Dish::in_table(const std::vector<double> &column, double r) const {
  std::size_t i = 1;
  while (i + 1 < travel.size() && r > travel[i]) ++i;
  return column[i - 1] + (column[i] - column[i - 1]) * (r - travel[i - 1]) / (travel[i] - travel[i - 1]);
}

Dish dish_of(const scene::Scene &scene, double capacity) {
  const reduced::RidingHeight height(scene.bearing, scene.reduced.finite_pad ? scene.load.vertical : 0.0);
  const auto slope = [&](double r) { return height.at(r, 0).gradient.x(); };
  const double R = 1 / height.curvatures(0).meridional;
  const auto error = [&](double r) { return r / R / slope(r) - 1; };
  const double last = std::min(1.15 * capacity, 0.5 * (capacity + std::min(height.limit_radius(), 2 * capacity)));
  Dish dish{};
  dish.sphere = scene.bearing.surface.kind == scene::SurfaceKind::sphere, dish.radius = R;
  dish.error_half = error(capacity / 2), dish.error_full = error(capacity);
  dish.vertical_stiffness = scene::pad_stiffness(scene.bearing);
  if (const auto &pad = scene.bearing.pad; scene::has_default_pad(scene.bearing))
    dish.pad_remark = fmt::format(" That pad, {:g} x {:g} mm, is the built-in bearing's: this bearing gives none, an "
                                  "assumption.",
                                  2e3 * pad.outer_radius, 1e3 * pad.thickness);
  if (const double eta = scene.bearing.pad.loss_factor; eta > 0)
    dish.pad_remark +=
        fmt::format(" What the pad loses (loss factor {:g}) is left out: this spring is not damped.", eta);
  dish.travel = travels(last);
  for (const double r : dish.travel) dish.slope.push_back(r > 0 ? slope(r) : 0);
  dish.diagonal_error = std::sqrt(2.0) * slope(capacity / std::sqrt(2.0)) / slope(capacity) - 1;
  dish.rider = rider_of(dish.travel, dish.slope);
  set_friction(dish, scene, height, capacity);
  dish.stack = stack_of(scene.reduced);
  return dish;
}

} // namespace rimpact::calibration
