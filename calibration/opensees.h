/// A calibrated rim as OpenSees springs: Tcl and Python (openseespy) with the values, one material and a
/// procedure that puts n gap springs around the slider. SI (N, m, s, kg).
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rimpact::calibration {

struct RimSprings {
  std::string law;
  double k_i = 0;              ///< [N/m], > 0
  double restitution = 1;      ///< [-]; 1 where the law has none
  double damping = 0;          ///< c_i [N s/m]
  double mass = 0;             ///< supported, m1 [kg]; m2, the rim, is fixed
  double lateral_capacity = 0; ///< where the rim begins [m], > 0
  double exponent = 1;         ///< hunt-crossley [-]
  double reference_speed = 0;  ///< hunt-crossley, elastoplastic [m/s], > 0
  double yield_force = 0;      ///< elastoplastic [N]
  double hardening = 0;        ///< elastoplastic [-]
  double hardening_exponent = 0.75; ///< elastoplastic [-]
  std::vector<std::string> remarks{}; ///< how far the values are known and hold, sentences
};
/// From calibration.json. Throws DataError naming the key that is missing.
RimSprings rim_springs(const nlohmann::json &calibration);

/// Bilinear spring that stands for the elastoplastic law, whose load path bends further: both stop the
/// supported mass at the reference speed at the same penetration with the same force.
struct Bilinear {
  double yield_force; ///< [N]
  double hardening;   ///< tangent beyond yield over k_i [-]
};
Bilinear bilinear_of(const RimSprings &rim);

/// What n plane springs make of a round rim.
struct PolygonError {
  double gap;   ///< touch between two springs comes later by this travel [m]: L_c (1 / cos(pi / n) - 1)
  double force; ///< worst relative error of the force over all directions, at `penetration` [-]
};
/// n >= 3; penetration [m] > 0 beyond L_c. The springs are linear; several act at once where they overlap.
PolygonError polygon_error(int n, double lateral_capacity, double penetration);

/// `n` >= 4 springs, evenly around; 2: along the x axis, exact for motion along it. Throws InputError otherwise,
/// DataError for a law that OpenSees has no material for.
std::string opensees_tcl(const RimSprings &rim, int n);
std::string opensees_python(const RimSprings &rim, int n);

} // namespace rimpact::calibration
