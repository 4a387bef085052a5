// The slider comes to the rim where the plan meshed none: the run goes on from there on a mesh with one more sector.
#include "fe_contact/drive/sliding_run.h"

#include "fe_contact/drive/top_drive.h"
#include "fe_contact/engine/mesh_transfer.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

SolidEnergies energies_at(const BearingModel &model, const BearingSystem &system, const Eigen::VectorXd &displacements,
                          const SolidHistory &history) {
  SolidHistory same;
  SolidEnergies result;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(system.equations().n);
  if (!model.solid.assemble(displacements, history, same, system.equations(), forces, nullptr, result))
    throw SolverStopped("the state could not be carried over to the mesh with one more sector: a cell is inverted "
                        "there; try rung `rim`, which meshes any side");
  return result;
}

/// Multipliers of pad and foot, whose slave faces are the same in both meshes; the rim's begin anew.
void carry_contacts(const SystemState &old, const BearingSystem &system, SystemState &state) {
  for (const Role role : system.roles()) {
    if (role == Role::wall) continue;
    const std::size_t i = system.contact_of(role).value();
    if (old.contacts[i].multiplier.size() != state.contacts[i].multiplier.size())
      throw SolverStopped(
          "the state could not be carried over to the mesh with one more sector: pad or cap have other points there");
    state.contacts[i] = system.contact(i).carried(old.contacts[i], system.expand(state));
  }
}

/// Interpolated stresses do not balance: the parts would ring with what is missing. So they take the accelerations they
/// have as dead loads and come to balance, with the top face where it is.
void balance(BearingSystem &system, SystemState &state, const Eigen::VectorXd &load, const StepOptions &options) {
  const Eigen::Vector3d top = system.top_of(state.u);
  const ContactStepReport step =
      TopDrive().move_to(system, state, {top.head<2>(), {}}, load - system.mass_times(state.a), options);
  if (!step.converged)
    throw SolverStopped("the state could not be brought to balance on the mesh with one more sector: " + step.reason +
                        "; try rung `rim`, which meshes any side");
  state.R = system.mass_times(state.a);
}

} // namespace

std::optional<double> SlidingRun::unmeshed_direction() {
  constexpr double served = 0.15; // cells grow away from a sector's middle [rad]
  const Eigen::Vector3d u = travel();
  const double direction = std::atan2(u.y(), u.x()),
               reach = scene_.model.own_mesh.any() ? plan_.sector_half_angle - 0.3 : served;
  const auto serves = [&](double sector) { return std::abs(std::remainder(direction - sector, 2 * M_PI)) < reach; };
  if (std::any_of(plan_.sectors.begin(), plan_.sectors.end(), serves)) return {};
  if (!scene_.model.own_mesh.any()) return model_.mesh.half ? (u.x() < 0 ? M_PI : 0.0) : direction;
  save();
  throw SolverStopped(
      fmt::format("at t = {:.4f} s the slider comes to the rim at {:.0f} deg, where the scout saw no impact and the "
                  "own mesh is not known to "
                  "have a rim; partial results are kept; without an own mesh the run would replan itself",
                  t_, direction * 180 / M_PI));
}

void SlidingRun::take_over(const SlidingRun &old) {
  const MeshTransfer transfer(old.model_.space, model_.space);
  state_ = active().at_rest();
  const auto moved = [&](const Eigen::VectorXd &values) {
    return active().equations().gather(transfer.nodal(old.active().equations().expand(values)));
  };
  state_.u = moved(old.state_.u), state_.v = moved(old.state_.v), state_.a = moved(old.state_.a);
  state_.history = transfer.history(old.state_.history);
  carry_contacts(old.state_, active(), state_);
  if (!all_solid() && old.held_.displacement.size()) held_.displacement = transfer.nodal(old.held_.displacement);
  balance(active(), state_, load(old.t_), motion_.step);
  if (!all_solid()) {
    const SolidEnergies all = energies_at(model_, joined_, displacements(), state_.history);
    held_.energies = {all.elastic - state_.energies.elastic, all.plastic - state_.energies.plastic};
  }
  t_ = old.t_, rest_height_ = old.rest_height_, rest_elastic_ = old.rest_elastic_, rest_plastic_ = old.rest_plastic_;
  scale_ = old.scale_, height_before_ = travel().z();
  next_step_ = motion_.contact_step;
  const double lost = book_hand_over(old);
  record_.n_dofs = joined_.equations().n;
  record_.warnings.push_back(fmt::format(
      "at {:.3f} s the slider came to the rim at {:.0f} deg, where the scout saw no impact: replanned, from there on "
      "with "
      "{} sectors and {} unknowns; the hand-over to the new mesh changed the energy by {:.1e} of the largest input",
      t_, plan_.sectors.back() * 180 / M_PI, plan_.sectors.size(), record_.n_dofs,
      lost / std::max(record_.ledger.largest_input, 1e-300)));
  save();
}

/// What the new mesh stores less than the old one is the numerics' loss. Returns its amount [J].
double SlidingRun::book_hand_over(const SlidingRun &old) {
  EnergyLedger &ledger = record_.ledger;
  const EnergyLedger before = ledger;
  const double share = model_.share(), sunk = scene_.load.vertical * (old.height_before_ - height_before_);
  ledger.kinetic = share * active().kinetic_energy(state_);
  ledger.elastic = share * (state_.energies.elastic + held_.energies.elastic) - rest_elastic_;
  ledger.plastic = share * (state_.energies.plastic + held_.energies.plastic) - rest_plastic_;
  ledger.damping = share * state_.energies.damping;
  const double lost = before.kinetic - ledger.kinetic + before.elastic - ledger.elastic + before.plastic -
                      ledger.plastic + before.damping - ledger.damping + sunk;
  ledger.integrator += lost;
  ledger.gravity -= sunk;
  return std::abs(lost);
}

} // namespace rimpact::fe
