#include "fe_contact/model/surface_contact.h"

#include "fe_contact/solver/ranks.h"

#include <Eigen/QR>
#include <unsupported/Eigen/AutoDiff>

namespace rimpact::fe {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
} // namespace

SurfaceContact::SurfaceContact(const Discretisation &space, meshes::Surface slave, MasterSurface master,
                               const SurfaceContactOptions &options)
    : space_(space), master_(std::move(master)), options_(options), faces_(space.faces_of(slave)),
      points_(face_points(space, faces_, options.points)) {
  if (options.carrier_faces) carrier_.emplace(space, *options.carrier_faces);
}

Vector3d SurfaceContact::position(const FacePoint &point, const Eigen::VectorXd &u) const {
  Vector3d x = Vector3d::Zero();
  for (int a = 0; a < point.shapes.n; ++a) {
    const unsigned node = faces_[point.face]->nodes[a];
    x += point.shapes.N[a] * (space_.positions[node] + u.segment<3>(3 * node));
  }
  return x;
}

std::optional<SurfaceContact::Coupling> SurfaceContact::couple(std::size_t k, const Eigen::VectorXd &u, int guess,
                                                               double beyond) const {
  const FacePoint &point = points_[k];
  Coupling result;
  for (int a = 0; a < point.shapes.n; ++a) result.add(3 * faces_[point.face]->nodes[a], point.shapes.N[a]);
  result.y = position(point, u);
  if (options_.carrier_dof >= 0) {
    result.y -= u.segment<3>(options_.carrier_dof);
    result.add(options_.carrier_dof, -1.0);
  }
  if (carrier_) {
    const Opposite opposite = carrier_->find(result.y, u, guess, beyond);
    if (opposite.face < 0) return {};
    result.y = opposite.y;
    result.inverse = opposite.inverse;
    result.dxi = opposite.dxi;
    std::copy(std::begin(opposite.second), std::end(opposite.second), std::begin(result.second));
    result.carrier_face = opposite.face;
    result.inside = opposite.inside;
    for (int a = 0; a < opposite.shapes.n; ++a)
      result.add(3 * carrier_->face(opposite.face).nodes[a], -opposite.shapes.N[a], -opposite.shapes.dxi[a],
                 -opposite.shapes.deta[a]);
  }
  if (master_.covers) result.inside = result.inside && master_.covers(result.y);
  return result;
}

Vector3d SurfaceContact::relative_position(std::size_t k, const Eigen::VectorXd &u,
                                           const SurfaceContactState &state) const {
  constexpr double anywhere = 0.5; // as in assemble
  if (const auto coupling = couple(k, u, state.opposite[k], anywhere)) return coupling->y;
  return carrier_->roughly_back(position(points_[k], u), u);
}

void SurfaceContact::settle(const Eigen::VectorXd &u, SurfaceContactState &state) const {
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto coupling = couple(k, u, state.opposite[k], 0.0);
    state.covered[k] = coupling && coupling->inside;
    state.opposite[k] = coupling ? coupling->carrier_face : -1;
    if (state.covered[k]) continue;
    state.multiplier[k] = 0;
    state.tangential[k].setZero();
  }
}

SurfaceContactState SurfaceContact::open(const Eigen::VectorXd &u) const {
  const std::size_t n = points_.size();
  SurfaceContactState state{std::vector<double>(n, 0.0),
                            std::vector<Vector3d>(n, Vector3d::Zero()),
                            {},
                            std::vector<double>(n, std::numeric_limits<double>::infinity()),
                            std::vector<double>(n, 0.0),
                            std::vector<Vector3d>(n, Vector3d::Zero()),
                            std::vector<ContactStatus>(n, ContactStatus::open),
                            std::vector<char>(n, 0),
                            std::vector<int>(n, -1)};
  settle(u, state);
  for (std::size_t k = 0; k < n; ++k) state.start.push_back(relative_position(k, u, state));
  return state;
}

