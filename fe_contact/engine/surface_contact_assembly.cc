// Forces and tangent of the contact, from the law's derivatives to the matrix.
#include "fe_contact/engine/surface_contact.h"

#include "fe_contact/engine/threads.h"
#include "fe_contact/solver/ranks.h"
#include <algorithm>
#include <unsupported/Eigen/AutoDiff>

namespace rimpact::fe {

using Eigen::Matrix3d;
using Eigen::Vector3d;

SurfaceContact::Carried SurfaceContact::pushed_forward(const Coupling &coupling) const {
  const Distance d = master_.distance(coupling.y);
  if (coupling.carrier_face < 0) return {d.gap, d.normal, d.normal, d.curvature};
  const Vector3d nu = coupling.inverse.transpose() * d.normal;
  const double stretch = nu.norm(); // one but for the carrier's strain
  const Vector3d normal = nu / stretch;
  Eigen::Matrix2d bend; // of the carrier's displacement along the normal
  bend << coupling.second[0].dot(nu), coupling.second[1].dot(nu), coupling.second[1].dot(nu),
      coupling.second[2].dot(nu);
  const Matrix3d dnu =
      coupling.inverse.transpose() * d.curvature * coupling.inverse - coupling.dxi.transpose() * bend * coupling.dxi;
  const Matrix3d P = Matrix3d::Identity() - normal * normal.transpose();
  const double gap = d.gap / stretch;
  return {gap, normal, normal - gap / stretch * dnu.transpose() * normal, P * dnu / stretch, nu, stretch};
}

/// The law with its tangents; of n derivatives three are by w and, where the carrier deforms, three by nu.
template <int n>
CoulombContact::Result<double> SurfaceContact::differentiate(const CoulombContact &law, const Carried &d,
                                                             const Vector3d &slip, const Matrix3d &pull_back,
                                                             double multiplier, const Vector3d &tangential, double dt,
                                                             Tangents &tangents) {
  using Derivatives = Eigen::Matrix<double, n, 1>;
  using Dual = Eigen::AutoDiffScalar<Derivatives>;
  const auto both = [](const Vector3d &by_w, const Vector3d &by_nu) {
    Derivatives result;
    result.template head<3>() = by_w;
    if constexpr (n > 3) result.template tail<3>() = by_nu;
    return result;
  };
  const Matrix3d P = (Matrix3d::Identity() - d.normal * d.normal.transpose()) / d.stretch;
  const Dual gap(d.gap, both(d.gradient, -d.gap / d.stretch * d.normal));
  Eigen::Matrix<Dual, 3, 1> normal, moving_slip;
  for (int i = 0; i < 3; ++i) {
    normal[i] = Dual(d.normal[i], both(d.curvature.row(i).transpose(), P.row(i).transpose()));
    moving_slip[i] = Dual(slip[i], both(pull_back.row(i).transpose(), Vector3d::Zero()));
  }
  const auto result = law.at(gap, normal, moving_slip, multiplier, tangential, dt);
  CoulombContact::Result<double> values;
  for (int i = 0; i < 3; ++i) {
    values.traction[i] = result.traction[i].value();
    values.friction[i] = result.friction[i].value();
    tangents.by_w.row(i) = result.traction[i].derivatives().template head<3>().transpose();
    if constexpr (n > 3) tangents.by_nu.row(i) = result.traction[i].derivatives().template tail<3>().transpose();
  }
  values.pressure = result.pressure.value();
  values.status = result.status;
  return values;
}

SurfaceContact::FaceResult SurfaceContact::assemble_face(std::size_t f, const CoulombContact &law,
                                                         const Eigen::VectorXd &u, SurfaceContactState &state,
                                                         double dt, bool with_stiffness) const {
  FaceResult result;
  SurfaceContactReport &report = result.report;
  const std::size_t per_face = options_.points * options_.points;
  for (std::size_t k = f * per_face; k < (f + 1) * per_face; ++k) {
    const FacePoint &point = points_[k];
    state.pressure[k] = 0;
    state.friction[k].setZero();
    state.pulled_back[k].setZero();
    state.status[k] = ContactStatus::open;
    state.gap[k] = std::numeric_limits<double>::infinity();
    if (!state.covered[k]) continue;
    const auto coupling = couple(k, u, state.opposite[k], reach_past_edges);
    if (!coupling) {
      report.lost += is_candidate(k, u, state.opposite[k]);
      continue;
    }
    state.opposite[k] = coupling->carrier_face;
    Carried distance = pushed_forward(*coupling);
    state.gap[k] = distance.gap;
    report.smallest_gap = std::min(report.smallest_gap, distance.gap);
    distance.gap += state.entry[k];
    if (state.multiplier[k] - law.normal_penalty * distance.gap <= 0) continue;
    Tangents D;
    const auto differentiated = coupling->carrier_face >= 0 ? differentiate<6> : differentiate<3>;
    const auto acts = differentiated(law, distance, coupling->y - state.start[k], coupling->inverse,
                                     state.multiplier[k], state.tangential[k], dt, D);
    state.pressure[k] = acts.pressure;
    state.friction[k] = acts.friction;
    state.pulled_back[k] = coupling->inverse.transpose().inverse() * acts.friction;
    state.status[k] = acts.status;
    report.force += point.area * acts.traction;
    report.friction += point.area * acts.friction;
    report.penetration = std::max(report.penetration, std::abs(state.gap[k]));
    report.largest_pressure = std::max(report.largest_pressure, acts.pressure);
    ++(acts.status == ContactStatus::stick ? report.stick : report.slip);
    if (coupling->carrier_face >= 0 &&
        !std::binary_search(pairs_[f].begin(), pairs_[f].end(), coupling->carrier_face)) {
      report.pattern_holds = false;
      continue;
    }
    if (result.pairs.empty() || result.pairs.back().carrier_face != coupling->carrier_face)
      result.pairs.push_back({coupling->carrier_face});
    add_to(result.pairs.back(), *coupling, point.area, acts.traction, D, distance.nu, with_stiffness);
  }
  return result;
}

SurfaceContactReport SurfaceContact::assemble(const Eigen::VectorXd &u, SurfaceContactState &state, double dt,
                                              const Equations &equations, Eigen::VectorXd &forces,
                                              Tangent *tangent) const {
  CoulombContact law = options_.law;
  law.normal_penalty *= state.stiffening;
  law.tangential_penalty *= state.stiffening;
  const std::vector<std::size_t> offsets = shares_of_ranks(state);
  const std::size_t first = offsets[ranks().own], n = offsets[ranks().own + 1] - first;
  std::vector<FaceResult> results(n);
  const int workers = assembly_threads();
  on_each_thread(workers, [&](int w) { // contact is in patches: every worker takes of all of them
    for (std::size_t f = w; f < n; f += workers)
      results[f] = assemble_face(first + f, law, u, state, dt, tangent != nullptr);
  });
  SurfaceContactReport report;
  for (auto &result : results) { // face by face, so that sums do not depend on the threads
    report.add(result.report);
    for (auto &pair : result.pairs) flush(pair, equations, forces, tangent);
  }
  all_gather(offsets, state, report);
  return report;
}

void SurfaceContactReport::add(const SurfaceContactReport &other) {
  force += other.force;
  friction += other.friction;
  smallest_gap = std::min(smallest_gap, other.smallest_gap);
  penetration = std::max(penetration, other.penetration);
  largest_pressure = std::max(largest_pressure, other.largest_pressure);
  stick += other.stick;
  slip += other.slip;
  lost += other.lost;
  pattern_holds = pattern_holds && other.pattern_holds;
}

/// Contact is in patches: by numbers of faces one rank would have them all.
std::vector<std::size_t> SurfaceContact::shares_of_ranks(const SurfaceContactState &state) const {
  if (ranks().size == 1) return {0, faces_.size()};
  constexpr std::size_t searched = 2, bearing = 6; // work of a point, roughly, where a face without any costs 1
  const std::size_t per_face = options_.points * options_.points;
  std::vector<std::size_t> work{0};
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    std::size_t sum = 1;
    for (std::size_t k = f * per_face; k < (f + 1) * per_face; ++k)
      if (state.covered[k]) sum += state.status[k] == ContactStatus::open ? searched : bearing;
    work.push_back(work.back() + sum);
  }
  std::vector<std::size_t> offsets;
  for (const std::size_t due : ranks().offsets(work.back()))
    offsets.push_back(std::lower_bound(work.begin(), work.end(), due) - work.begin());
  return offsets;
}

