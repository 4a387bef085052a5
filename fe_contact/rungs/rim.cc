#include "fe_contact/rungs/rim.h"

#include <cmath>
#include <set>

namespace rimpact::fe {
namespace {

using meshes::Surface;

Supports supports_of(const RimModel &model) {
  Supports supports(model.space);
  for (int i = 0; i < 3; ++i) supports.fix(Surface::fixed, i);
  if (model.mesh.half) supports.fix(Surface::symmetry, 1);
  for (int i = 0; i < 3; ++i)
    if (model.mesh.half && i == 1)
      supports.fix(Surface::top, i);
    else
      supports.tie(Surface::top, i);
  supports.slide_on(Surface::sector_end);
  return supports;
}

SurfaceContactOptions wall_options(const RimModel &model) {
  constexpr double cell = 0.006, stiffer = 4; // of the meshes in the contact zone at level 1 [m]; than the cells
  const double penalty =
      stiffer * model.penalty_scale * model.bearing.steel.E / (cell * meshes::size_factor(model.mesh.level));
  const scene::ContactFriction &mu = model.bearing.contact;
  SurfaceContactOptions options{{penalty, penalty, {mu.rim, mu.rim_slow.value_or(mu.rim), mu.rate}}};
  options.carrier_faces = Surface::rim_wall;
  options.margin = 0.003; // the slider comes and goes radially and moves little along the wall [m]
  return options;
}

} // namespace

RimModel::RimModel(const scene::Bearing &bearing, const meshes::RimMeshOptions &mesh, double penalty_scale, int degree)
    : RimModel(bearing, meshes::rim_mesh(bearing, mesh), mesh, penalty_scale, degree) {}

RimModel::RimModel(const scene::Bearing &bearing, const meshes::HexMesh &own, const meshes::RimMeshOptions &mesh,
                   double penalty_scale, int degree)
    : bearing(bearing), mesh(mesh), penalty_scale(penalty_scale), space(own, degree), solid(space, bearing) {}

RimSystem::RimSystem(const RimModel &model, double mass) : RimSystem(model, mass, supports_of(model)) {}

RimSystem::RimSystem(const RimModel &model, double mass, Supports supports)
    : ContactSystem(model.space, model.solid, supports.number()), model_(model), mass_(mass) {
  const Discretisation &space = model.space;
  const auto &of = equations().of_dof;
  const unsigned any = space.nodes_of(Surface::top).front();
  for (int i = 0; i < 3; ++i) top_.equation[i] = of[3 * any + i];
  if (mass > 0) add_mass(3 * any, (mass - model.own_mass()) / model.share());
  const double radius = model.bearing.surface.planar_radius + model.bearing.rim.ledge;
  add_contact(Surface::slider_side, cylinder(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), radius, Side::inside),
              wall_options(model));
  std::set<int> unique[3];
  for (std::size_t c = 0; c < space.n_cells; ++c)
    for (int k = 0; k < 3 * space.nodes_per_cell && space.volumes[c] == meshes::Volume::upper_slider; ++k)
      if (const int equation = of[3 * space.cell_nodes[c * space.nodes_per_cell + k / 3] + k % 3]; equation >= 0)
        unique[k % 3].insert(equation);
  for (int i = 0; i < 3; ++i) slider_[i].assign(unique[i].begin(), unique[i].end());
}

void RimSystem::place(SystemState &state, const Eigen::Vector3d &top, const Eigen::Vector3d &velocity,
                      const Eigen::Vector3d &acceleration) const {
  const Eigen::Vector3d way = top - top_.of(state.u);
  for (int i = 0; i < 3; ++i)
    for (const int equation : slider_[i]) {
      state.u[equation] += way[i];
      state.v[equation] = velocity[i];
      state.a[equation] = acceleration[i];
    }
  state.last_dt = 0;
  state.contacts = {contact(0).open(expand(state))};
  state.reports = {{}};
}

void RimSystem::kick(SystemState &state, const Eigen::Vector3d &velocity) const {
  for (int i = 0; i < 3; ++i)
    for (const int equation : slider_[i]) state.v[equation] += velocity[i];
}

ContactStepReport RimSystem::push(SystemState &state, const Eigen::Vector3d &target, const StepOptions &options) {
  StepTerms terms{Eigen::VectorXd::Zero(equations().n)};
  for (int i = 0; i < 3; ++i)
    if (top_.equation[i] >= 0) terms.driven.push_back({top_.equation[i], target[i]});
  const Eigen::VectorXd before = state.u;
  const Eigen::Vector3d way = target - top_.of(state.u);
  // Onwards the parts go on as they went: they are about to flow. Back from the deepest point they are elastic at
  // first.
  const double onwards = last_way_.squaredNorm() > 0 ? way.dot(last_way_) / last_way_.squaredNorm() : 0;
  const Eigen::VectorXd guess = onwards > 0 ? Eigen::VectorXd(state.u + onwards * last_change_) : state.u;
  const ContactStepReport report = static_step(*this, state, terms, options, guess);
  if (!report.converged) return report;
  last_change_ = state.u - before;
  last_way_ = way;
  return report;
}

ContactStepReport RimSystem::relax(SystemState &state, const StepOptions &options) {
  StepTerms terms{Eigen::VectorXd::Zero(equations().n)};
  terms.with_contact = false;
  const Eigen::Vector3d top = top_.of(state.u);
  for (int i = 0; i < 3; ++i)
    if (top_.equation[i] >= 0) terms.driven.push_back({top_.equation[i], top[i]});
  const ContactStepReport report = static_step(*this, state, terms, options);
  if (!report.converged) return report;
  state.contacts = {contact(0).open(expand(state))};
  state.v.setZero();
  state.a.setZero();
  state.last_dt = 0;
  return report;
}

double RimSystem::wall_gap(const SystemState &state, const Eigen::Vector3d &top) const {
  SystemState moved = state;
  place(moved, top, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations().n);
  return contact(0).assemble(expand(moved), moved.contacts[0], 0, equations(), forces, nullptr).smallest_gap;
}

Eigen::Vector3d RimSystem::wall_force(const SystemState &state) const {
  Eigen::Vector3d force = model_.share() * state.reports[0].force;
  if (model_.mesh.half) force.y() = 0;
  return force;
}

} // namespace rimpact::fe