std::vector<std::vector<int>> SurfaceContact::cliques(const Equations &equations, const Eigen::VectorXd &u) {
  std::vector<std::vector<int>> result;
  const int per_face = options_.points * options_.points;
  pairs_.assign(faces_.size(), {});
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    std::vector<int> own;
    const auto add = [&](std::vector<int> &clique, int dof) {
      for (int i = 0; i < 3; ++i) clique.push_back(equations.of_dof[dof + i]);
    };
    for (const unsigned node : faces_[f]->nodes) add(own, 3 * node);
    if (options_.carrier_dof >= 0) add(own, options_.carrier_dof);
    if (!carrier_) {
      result.push_back(own);
      continue;
    }
    Vector3d low = Vector3d::Constant(1e300), high = -low;
    for (std::size_t k = f * per_face; k < (f + 1) * per_face; ++k) {
      const Vector3d y = carrier_->roughly_back(position(points_[k], u), u);
      low = low.cwiseMin(y);
      high = high.cwiseMax(y);
    }
    pairs_[f] = carrier_->near(low, high, options_.margin);
    for (const int master : pairs_[f]) {
      result.push_back(own);
      for (const unsigned node : carrier_->face(master).nodes) add(result.back(), 3 * node);
    }
  }
  return result;
}

SurfaceContact::Carried SurfaceContact::pushed_forward(const Coupling &coupling) const {
  const Distance d = master_.distance(coupling.y);
  if (coupling.carrier_face < 0) return {d.gap, d.normal, d.normal, d.curvature};
  const Vector3d nu = coupling.inverse.transpose() * d.normal;
  const double stretch = nu.norm(); // one but for the carrier's strain
  const Vector3d normal = nu / stretch;
  Eigen::Matrix2d bend; // of the carrier's displacement along the normal
  bend << coupling.second[0].dot(nu), coupling.second[1].dot(nu), coupling.second[1].dot(nu), coupling.second[2].dot(nu);
  const Matrix3d dnu = coupling.inverse.transpose() * d.curvature * coupling.inverse - coupling.dxi.transpose() * bend * coupling.dxi;
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

SurfaceContactReport SurfaceContact::assemble(const Eigen::VectorXd &u, SurfaceContactState &state, double dt,
                                              const Equations &equations, Eigen::VectorXd &forces,
                                              GeneralMatrix *tangent) const {
  SurfaceContactReport report;
  CoulombContact contact_law = options_.law;
  contact_law.normal_penalty *= state.stiffening;
  contact_law.tangential_penalty *= state.stiffening;
  constexpr double beyond = 0.5; // half widths of a face, for points that cross a free edge in this step
  Pair pair;
  int face = -1, carrier_face = -1; // of the pair
  const std::vector<std::size_t> starts = starts_of_ranks();
  for (std::size_t k = starts[ranks().own]; k < starts[ranks().own + 1]; ++k) {
    const FacePoint &point = points_[k];
    state.pressure[k] = 0;
    state.friction[k].setZero();
    state.status[k] = ContactStatus::open;
    state.gap[k] = std::numeric_limits<double>::infinity();
    if (!state.covered[k]) continue;
    const auto coupling = couple(k, u, state.opposite[k], beyond);
    if (!coupling) continue;
    state.opposite[k] = coupling->carrier_face;
    const Carried distance = pushed_forward(*coupling);
    state.gap[k] = distance.gap;
    report.smallest_gap = std::min(report.smallest_gap, distance.gap);
    if (state.multiplier[k] - contact_law.normal_penalty * distance.gap <= 0) continue;
    Tangents D;
    const auto differentiated = coupling->carrier_face >= 0 ? differentiate<6> : differentiate<3>;
    const auto law = differentiated(contact_law, distance, coupling->y - state.start[k], coupling->inverse,
                                    state.multiplier[k], state.tangential[k], dt, D);
    state.pressure[k] = law.pressure;
    state.friction[k] = law.friction;
    state.status[k] = law.status;
    report.force += point.area * law.traction;
    report.friction += point.area * law.friction;
    report.penetration = std::max(report.penetration, std::abs(distance.gap));
    report.largest_pressure = std::max(report.largest_pressure, law.pressure);
    ++(law.status == ContactStatus::stick ? report.stick : report.slip);
    if (coupling->carrier_face >= 0 && !std::binary_search(pairs_[point.face].begin(), pairs_[point.face].end(),
                                                           coupling->carrier_face)) {
      report.pattern_holds = false;
      continue;
    }
    if (face != point.face || carrier_face != coupling->carrier_face) flush(pair, equations, forces, tangent);
    face = point.face;
    carrier_face = coupling->carrier_face;
    add_to(pair, *coupling, point.area, law.traction, D, distance.nu, tangent != nullptr);
  }
  flush(pair, equations, forces, tangent);
  hand_round(state, report);
  return report;
}

std::vector<std::size_t> SurfaceContact::starts_of_ranks() const {
  std::vector<std::size_t> starts = ranks().starts(faces_.size());
  for (auto &start : starts) start *= options_.points * options_.points;
  return starts;
}

void SurfaceContact::hand_round(SurfaceContactState &state, SurfaceContactReport &report) const {
  if (ranks().size == 1) return;
  const std::vector<std::size_t> starts = starts_of_ranks();
  ranks().hand_round(state.gap, starts);
  ranks().hand_round(state.pressure, starts);
  ranks().hand_round(state.friction, starts);
  ranks().hand_round(state.status, starts);
  ranks().hand_round(state.opposite, starts);
  Eigen::VectorXd sums(8), largest(4);
  sums << report.force, report.friction, report.stick, report.slip;
  largest << -report.smallest_gap, report.penetration, report.largest_pressure, !report.pattern_holds;
  ranks().sum(sums);
  ranks().largest(largest);
  report.force = sums.head<3>();
  report.friction = sums.segment<3>(3);
  report.stick = static_cast<int>(sums[6]);
  report.slip = static_cast<int>(sums[7]);
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

void SurfaceContact::flush(Pair &pair, const Equations &equations, Eigen::VectorXd &forces, GeneralMatrix *tangent) {
  const int n = static_cast<int>(pair.dofs.size());
  std::vector<int> equation(3 * n);
  std::vector<double> weight(3 * n);
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i) {
      equation[3 * a + i] = equations.of_dof[pair.dofs[a] + i];
      weight[3 * a + i] = equations.weight[pair.dofs[a] + i];
    }
  for (int a = 0; a < 3 * n; ++a) {
    if (equation[a] < 0) continue;
    forces[equation[a]] += weight[a] * pair.forces[a];
    for (int b = 0; tangent && b < 3 * n; ++b)
      if (equation[b] >= 0) tangent->add(equation[a], equation[b], weight[a] * weight[b] * pair.stiffness(a, b));
  }
  pair.dofs.clear();
}

SurfaceContact::Augmentation SurfaceContact::augmentation(const SurfaceContactState &state) const {
  Augmentation next{std::vector<double>(points_.size(), 0.0),
                    std::vector<Vector3d>(points_.size(), Vector3d::Zero())};
  const double normal_penalty = options_.law.normal_penalty * state.stiffening,
               tangential_penalty = options_.law.tangential_penalty * state.stiffening;
  const int per_face = options_.points * options_.points;
  for (std::size_t first = 0; first < points_.size(); first += per_face) {
    std::vector<std::size_t> active;
    for (std::size_t k = first; k < first + per_face; ++k)
      if (state.pressure[k] > 0) active.push_back(k);
    // A bilinear fit asks for points on both sides of the face; where it is less than half covered, a constant.
    const int terms = space_.degree == 2 && 2 * static_cast<int>(active.size()) >= per_face ? 4 : 1;
    Eigen::MatrixXd basis(active.size(), terms), tractions(active.size(), 4);
    for (std::size_t i = 0; i < active.size(); ++i) {
      const auto &point = points_[active[i]];
      const double weight = std::sqrt(point.area);
      const double values[4] = {1.0, point.xi, point.eta, point.xi * point.eta};
      for (int t = 0; t < terms; ++t) basis(i, t) = weight * values[t];
      tractions(i, 0) = weight * state.pressure[active[i]];
      tractions.row(i).tail<3>() = weight * state.friction[active[i]].transpose();
    }
    if (active.empty()) continue;
    const Eigen::MatrixXd fit = basis * basis.colPivHouseholderQr().solve(tractions);
    for (std::size_t i = 0; i < active.size(); ++i) {
      const std::size_t k = active[i];
      const double weight = std::sqrt(points_[k].area);
      next.multiplier[k] = std::max(0.0, fit(i, 0) / weight);
      next.tangential[k] = fit.row(i).tail<3>().transpose() / weight;
      next.gap_left = std::max(next.gap_left, std::abs(next.multiplier[k] - state.multiplier[k]) / normal_penalty);
      if (state.status[k] == ContactStatus::stick)
        next.slip_left =
            std::max(next.slip_left, (next.tangential[k] - state.tangential[k]).norm() / tangential_penalty);
    }
  }
  return next;
}

void SurfaceContact::add_work(const SurfaceContactState &before, const SurfaceContactState &after,
                              const Eigen::VectorXd &u, SurfaceContactReport &report) const {
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const double area = points_[k].area;
    // A penalty's spring stores energy; what is left of the trapezoidal rule at touch and release is an error of
    // the step, and must show as one. With multipliers there is only the work.
    const double p0 = before.pressure[k], p1 = after.pressure[k];
    if (before.multiplier[k] == 0 && after.multiplier[k] == 0)
      report.normal_work += area * (p1 * p1 - p0 * p0) / (2 * options_.law.normal_penalty * after.stiffening);
    else if (std::isfinite(before.gap[k]) && std::isfinite(after.gap[k]))
      report.normal_work -= 0.5 * area * (p0 + p1) * (after.gap[k] - before.gap[k]);
    report.friction_work -= 0.5 * area * (before.friction[k] + after.friction[k])
                                             .dot(relative_position(k, u, after) - before.start[k]);
  }
}

