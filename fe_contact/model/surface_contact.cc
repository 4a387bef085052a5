#include "fe_contact/model/surface_contact.h"

#include <Eigen/QR>
#include <unsupported/Eigen/AutoDiff>

namespace rimpact::fe {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
/// A number with its derivatives by the point's position.
using Dual = Eigen::AutoDiffScalar<Vector3d>;
using DualVector = Eigen::Matrix<Dual, 3, 1>;

/// The law at a point with its tangent d traction / d position.
CoulombContact::Result<double> differentiate(const CoulombContact &law, const Distance &d, const Vector3d &slip,
                                             double multiplier, const Vector3d &tangential, double dt,
                                             Matrix3d &tangent) {
  const Dual gap(d.gap, d.normal);
  DualVector normal, moving_slip;
  for (int i = 0; i < 3; ++i) {
    normal[i] = Dual(d.normal[i], d.curvature.row(i).transpose());
    moving_slip[i] = Dual(slip[i], Vector3d::Unit(i));
  }
  const auto result = law.at(gap, normal, moving_slip, multiplier, tangential, dt);
  CoulombContact::Result<double> values;
  for (int i = 0; i < 3; ++i) {
    values.traction[i] = result.traction[i].value();
    values.friction[i] = result.friction[i].value();
    tangent.row(i) = result.traction[i].derivatives().transpose();
  }
  values.pressure = result.pressure.value();
  values.status = result.status;
  return values;
}

} // namespace

SurfaceContact::SurfaceContact(const Discretisation &space, meshes::Surface slave, MasterSurface master,
                               const SurfaceContactOptions &options)
    : space_(space), master_(std::move(master)), options_(options), faces_(space.faces_of(slave)),
      points_(face_points(space, faces_, options.points)) {}

Vector3d SurfaceContact::relative_position(const FacePoint &point, const Eigen::VectorXd &u) const {
  Vector3d x = Vector3d::Zero();
  for (int a = 0; a < point.shapes.n; ++a) {
    const unsigned node = faces_[point.face]->nodes[a];
    x += point.shapes.N[a] * (space_.positions[node] + u.segment<3>(3 * node));
  }
  if (options_.carrier_dof >= 0) x -= u.segment<3>(options_.carrier_dof);
  return x;
}

SurfaceContactState SurfaceContact::open(const Eigen::VectorXd &u) const {
  const std::size_t n = points_.size();
  SurfaceContactState state{std::vector<double>(n, 0.0),
                            std::vector<Vector3d>(n, Vector3d::Zero()),
                            {},
                            std::vector<double>(n, std::numeric_limits<double>::infinity()),
                            std::vector<double>(n, 0.0),
                            std::vector<Vector3d>(n, Vector3d::Zero()),
                            std::vector<ContactStatus>(n, ContactStatus::open)};
  for (const auto &point : points_) state.start.push_back(relative_position(point, u));
  return state;
}

std::vector<std::vector<int>> SurfaceContact::cliques(const Equations &equations) const {
  std::vector<std::vector<int>> result;
  for (const auto *face : faces_) {
    std::vector<int> clique;
    for (const unsigned node : face->nodes)
      for (int i = 0; i < 3; ++i) clique.push_back(equations.of_dof[3 * node + i]);
    for (int i = 0; i < 3 && options_.carrier_dof >= 0; ++i)
      clique.push_back(equations.of_dof[options_.carrier_dof + i]);
    result.push_back(clique);
  }
  return result;
}

