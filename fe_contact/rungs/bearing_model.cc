#include "fe_contact/rungs/bearing_model.h"

#include "fe_contact/rungs/middle_plane.h"
#include "fe_contact/rungs/serendipity_cells.h"
#include <algorithm>
#include <cmath>
#include <set>

namespace rimpact::fe {
namespace {

using meshes::Surface;

Supports supports_of(const BearingModel &model, RimState rim) {
  Supports supports(model.space);
  for (int i = 0; i < 3 && !model.turns(); ++i)
    if (model.mesh.half && i == 1)
      supports.fix(Surface::top, i);
    else
      supports.tie(Surface::top, i);
  if (model.mesh.half) supports.fix(Surface::symmetry, 1);
  if (model.slips())
    if (const int middle = supports.add_body(); model.mesh.half) supports.fix_dof(middle + 1);
  model.rung.hold(supports, rim);
  return supports;
}

} // namespace

BearingModel::BearingModel(const Rung &rung, const scene::Bearing &bearing, const meshes::MeshOrder &mesh,
                           const ModelOptions &options)
    : rung(rung), bearing(bearing), mesh(mesh), options(options),
      space(rung.mesh(bearing, mesh), options.degree,
            [&](const Discretisation &whole) { return serendipity_cells(whole, bearing); }),
      solid(space, bearing, options.pad_retardation), foot(space, solid, bearing, mesh.half),
      rate_ratio(turns() ? bearing.dishes() : RimFrame::of(bearing, 0, 0, false).rate_ratio()) {}

double BearingModel::own_mass() const {
  double mass = 0;
  for (const auto volume : rung.carried) mass += share() * solid.mass_of(volume);
  return mass;
}

SurfaceContactOptions penalised(const BearingModel &model, double E, double cell, const FrictionCoefficient &mu,
                                double stiffer) {
  const double penalty = stiffer * model.options.penalty_scale * E / (cell * meshes::size_factor(model.mesh.level));
  return {{penalty, penalty, mu}};
}

BearingSystem::BearingSystem(const BearingModel &model, double mass, RimState rim)
    : BearingSystem(model, mass, rim, supports_of(model, rim)) {}

BearingSystem::BearingSystem(const BearingModel &model, double mass, RimState rim, Supports supports)
    : ContactSystem(model.space, model.solid, supports.number()), model_(model), mass_(mass) {
  const Discretisation &space = model.space;
  const auto &of = equations().of_dof;
  const int at = model.turns() ? middle_dof(model) : static_cast<int>(3 * space.nodes_of(Surface::top).front());
  const int ridden = model.turns() ? static_cast<int>(3 * middle_node(space)) : at;
  for (int i = 0; i < 3; ++i) top_.equation[i] = of[at + i], ridden_.equation[i] = of[ridden + i];
  if (model.turns() && !model.slips()) tie_middle_plane(*this, model);
  const double on_top = mass * std::pow(model.rate_ratio, 2) / model.bearing.dishes(); // m u'^2 / 2 = 2 on_top w'^2 / 2
  if (mass > 0) add_mass(at, (on_top - model.own_mass()) / model.share());
  for (const Pair &pair : model.rung.pairs(model, rim)) {
    add_contact(pair.slave, pair.master, pair.options);
    roles_.push_back(pair.role);
  }
  std::set<int> unique[3];
  const auto &carried = model.rung.carried;
  for (std::size_t c = 0; c < space.n_cells; ++c) {
    if (std::find(carried.begin(), carried.end(), space.volumes[c]) == carried.end()) continue;
    for (int k = 0; k < 3 * space.nodes_per_cell; ++k)
      if (const int equation = of[3 * space.cell_nodes[c * space.nodes_per_cell + k / 3] + k % 3]; equation >= 0)
        unique[k % 3].insert(equation);
  }
  for (int i = 0; i < 3; ++i)
    if (top_.equation[i] >= 0) unique[i].insert(top_.equation[i]);
  for (int i = 0; i < 3; ++i) carried_[i].assign(unique[i].begin(), unique[i].end());
}

Eigen::VectorXd BearingSystem::dead_load(double vertical) const {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(equations().n);
  load[top_.equation[2]] = -vertical / model_.share();
  return load;
}

std::optional<std::size_t> BearingSystem::contact_of(Role role) const {
  const auto found = std::find(roles_.begin(), roles_.end(), role);
  if (found == roles_.end()) return {};
  return found - roles_.begin();
}

const SurfaceContactReport *BearingSystem::report_of(const SystemState &state, Role role) const {
  const auto number = contact_of(role);
  return number ? &state.reports[*number] : nullptr;
}

Eigen::Vector3d BearingSystem::whole(Eigen::Vector3d force) const {
  force *= model_.share();
  if (model_.mesh.half) force.y() = 0; // the mirrored half takes it away
  return force;
}

Eigen::Vector3d BearingSystem::force_of(const SystemState &state, Role role) const {
  const auto *report = report_of(state, role);
  return report ? whole(report->force) : Eigen::Vector3d::Zero();
}

Eigen::Vector3d BearingSystem::friction_of(const SystemState &state, Role role) const {
  const auto *report = report_of(state, role);
  return report ? whole(report->friction) : Eigen::Vector3d::Zero();
}

bool BearingSystem::walls_touch(const SystemState &state) const {
  const auto *wall = report_of(state, Role::wall);
  return wall && wall->stick + wall->slip > 0;
}

/// The image's middle is as far beyond the bearing's as that of the half behind it: u = 2 w.
Eigen::Vector3d BearingSystem::interface_slip(const Eigen::VectorXd &by_equation) const {
  return model_.slips() ? Eigen::Vector3d(2 * (top_.of(by_equation) - ridden_.of(by_equation)))
                        : Eigen::Vector3d::Zero();
}

double BearingSystem::wall_distance(const SystemState &state, double otherwise) const {
  const auto *wall = report_of(state, Role::wall);
  return wall && std::isfinite(wall->smallest_gap) ? model_.rate_ratio * wall->smallest_gap : otherwise;
}

void BearingSystem::translate(Eigen::VectorXd &u, const Eigen::Vector3d &way) const {
  for (int i = 0; i < 3; ++i)
    for (const int equation : carried_[i]) u[equation] += way[i];
}

void BearingSystem::set_position(SystemState &state, const Eigen::Vector3d &top, const Eigen::Vector3d &velocity,
                                 const Eigen::Vector3d &acceleration) const {
  translate(state.u, top - top_.of(state.u));
  for (int i = 0; i < 3; ++i)
    for (const int equation : carried_[i]) {
      state.v[equation] = velocity[i];
      state.a[equation] = acceleration[i];
    }
  state.last_dt = 0;
  for (std::size_t k = 0; k < roles_.size(); ++k) {
    state.contacts[k] = contact(k).open(expand(state));
    state.reports[k] = {};
  }
}

void BearingSystem::apply_velocity_jump(SystemState &state, const Eigen::Vector3d &velocity) const {
  translate(state.v, velocity);
}

ContactStepReport BearingSystem::relax(SystemState &state, const StepOptions &options) {
  StepTerms terms{Eigen::VectorXd::Zero(equations().n)};
  terms.with_contact = false;
  const Eigen::Vector3d top = top_.of(state.u);
  for (int i = 0; i < 3; ++i)
    if (top_.equation[i] >= 0) terms.driven.push_back({top_.equation[i], top[i]});
  const ContactStepReport report = static_step(*this, state, terms, options);
  if (!report.converged) return report;
  for (std::size_t k = 0; k < roles_.size(); ++k) state.contacts[k] = contact(k).open(expand(state));
  state.v.setZero();
  state.a.setZero();
  state.last_dt = 0;
  return report;
}

double BearingSystem::wall_gap(const SystemState &state, const Eigen::Vector3d &top) const {
  const std::size_t wall = contact_of(Role::wall).value();
  SystemState moved = state;
  set_position(moved, top, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations().n);
  return contact(wall).assemble(expand(moved), moved.contacts[wall], 0, equations(), forces, nullptr).smallest_gap;
}

} // namespace rimpact::fe