void SurfaceContact::commit(const Eigen::VectorXd &u, SurfaceContactState &state, bool keep_pressure) const {
  const Augmentation next = augmentation(state);
  state.tangential = next.tangential;
  if (keep_pressure)
    state.multiplier = next.multiplier;
  else
    std::fill(state.multiplier.begin(), state.multiplier.end(), 0.0);
  for (std::size_t k = 0; k < points_.size(); ++k) state.start[k] = relative_position(k, u, state);
  settle(u, state);
}

double SurfaceContact::stiffness_per_area(const Equations &equations, const SymmetricMatrix &solid) const {
  double stiffness = 0, area = 0;
  for (const auto *face : faces_)
    for (const unsigned node : face->nodes)
      for (int i = 0; i < 3; ++i)
        if (const int equation = equations.of_dof[3 * node + i]; equation >= 0)
          stiffness += solid.values()[solid.starts()[equation]] / 3;
  for (const auto &point : points_) area += point.area;
  return ranks().sum(stiffness) / area;
}

double SurfaceContact::time_to_touch(const Eigen::VectorXd &u, const Eigen::VectorXd &v) const {
  double time = std::numeric_limits<double>::infinity();
  for (const auto &point : points_) {
    Vector3d y = position(point, u), velocity = Vector3d::Zero();
    for (int a = 0; a < point.shapes.n; ++a)
      velocity += point.shapes.N[a] * v.segment<3>(3 * faces_[point.face]->nodes[a]);
    if (options_.carrier_dof >= 0) {
      y -= u.segment<3>(options_.carrier_dof);
      velocity -= v.segment<3>(options_.carrier_dof);
    }
    if (carrier_) {
      y = carrier_->roughly_back(y, u);
      velocity = velocity + carrier_->roughly_back(Vector3d::Zero(), v);
    }
    if (master_.covers && !master_.covers(y)) continue;
    const Distance distance = master_.distance(y);
    const double closing = -velocity.dot(distance.normal);
    if (closing > 0) time = std::min(time, std::max(0.0, distance.gap) / closing);
  }
  return time;
}

std::vector<SurfaceContact::Sample> SurfaceContact::samples(const Eigen::VectorXd &u,
                                                            const SurfaceContactState &state) const {
  std::vector<Sample> result;
  for (std::size_t k = 0; k < points_.size(); ++k)
    result.push_back({relative_position(k, u, state), state.friction[k], points_[k].area, state.pressure[k],
                      state.gap[k]});
  return result;
}

} // namespace rimpact::fe
