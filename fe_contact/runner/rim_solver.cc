// What a RimSolver is made of: equations, pattern, states.
#include "fe_contact/runner/rim_solver.h"

#include "fe_contact/solver/stopwatch.h"
#include <cmath>
#include <Eigen/Geometry>
#include <set>

namespace rimpact::fe {
namespace {

ContactOptions contact_options(const scene::Bearing &bearing, const meshes::RimMeshOptions &mesh,
                               const RimSolverOptions &options) {
  ContactOptions result;
  const double cell = 0.006 / std::pow(1.5, mesh.level - 1); // the meshes' target size in the contact zone
  result.law.penalty = options.penalty_factor * default_penalty(bearing.steel.E, cell);
  result.law.ceiling = 20 * bearing.steel.yield.value_or(bearing.steel.E / 100);
  result.gap_tolerance = options.gap_tolerance;
  return result;
}

} // namespace

RimSolver::RimSolver(const scene::Bearing &bearing, const meshes::RimMeshOptions &mesh,
                     const RimSolverOptions &options)
    : RimSolver(bearing, meshes::rim_mesh(bearing, mesh), mesh, options) {}

RimSolver::RimSolver(const scene::Bearing &bearing, const meshes::HexMesh &own,
                     const meshes::RimMeshOptions &mesh, const RimSolverOptions &options)
    : half_(mesh.half), options_(options), space_(own, options.degree), solid_(space_, bearing),
      contact_(space_, meshes::Surface::slider_side, meshes::Surface::rim_wall,
               contact_options(bearing, mesh, options)) {
  make_equations();
  make_pattern(Eigen::VectorXd::Zero(space_.n_dofs()));
}

RimSolver::~RimSolver() = default;

void RimSolver::make_equations() {
  equations_.of_dof.assign(space_.n_dofs(), -2); // -2: not yet numbered
  equations_.weight.assign(space_.n_dofs(), 1.0);
  auto &of = equations_.of_dof;
  for (const unsigned node : space_.nodes_of(meshes::Surface::fixed))
    for (int i = 0; i < 3; ++i) of[3 * node + i] = -1;
  if (half_)
    for (const unsigned node : space_.nodes_of(meshes::Surface::symmetry)) of[3 * node + 1] = -1;
  const auto top = space_.nodes_of(meshes::Surface::top);
  for (int i = 0; i < 3; ++i) {
    master_[i] = half_ && i == 1 ? -1 : equations_.n++;
    for (const unsigned node : top) of[3 * node + i] = master_[i];
  }
  hold_cuts();
  for (int &equation : of)
    if (equation == -2) equation = equations_.n++;

  std::set<unsigned> slider_nodes;
  for (std::size_t c = 0; c < space_.n_cells; ++c)
    if (space_.volumes[c] == meshes::Volume::upper_slider)
      slider_nodes.insert(&space_.cell_nodes[c * space_.nodes_per_cell],
                          &space_.cell_nodes[(c + 1) * space_.nodes_per_cell]);
  for (int i = 0; i < 3; ++i) {
    std::set<int> unique;
    for (const unsigned node : slider_nodes)
      if (of[3 * node + i] >= 0) unique.insert(of[3 * node + i]);
    slider_equations_[i].assign(unique.begin(), unique.end());
  }
}

/// The sector's cuts, radial ones and one about the axis, move within themselves: no displacement along the cut's normal.
void RimSolver::hold_cuts() {
  auto &of = equations_.of_dof;
  std::map<unsigned, std::pair<bool, bool>> cut; // node -> on a cut about the axis, on a radial one
  for (const Face *face : space_.faces_of(meshes::Surface::sector_end)) {
    const std::size_t m = std::size_t(space_.degree) + 1;
    const auto at = [&](std::size_t k) { return space_.positions[face->nodes[k]]; };
    const Eigen::Vector3d normal = (at(m * m - 1) - at(0)).cross(at(m * (m - 1)) - at(m - 1)).normalized();
    const bool about_axis = std::abs(normal.head<2>().dot(at(0).head<2>().normalized())) > std::sqrt(0.5);
    for (const unsigned node : face->nodes) (about_axis ? cut[node].first : cut[node].second) = true;
  }
  for (const auto &[node, kinds] : cut) {
    if (of[3 * node] == -1) continue;
    const auto [about_axis, radial] = kinds;
    if (about_axis && (radial || of[3 * node + 1] == -1)) {
      of[3 * node] = of[3 * node + 1] = -1;
      continue;
    }
    const Eigen::Vector2d out = space_.positions[node].head<2>().normalized();
    const Eigen::Vector2d allowed = about_axis ? Eigen::Vector2d(-out.y(), out.x()) : out;
    of[3 * node] = of[3 * node + 1] = equations_.n++;
    equations_.weight[3 * node] = allowed.x();
    equations_.weight[3 * node + 1] = allowed.y();
  }
}

void RimSolver::make_pattern(const Eigen::VectorXd &u) {
  const Stopwatch watch(time_split["search"]);
  auto near = contact_.cliques(u, equations_);
  pairs_.insert(pairs_.end(), near.begin(), near.end());
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  auto cliques = solid_.cliques(equations_);
  cliques.push_back({master_[0], master_[1], master_[2]});
  cliques.insert(cliques.end(), pairs_.begin(), pairs_.end());
  linear_.reset();
  tangent_ = std::make_unique<SymmetricMatrix>(equations_.n, cliques);
  mass_ = std::make_unique<SymmetricMatrix>(equations_.n, cliques);
  solid_.add_mass(equations_, *mass_);
  const double extra =
      (options_.attached_mass - share() * solid_.mass_of(meshes::Volume::upper_slider)) / share();
  for (const int equation : master_)
    if (equation >= 0 && options_.attached_mass > 0) mass_->add(equation, equation, extra);
  linear_ = std::make_unique<LinearSolver>(*tangent_, time_split);
}

Eigen::Vector3d RimSolver::master_of(const Eigen::VectorXd &values) const {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (master_[i] >= 0) result[i] = values[master_[i]];
  return result;
}

ArcState RimSolver::virgin() const {
  ArcState state;
  state.u = state.v = state.a = state.R = Eigen::VectorXd::Zero(equations_.n);
  state.history = solid_.virgin();
  state.contact = contact_.open();
  return state;
}

} // namespace rimpact::fe