SurfaceContactReport SurfaceContact::assemble(const Eigen::VectorXd &u, SurfaceContactState &state, double dt,
                                              const Equations &equations, Eigen::VectorXd &forces,
                                              GeneralMatrix *tangent) const {
  SurfaceContactReport report;
  CoulombContact contact_law = options_.law;
  contact_law.normal_penalty *= state.stiffening;
  contact_law.tangential_penalty *= state.stiffening;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const FacePoint &point = points_[k];
    const Vector3d y = relative_position(point, u);
    state.pressure[k] = 0;
    state.friction[k].setZero();
    state.status[k] = ContactStatus::open;
    state.gap[k] = std::numeric_limits<double>::infinity();
    if (master_.covers && !master_.covers(y)) continue;
    const Distance distance = master_.distance(y);
    state.gap[k] = distance.gap;
    report.smallest_gap = std::min(report.smallest_gap, distance.gap);
    if (state.multiplier[k] - contact_law.normal_penalty * distance.gap <= 0) continue;
    Matrix3d D;
    const Vector3d slip = y - state.start[k];
    const auto law = differentiate(contact_law, distance, slip, state.multiplier[k], state.tangential[k], dt, D);
    state.pressure[k] = law.pressure;
    state.friction[k] = law.friction;
    state.status[k] = law.status;
    report.force += point.area * law.traction;
    report.penetration = std::max(report.penetration, std::abs(distance.gap));
    report.largest_pressure = std::max(report.largest_pressure, law.pressure);
    ++(law.status == ContactStatus::stick ? report.stick : report.slip);

    // The carrier is one more node with shape function -1.
    const int n = point.shapes.n, n_all = n + (options_.carrier_dof >= 0);
    int eqs[FaceShapes::max_nodes + 1][3];
    double N[FaceShapes::max_nodes + 1], weights[FaceShapes::max_nodes + 1][3];
    for (int a = 0; a < n_all; ++a) {
      N[a] = a < n ? point.shapes.N[a] : -1.0;
      for (int i = 0; i < 3; ++i) {
        const int dof = (a < n ? 3 * static_cast<int>(faces_[point.face]->nodes[a]) : options_.carrier_dof) + i;
        eqs[a][i] = equations.of_dof[dof];
        weights[a][i] = equations.weight[dof];
        if (eqs[a][i] >= 0) forces[eqs[a][i]] -= point.area * N[a] * weights[a][i] * law.traction[i];
      }
    }
    for (int a = 0; a < n_all && tangent; ++a)
      for (int i = 0; i < 3; ++i)
        for (int b = 0; b < n_all; ++b)
          for (int j = 0; j < 3; ++j)
            if (eqs[a][i] >= 0 && eqs[b][j] >= 0)
              tangent->add(eqs[a][i], eqs[b][j],
                           -point.area * N[a] * weights[a][i] * N[b] * weights[b][j] * D(i, j));
  }
  return report;
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
                                             .dot(relative_position(points_[k], u) - before.start[k]);
  }
}

void SurfaceContact::commit(const Eigen::VectorXd &u, SurfaceContactState &state, bool keep_pressure) const {
  const Augmentation next = augmentation(state);
  state.tangential = next.tangential;
  if (keep_pressure)
    state.multiplier = next.multiplier;
  else
    std::fill(state.multiplier.begin(), state.multiplier.end(), 0.0);
  for (std::size_t k = 0; k < points_.size(); ++k) state.start[k] = relative_position(points_[k], u);
}

double SurfaceContact::stiffness_per_area(const Equations &equations, const SymmetricMatrix &solid) const {
  double stiffness = 0, area = 0;
  for (const auto *face : faces_)
    for (const unsigned node : face->nodes)
      for (int i = 0; i < 3; ++i)
        if (const int equation = equations.of_dof[3 * node + i]; equation >= 0)
          stiffness += solid.values()[solid.starts()[equation]] / 3;
  for (const auto &point : points_) area += point.area;
  return stiffness / area;
}

double SurfaceContact::time_to_touch(const Eigen::VectorXd &u, const Eigen::VectorXd &v) const {
  double time = std::numeric_limits<double>::infinity();
  for (const auto &point : points_) {
    const Vector3d y = relative_position(point, u);
    if (master_.covers && !master_.covers(y)) continue;
    const Distance distance = master_.distance(y);
    Vector3d velocity = Vector3d::Zero();
    for (int a = 0; a < point.shapes.n; ++a)
      velocity += point.shapes.N[a] * v.segment<3>(3 * faces_[point.face]->nodes[a]);
    if (options_.carrier_dof >= 0) velocity -= v.segment<3>(options_.carrier_dof);
    const double closing = -velocity.dot(distance.normal);
    if (closing > 0) time = std::min(time, std::max(0.0, distance.gap) / closing);
  }
  return time;
}

std::vector<SurfaceContact::Sample> SurfaceContact::samples(const Eigen::VectorXd &u,
                                                            const SurfaceContactState &state) const {
  std::vector<Sample> result;
  for (std::size_t k = 0; k < points_.size(); ++k)
    result.push_back({relative_position(points_[k], u), state.friction[k], points_[k].area, state.pressure[k],
                      state.gap[k]});
  return result;
}

} // namespace rimpact::fe
