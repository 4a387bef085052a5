/// What one step of the touched walls did to the whole bearing: energies, works, errors.
#pragma once
#include "fe_contact/drive/ledger.h"
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

  Eigen::Vector3d travel() const;                                                             ///< of the mass [m]
  double work(const Eigen::Vector3d &force_before, const Eigen::Vector3d &force_after) const; ///< trapezoidal [J]
  StepEnergies energies(const ContactStepReport &report) const;                               ///< the ledger's
  /// Work of the dish, a constraint on the mass, of which the ledger has no entry [J].
  double work_of_dish() const { return work(before.pendular, after.pendular); }
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
