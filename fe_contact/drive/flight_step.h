/// What one step of the touched walls left behind on the whole bearing: energies, works, errors.
#pragma once
#include "fe_contact/rungs/bearing_model.h"
#include "fe_contact/rungs/mass_loads.h"
#include "fe_contact/rungs/rim_frame.h"
#include <optional>
#include <string>

namespace rimpact::fe {

/// A step from `old` to `now`, and the forces on the mass at both ends.
struct FlightStep {
  const BearingSystem &system;
  const RimFrame &frame;
  const SystemState &old, &now;
  const MassForces &before, &after;
  double integrator_loss; ///< of the model [J]

  Eigen::Vector3d travel() const;                                                             ///< of the mass [m]
  double work(const Eigen::Vector3d &force_before, const Eigen::Vector3d &force_after) const; ///< trapezoidal [J]
  /// Energy that nothing accounts for: the trapezoidal work of the forces against what is stored, moving and lost [J].
  double unbalanced() const;
  /// Local error of the top face's radial displacement, of generalised-alpha's beta [m].
  double displacement_error(double rho_inf, double dt) const;
};

/// A sentence where the slider passes the rim: it is folded over, or has let go of a slider that still moves outwards.
/// A rim that has hardly been pushed is not passed: there the walls part and meet again, and the sentence says so.
struct Passage {
  double depth;         ///< beyond L_c [m]
  double outward_speed; ///< [m/s]
  double approach_speed;
  bool let_go;    ///< touched before, and nothing bears now
  bool may_touch; ///< walls may part for an instant at first touch, the slider still coming on: it is touched again
};
std::optional<std::string> passes(const scene::Rim &rim, const Passage &passage, double t);

} // namespace rimpact::fe
