#include "fe_contact/drive/rim_hand_over.h"

namespace rimpact::fe {
namespace {

/// Values of the equations that both numberings have; others as `rest` holds them.
Eigen::VectorXd carried_over(const Equations &from, const Equations &to, const Eigen::VectorXd &values,
                             Eigen::VectorXd rest) {
  for (std::size_t dof = 0; dof < to.of_dof.size(); ++dof)
    if (from.of_dof[dof] >= 0 && to.of_dof[dof] >= 0) rest[to.of_dof[dof]] = values[from.of_dof[dof]];
  return rest;
}

void carry_over(const BearingSystem &from, const BearingSystem &to, const SystemState &state, SystemState &result) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(to.equations().n);
  for (const auto vector : {&SystemState::v, &SystemState::a, &SystemState::R})
    result.*vector = carried_over(from.equations(), to.equations(), state.*vector, none);
  result.history = state.history;
  for (const Role role : from.roles()) {
    const auto there = to.contact_of(role);
    if (!there) continue; // of the rim
    const std::size_t here = from.contact_of(role).value();
    result.contacts[*there] = state.contacts[here];
    result.reports[*there] = state.reports[here];
  }
}

} // namespace

SystemState joined_state(const BearingSystem &alone, const SystemState &state, const HeldRim &held,
                         BearingSystem &joined) {
  SystemState result = joined.at_rest();
  carry_over(alone, joined, state, result);
  result.u = carried_over(alone.equations(), joined.equations(), state.u,
                          held.displacement.size() ? joined.equations().gather(held.displacement)
                                                   : Eigen::VectorXd::Zero(joined.equations().n));
  for (const Role role : joined.roles())
    if (const std::size_t own = joined.contact_of(role).value(); !alone.contact_of(role))
      result.contacts[own] = joined.contact(own).open(joined.expand(result));
  result.energies.elastic = state.energies.elastic + held.energies.elastic;
  result.energies.plastic = state.energies.plastic + held.energies.plastic;
  result.energies.damping = state.energies.damping;
  return result;
}

SystemState parted_state(const BearingModel &model, const BearingSystem &joined, const SystemState &state,
                         BearingSystem &alone, HeldRim &held) {
  SystemState result = alone.at_rest();
  carry_over(joined, alone, state, result);
  result.u = carried_over(joined.equations(), alone.equations(), state.u, result.u);
  held.displacement = joined.equations().expand(carried_over(
      alone.equations(), joined.equations(), Eigen::VectorXd::Zero(alone.equations().n), state.u)); // of the rest alone
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(alone.equations().n);
  SolidHistory same;
  model.solid.assemble(alone.expand(result), state.history, same, alone.equations(), forces, nullptr, result.energies);
  result.energies.elastic += alone.ties().energy(result.u);
  held.energies.elastic = state.energies.elastic - result.energies.elastic;
  held.energies.plastic = state.energies.plastic - result.energies.plastic;
  return result;
}

} // namespace rimpact::fe
