/// Where the joint at the rim's foot goes, and with it every law of the rim: the wall breaks off there, and forces
/// beyond are those of a rim in one piece with its plate. Finite elements tell the force of the rim at which the
/// joint's use passes 1 (responses/foot_report.h); it hangs on the joint, hardly on speed, mass or the steel's rate.
#pragma once
#include "scene/scene.h"
#include <cmath>
#include <limits>

namespace rimpact::reduced {

struct FootLimit {
  double force = std::numeric_limits<double>::infinity(); ///< of the rim [N], > 0; infinite: borne, or not known
  std::string joint;                                      ///< in words; empty: one piece with the plate

  bool is_known() const { return std::isfinite(force); } ///< otherwise no force need be asked
  bool gone(double rim_force) const { return rim_force > force; }
  /// "the rim breaks off its plate: the joint at its foot, ..., goes at 812 kN, and no law holds beyond".
  std::string sentence() const;
};

/// Of a scene's law: by its curve, whose push watched the joint, else by reduced.foot_force_kN, both only where they
/// are of the scene's own joint. Throws as rim_curve_of.
FootLimit foot_limit(const scene::Scene &scene);

/// Of a rim of rigid bodies: they have the joint of the calibration.
FootLimit foot_limit(const scene::ImpactElement &element);

/// Of a joint about which the law's numbers say nothing; empty: none.
std::string doubt_of_foot(const scene::Scene &scene);

/// The scene of a rim in one piece with its plate: of scouts, whose finite elements go on beyond the joint.
scene::Scene in_one_piece(scene::Scene scene);

} // namespace rimpact::reduced
