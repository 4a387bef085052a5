// What a RimSolver is made of: equations, pattern, states.
#include "fe_contact/runner/rim_solver.h"

#include "fe_contact/solver/stopwatch.h"
#include <cmath>
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
  make_equations(mesh);
  make_pattern(Eigen::VectorXd::Zero(space_.n_dofs()));
}

RimSolver::~RimSolver() = default;

void RimSolver::make_equations(const meshes::RimMeshOptions &mesh) {
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
  // The sector's cuts move within themselves: no displacement along the cut's normal.
  std::map<unsigned, int> tied_to_x; // y-dof = ratio * x-dof, numbered below
  for (const unsigned node : space_.nodes_of(meshes::Surface::sector_end)) {
    const Eigen::Vector3d &p = space_.positions[node];
    const double radius = p.head<2>().norm(), angle = std::atan2(p.y(), p.x());
    const bool inner = radius < mesh.plate_inner_radius + 1e-9;
    const bool end = std::abs(std::abs(angle) - mesh.sector_half_angle) < 1e-9;
    if (of[3 * node] == -1) continue;
    if ((inner && end) || (inner && of[3 * node + 1] == -1)) {
      of[3 * node] = of[3 * node + 1] = -1;
      continue;
    }
    const Eigen::Vector2d allowed = inner ? Eigen::Vector2d(-std::sin(angle), std::cos(angle))
                                          : Eigen::Vector2d(std::cos(angle), std::sin(angle));
    of[3 * node] = of[3 * node + 1] = equations_.n++;
    equations_.weight[3 * node] = allowed.x();
    equations_.weight[3 * node + 1] = allowed.y();
  }
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

void RimSolver::make_pattern(const Eigen::VectorXd &u) {
  const Stopwatch watch(time_split["search"]);
  auto near = contact_.cliques(u, equations_);
  pairs_.insert(pairs_.end(), near.begin(), near.end());
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  auto cliques = solid_.cliques(equations_);
  cliques.push_back({master_[0], master_[1], master_[2]});
  cliques.insert(cliques.end(), pairs_.begin(), pairs_.end());
  direct_.reset();
  tangent_ = std::make_unique<SymmetricMatrix>(equations_.n, cliques);
  mass_ = std::make_unique<SymmetricMatrix>(equations_.n, cliques);
  solid_.add_mass(equations_, *mass_);
  const double extra =
      (options_.attached_mass - share() * solid_.mass_of(meshes::Volume::upper_slider)) / share();
  for (const int equation : master_)
    if (equation >= 0 && options_.attached_mass > 0) mass_->add(equation, equation, extra);
  direct_ = std::make_unique<DirectSolver>(*tangent_);
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
