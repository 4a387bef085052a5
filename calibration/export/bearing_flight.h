/// An exported bearing under a ground motion along x and z, as the target program integrates it: dish, friction and rim
/// of the file, not of the model. An integrator of its own, apart from the reduced models'.
///
///   m (1 + p Q) u'' = -(V + m p' u'^2) Q - R - m a_gx,   N = V + m (p u'' + p' u'^2),   V = W + m a_gz >= 0,
///
/// with p the slope of what the slider rides on, Q its horizontal push per N (slope and friction), and R what does not
/// follow N: the table, the friction against the rise, the rim. A flat slider has p = 0: N = V; a sphere's restoring
/// force V r / R follows it, a table's W h' does not.
#pragma once
#include "calibration/export/contact.h"
#include "calibration/export/dish.h"
#include "scene/excitation.h"

namespace rimpact::calibration {

enum class Slider { rides, flat };

struct FlownBearing {
  Slider slider;
  const Dish *dish;
  double mass, weight, capacity; ///< [kg], [N], [m]
  MakeContact rim;               ///< of one side
  double stiffness;              ///< the rim's largest [N/m]
  bool keeps_dents = true;       ///< false: every touch meets a new rim
};

/// How a flight met the rim.
struct Arrival {
  double touch_speed = 0;    ///< of the first touch [m/s]; 0: none
  double peak_force = 0;     ///< of all touches [N]
  double largest_travel = 0; ///< [m]
  bool leaves = false;       ///< the flight ended beyond the dish
};
Arrival fly_bearing(const FlownBearing &bearing, const scene::GroundMotion &ground, double duration);

} // namespace rimpact::calibration
