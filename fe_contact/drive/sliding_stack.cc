#include "fe_contact/drive/sliding_stack.h"

#include "fe_contact/drive/top_drive.h"
#include "fe_contact/engine/mesh_transfer.h"
#include "io/files/error.h"

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
  result.elastic += system.ties().energy(system.equations().gather(displacements));
  return result;
}

/// Multipliers of pad and foot, or of a slider between two dishes, whose slave faces are the same in both meshes; the
/// rim's begin anew.
void carry_contacts(const SystemState &old, const BearingSystem &system, SystemState &state) {
  for (const Role role : system.roles()) {
    if (role == Role::wall || role == Role::edge) continue;
    const std::size_t i = system.contact_of(role).value();
    if (old.contacts[i].multiplier.size() != state.contacts[i].multiplier.size())
      throw SolverStopped(
          "the state could not be carried over to the mesh with one more sector: pad or cap have other points there");
    state.contacts[i] = system.contact(i).carried(old.contacts[i], system.expand(state));
  }
}

} // namespace

SlidingStack::SlidingStack(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan)
    : model_(rung, scene.bearing, mesh_order(scene, plan), model_options(scene)),
      alone_(model_, scene.load.mass, RimState::held), joined_(model_, scene.load.mass, RimState::solid) {}

Eigen::VectorXd SlidingStack::displacements() const {
  Eigen::VectorXd u = active().expand(state);
  if (!rim_is_solid() && held.displacement.size()) u += held.displacement;
  return u;
}

Eigen::Vector3d SlidingStack::travel() const {
  return model_.rate_ratio * (active().top_of(state.u) - Eigen::Vector3d(0, 0, rest_height));
}

Eigen::Vector2d SlidingStack::ridden() const {
  return (travel() - active().interface_slip(state.u)).head<2>();
}

double SlidingStack::gap() const {
  return model_.bearing.lateral_capacity() - ridden().norm();
}

double SlidingStack::closing_speed() const {
  const Eigen::Vector2d u = ridden(), v = (velocity() - active().interface_slip(state.v)).head<2>();
  return u.norm() > 0 ? v.dot(u.normalized()) : 0;
}

void SlidingStack::join() {
  if (!all_solid()) state = joined_state(alone_, state, held, joined_);
  near_rim = true;
}

double SlidingStack::part() {
  const double kinetic = joined_.kinetic_energy(state);
  if (!all_solid()) state = parted_state(model_, joined_, state, alone_, held);
  near_rim = false;
  return all_solid() ? 0 : model_.energy_share() * (kinetic - alone_.kinetic_energy(state));
}

void SlidingStack::carry_over(const SlidingStack &old) {
  if (model_.turns() && !model_.mesh.half)
    throw SolverStopped(
        "the state could not be carried over to the mesh with one more sector: the face of a slider "
        "between two dishes has other points there; move it along x, where a half model serves, or try rung "
        "`rim`, which meshes any side of a slider of one piece");
  const MeshTransfer transfer(old.model_.space, model_.space);
  state = active().at_rest();
  const auto by_dof = [&](const Eigen::VectorXd &there) { // the bodies' dofs stand behind the nodes'
    const Eigen::VectorXd nodal = transfer.nodal(there);
    const Eigen::Index bodies = there.size() - static_cast<Eigen::Index>(old.model_.space.n_dofs());
    Eigen::VectorXd here(nodal.size() + bodies);
    here << nodal, there.tail(bodies);
    return here;
  };
  const auto moved = [&](const Eigen::VectorXd &values) {
    return active().equations().gather(by_dof(old.active().equations().expand(values)));
  };
  state.u = moved(old.state.u), state.v = moved(old.state.v), state.a = moved(old.state.a);
  state.history = transfer.history(old.state.history);
  carry_contacts(old.state, active(), state);
  if (!all_solid() && old.held.displacement.size()) held.displacement = by_dof(old.held.displacement);
  rest_height = old.rest_height, rest_elastic = old.rest_elastic, rest_plastic = old.rest_plastic;
}

void SlidingStack::balance(const Eigen::VectorXd &load, const StepOptions &options) {
  BearingSystem &system = active();
  const Eigen::Vector3d top = system.top_of(state.u);
  const ContactStepReport step =
      TopDrive().move_to(system, state, {top.head<2>(), {}}, load - system.mass_times(state.a), options);
  if (!step.converged)
    throw SolverStopped("the state could not be brought to balance on the mesh with one more sector: " + step.reason +
                        "; try rung `rim`, which meshes any side");
  state.R = system.mass_times(state.a);
  if (all_solid()) return;
  const SolidEnergies all = energies_at(model_, joined_, displacements(), state.history);
  held.energies = {all.elastic - state.energies.elastic, all.plastic - state.energies.plastic};
}

std::map<std::string, double> SlidingStack::time_split() const {
  auto result = alone_.time_split;
  for (const auto &[name, seconds] : joined_.time_split) result[name] += seconds;
  return result;
}

SolverWork SlidingStack::work() const {
  SolverWork result = alone_.work;
  return result += joined_.work;
}

} // namespace rimpact::fe
