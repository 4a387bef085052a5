#include "fe_contact/drive/ledger.h"

#include "fe_contact/engine/contact_steps.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {

double StepEnergies::unbalanced(const EnergyLedger &before) const {
  return external - gravity - (kinetic - before.kinetic) - (elastic - before.elastic) - (plastic - before.plastic) -
         (damping - before.damping) - friction - contact - integrator;
}

StepEnergies energies_of(const ContactSystem &system, const SystemState &state, const ContactStepReport &step,
                         double share) {
  StepEnergies result;
  for (const auto &report : state.reports) {
    result.friction += share * report.friction_work;
    result.contact += share * report.normal_work;
  }
  result.integrator = share * step.integrator_loss;
  result.kinetic = share * system.kinetic_energy(state);
  result.elastic = share * state.energies.elastic;
  result.plastic = share * state.energies.plastic;
  result.damping = share * state.energies.damping;
  return result;
}

EnergyLedger ledger_at(const ContactSystem &system, const SystemState &state) {
  EnergyLedger ledger;
  ledger.kinetic = system.kinetic_energy(state);
  ledger.elastic = state.energies.elastic;
  ledger.plastic = state.energies.plastic;
  ledger.damping = state.energies.damping;
  ledger.initial = ledger.largest_input = ledger.kinetic + ledger.elastic + ledger.plastic;
  return ledger;
}

void book(EnergyLedger &ledger, const StepEnergies &step) {
  ledger.external += step.external;
  ledger.gravity += step.gravity;
  ledger.friction += step.friction;
  ledger.contact += step.contact;
  ledger.integrator += step.integrator;
  ledger.kinetic = step.kinetic;
  ledger.elastic = step.elastic;
  ledger.plastic = step.plastic;
  ledger.damping = step.damping;
  ledger.largest_input = std::max(ledger.largest_input, ledger.initial + std::abs(ledger.external));
}

std::optional<std::string> loss_of_balance(const EnergyLedger &ledger, double t) {
  constexpr double most = 0.05, nothing = 1; // of the energy put in; [J]
  const double left = ledger.imbalance_relative();
  if (std::abs(left) <= most || ledger.largest_input < nothing) return {};
  return fmt::format(
      "{:.0f} % of the energy put in is unaccounted for at t = {:.5g} s, while the rim is pressed. Nothing "
      "after the touch is a result; a finer mesh (--mesh) may carry it",
      100 * std::abs(left), t);
}

} // namespace rimpact::fe
