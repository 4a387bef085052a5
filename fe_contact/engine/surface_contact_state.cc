// What a step leaves to the next: cover, multipliers, the work done.
#include "fe_contact/engine/surface_contact.h"

#include <algorithm>
#include <cmath>
#include <Eigen/QR>
#include <stdexcept>

namespace rimpact::fe {

using Eigen::Vector3d;

void SurfaceContact::update_active(const Eigen::VectorXd &u, SurfaceContactState &state) const {
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto coupling = couple(k, u, state.opposite[k], 0.0);
    const bool was_covered = state.covered[k];
    state.covered[k] = coupling && coupling->inside;
    state.opposite[k] = coupling ? coupling->carrier_face : -1;
    double &entry = state.entry[k];
    if (coupling && coupling->inside) {
      entry = was_covered ? std::clamp(-state.gap[k], 0.0, entry) : std::max(0.0, -pushed_forward(*coupling).gap);
      continue;
    }
    entry = state.multiplier[k] = 0;
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
                            std::vector<Vector3d>(n, Vector3d::Zero()),
                            std::vector<ContactStatus>(n, ContactStatus::open),
                            std::vector<char>(n, 1), // what overlaps from the start bears
                            std::vector<int>(n, -1),
                            std::vector<double>(n, 0.0)};
  update_active(u, state);
  for (std::size_t k = 0; k < n; ++k) state.start.push_back(relative_position(k, u, state));
  return state;
}

SurfaceContactState SurfaceContact::carried(const SurfaceContactState &other, const Eigen::VectorXd &u) const {
  if (other.covered.size() != points_.size()) throw std::invalid_argument("a contact's state of other points");
  SurfaceContactState state = open(u);
  state.stiffening = other.stiffening;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (!state.covered[k] || !other.covered[k]) continue; // edges differ by what the meshes' faces do
    state.multiplier[k] = other.multiplier[k], state.tangential[k] = other.tangential[k];
    state.entry[k] = other.entry[k];
  }
  return state;
}

void SurfaceContactState::note_change(const std::vector<double> &pressures_before) {
  change = pressure;
  for (std::size_t k = 0; k < pressures_before.size(); ++k) change[k] -= pressures_before[k];
}

void SurfaceContact::expect(SurfaceContactState &state, double times) {
  for (std::size_t k = 0; k < state.change.size(); ++k)
    if (state.multiplier[k] > 0) state.multiplier[k] = std::max(0.0, state.multiplier[k] + times * state.change[k]);
}

SurfaceContact::Augmentation SurfaceContact::augmentation(const SurfaceContactState &state) const {
  Augmentation next{std::vector<double>(points_.size(), 0.0), std::vector<Vector3d>(points_.size(), Vector3d::Zero())};
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
    const double area = points_[k].area, p0 = before.pressure[k], p1 = after.pressure[k];
    if (p0 == 0 && p1 == 0) continue;
    const Vector3d y = relative_position(k, u, after);
    // What came over an edge or left over it had a force at one end of the step, and that force did work.
    const bool over_an_edge = !std::isfinite(before.gap[k]) || !std::isfinite(after.gap[k]);
    const double g0 = std::isfinite(before.gap[k]) ? before.gap[k] : master_.distance(before.start[k]).gap,
                 g1 = std::isfinite(after.gap[k]) ? after.gap[k] : master_.distance(y).gap;
    // A penalty's spring stores energy; what is left of the trapezoidal rule at touch and release is an error of
    // the step, and must show as one. With multipliers there is only the work.
    const bool spring = before.multiplier[k] == 0 && after.multiplier[k] == 0 && before.entry[k] == 0;
    if (spring && !over_an_edge)
      report.normal_work += area * (p1 * p1 - p0 * p0) / (2 * options_.law.normal_penalty * after.stiffening);
    else
      report.normal_work -= 0.5 * area * (p0 + p1) * (g1 - g0);
    report.friction_work -= 0.5 * area * (before.pulled_back[k] + after.pulled_back[k]).dot(y - before.start[k]);
  }
}

void SurfaceContact::commit(const Eigen::VectorXd &u, SurfaceContactState &state, const Renewal &renewal) const {
  const Augmentation next = augmentation(state);
  state.tangential = next.tangential;
  if (renewal.normal == NextMultipliers::none) std::fill(state.multiplier.begin(), state.multiplier.end(), 0.0);
  if (renewal.normal == NextMultipliers::augmented)
    for (std::size_t k = 0; k < points_.size(); ++k)
      if (next.multiplier[k] > 0) // what bears nothing keeps nothing
        state.multiplier[k] += renewal.share * (next.multiplier[k] - state.multiplier[k]);
      else
        state.multiplier[k] = 0;
  constexpr double entries_given_up = 2; // e-folds over a point's width
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Vector3d y = relative_position(k, u, state);
    if (state.entry[k] > 0) {
      const Vector3d way = y - state.start[k], n = master_.distance(y).normal;
      state.entry[k] *= std::exp(-entries_given_up * (way - n.dot(way) * n).norm() / std::sqrt(points_[k].area));
    }
    state.start[k] = y;
  }
  update_active(u, state);
}

} // namespace rimpact::fe
