/// What a step did to the energies, and its place in a run's ledger. Systems may be a part of the bearing: a mirror's
/// half, or without bodies that are held; the ledger is always of the whole.
#pragma once
#include "fe_contact/engine/contact_system.h"
#include "responses/summary.h"
#include <optional>
#include <string>

namespace rimpact::fe {

struct ContactStepReport;

/// Of the whole bearing [J]; signs as in EnergyLedger.
struct StepEnergies {
  double external = 0, gravity = 0, friction = 0, contact = 0, integrator = 0; ///< what the step adds to these entries
  double kinetic = 0, elastic = 0, plastic = 0, damping = 0;                   ///< what these are at its end
  /// Energy that came from nowhere, or got lost.
  double unbalanced(const EnergyLedger &before) const;
};

/// Of a solved step of a system that is the `share`th part of the whole; the loads' work is left to those who know the
/// loads.
StepEnergies energies_of(const ContactSystem &system, const SystemState &state, const ContactStepReport &step,
                         double share);
/// The ledger of a motion that begins at a state.
EnergyLedger ledger_at(const ContactSystem &system, const SystemState &state);
void book(EnergyLedger &ledger, const StepEnergies &step);
/// A sentence where a run in time, at t [s], leaves more than 5 % of the energy put in unaccounted for while a rim is
/// pressed: what follows is no result.
std::optional<std::string> loss_of_balance(const EnergyLedger &ledger, double t);

} // namespace rimpact::fe