void SurfaceContact::all_gather(std::vector<std::size_t> offsets, SurfaceContactState &state,
                                SurfaceContactReport &report) const {
  if (ranks().size == 1) return;
  for (auto &start : offsets) start *= options_.points * options_.points; // of points, whole faces each
  ranks().all_gather(state.gap, offsets);
  ranks().all_gather(state.pressure, offsets);
  ranks().all_gather(state.friction, offsets);
  ranks().all_gather(state.pulled_back, offsets);
  ranks().all_gather(state.status, offsets);
  ranks().all_gather(state.opposite, offsets);
  Eigen::VectorXd sums(9), largest(4);
  sums << report.force, report.friction, report.stick, report.slip, report.lost;
  largest << -report.smallest_gap, report.penetration, report.largest_pressure, !report.pattern_holds;
  ranks().all_reduce_sum(sums);
  ranks().all_reduce_max(largest);
  report.force = sums.head<3>();
  report.friction = sums.segment<3>(3);
  report.stick = static_cast<int>(sums[6]);
  report.slip = static_cast<int>(sums[7]);
  report.lost = static_cast<int>(sums[8]);
  report.smallest_gap = -largest[0];
  report.penetration = largest[1];
  report.largest_pressure = largest[2];
  report.pattern_holds = largest[3] == 0;
}

