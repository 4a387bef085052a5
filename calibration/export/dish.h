/// The sliding part of a bearing for other programs: restoring force of the dish, friction, stiffness under the weight.
///
/// Two forms. OpenSees' slider rides on an ellipsoid (rider.h), and a table holds what that leaves of the dish. Links
/// of SAP2000 and ETABS slide in a plane: their restoring force is W h'(r) at travel r under the dead load W, h the
/// slider's height with what the pad's size adds. They know W r / R beside it: close for a sphere alone.
#pragma once
#include "calibration/export/rider.h"
#include "scene/scene.h"

namespace rimpact::calibration {

struct Dish {
  bool sphere;                       ///< R is the sphere's; else of the vertex
  double radius;                     ///< R [m], > 0
  std::vector<double> travel, slope; ///< h'(r) [-] from r = 0 past the rim's beginning; odd in r
  double error_half, error_full;     ///< of r / R for h'(r) at L_c / 2 and L_c, relative [-]
  double diagonal_error;             ///< of two springs along x and y with this table, in between, at L_c [-]
  Rider rider;
  std::vector<double> left;       ///< of the restoring force over W, what the ellipsoid leaves [-], at `travel`
  double mu_slow, mu_fast, rate;  ///< of a flat slider: mean from the centre to the rim; rate [s/m]: see is_coulomb
  double ride_slow, ride_fast;    ///< of the riding slider's sliding element [-]
  double rises;                   ///< its friction against the rise, over W p [-]
  double face_slow, face_fast;    ///< of the sliding face itself, as the scene has them [-]
  double face_rate;               ///< likewise [s/m]
  double elastic_slip;            ///< travel over which friction builds up [m], > 0
  double vertical_stiffness;      ///< of the pad alone, E A / thickness [N/m]
  std::vector<std::string> stack; ///< sentences: which terms of pad and socket are in it
  /// Sentences, each after a blank: a pad that is not the bearing's own, a loss that the spring has not.
  std::string pad_remark = {};

  bool is_coulomb() const { return face_slow == face_fast; } ///< `rate` is not read
  double slope_at(double r) const { return in_table(slope, r); }
  double left_at(double r) const { return in_table(left, r); }
  double flat_stiffness(double vertical) const { return mu_fast * vertical / elastic_slip; } ///< of friction [N/m]
  double ride_stiffness(double vertical) const { return ride_fast * vertical / elastic_slip; }

private:
  double in_table(const std::vector<double> &column, double r) const; ///< linear in `travel`, r >= 0
};
/// `scene`: bearing, load and, of [reduced], friction and the terms of pad and socket. `capacity`: where the rim begins
/// [m].
Dish dish_of(const scene::Scene &scene, double capacity);

} // namespace rimpact::calibration
