/// The sliding part of a bearing for other programs: restoring force of the dish, friction, stiffness under the weight.
///
/// Restoring force under the dead load W at travel r: W h'(r), h the surface's meridian. Elements of other programs
/// know W r / R only: close for a sphere, wrong far out for every other dish, so these are given as a table.
#pragma once
#include "scene/scene.h"

namespace rimpact::calibration {

struct Dish {
  bool sphere;                       ///< R is the sphere's; else of the vertex
  double radius;                     ///< R [m], > 0
  std::vector<double> travel, slope; ///< h'(r) [-] from r = 0 past the rim's beginning; odd in r
  double error_half, error_full;     ///< of r / R for h'(r) at L_c / 2 and L_c, relative [-]
  double diagonal_error;             ///< of two springs along x and y with this table, in between, at L_c [-]
  double mu_slow, mu_fast, rate;     ///< rate [s/m]; not read where the two are equal
  double elastic_slip;               ///< travel over which friction builds up [m], > 0
  double vertical_stiffness;         ///< of the pad alone, E A / thickness [N/m]
  std::string assumed_pad = {};      ///< a sentence, where the pad is not the bearing's own

  double slope_at(double r) const;                                                              ///< linear in the table
  double initial_stiffness(double vertical) const { return mu_fast * vertical / elastic_slip; } ///< of friction [N/m]
  std::vector<std::string> lines(double vertical) const; ///< sentences of what is approximated
};
/// `capacity`: where the rim begins [m].
Dish dish_of(const scene::Scene &scene, double capacity);

} // namespace rimpact::calibration