void SurfaceContact::add_to(Pair &pair, const Coupling &coupling, double area, const Vector3d &traction,
                            const Tangents &D, const Vector3d &nu, bool with_stiffness) {
  const int n = 3 * coupling.n;
  if (pair.dofs.empty()) {
    pair.dofs.assign(coupling.dofs, coupling.dofs + coupling.n);
    pair.forces.setZero(n);
    pair.stiffness.setZero(n, n);
  }
  for (int a = 0; a < coupling.n; ++a) pair.forces.segment<3>(3 * a) -= area * coupling.N[a] * traction;
  if (!with_stiffness) return;
  for (int b = 0; b < coupling.n; ++b) {
    // Strain of the carrier turns the normal: d nu / d u_b = -F^-T grad N_b nu^T, by its own nodes b only.
    const Vector3d turn = D.by_nu * coupling.dxi.transpose() * Eigen::Vector2d(coupling.dN[b][0], coupling.dN[b][1]);
    const Matrix3d column = -area * (D.by_w * coupling.N[b] + turn * nu.transpose());
    // The traction changes, and the place on the carrier's face where it acts.
    const Matrix3d moved[2] = {-area * coupling.N[b] * traction * coupling.dxi.row(0),
                               -area * coupling.N[b] * traction * coupling.dxi.row(1)};
    for (int a = 0; a < coupling.n; ++a)
      pair.stiffness.block<3, 3>(3 * a, 3 * b) +=
          coupling.N[a] * column + coupling.dN[a][0] * moved[0] + coupling.dN[a][1] * moved[1];
  }
}

void SurfaceContact::flush(const Pair &pair, const Equations &equations, Eigen::VectorXd &forces, Tangent *tangent) {
  const int n = static_cast<int>(pair.dofs.size());
  std::vector<int> equation(3 * n);
  std::vector<double> weight(3 * n);
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i) {
      equation[3 * a + i] = equations.of_dof[pair.dofs[a] + i];
      weight[3 * a + i] = equations.weight[pair.dofs[a] + i];
    }
  std::vector<int> order; // of the columns that are equations, ascending by equation
  for (int b = 0; b < 3 * n; ++b)
    if (equation[b] >= 0) order.push_back(b);
  std::sort(order.begin(), order.end(), [&](int b, int c) { return equation[b] < equation[c]; });
  std::vector<int> columns;
  for (const int b : order) columns.push_back(equation[b]);
  std::vector<double> row(order.size());
  for (const int a : order) {
    forces[equation[a]] += weight[a] * pair.forces[a];
    if (!tangent) continue;
    for (std::size_t i = 0; i < order.size(); ++i) row[i] = weight[a] * weight[order[i]] * pair.stiffness(a, order[i]);
    tangent->add_row(equation[a], columns, row.data());
  }
}

} // namespace rimpact::fe
