// Which bearings of a building carry: the start of a branch, and landings.
#include "buildings/dynamics.h"
#include <cmath>
#include <Eigen/Cholesky>

namespace rimpact::buildings {

using Eigen::Vector3d, Eigen::VectorXd, Eigen::MatrixXd;
using reduced::Support;

namespace {
constexpr double on_dish = 1e-12; ///< clearance below which an open bearing touches its dish [m]
/// Times its speed scale: ever smaller bounces, passed from one bearing to the next, would follow one another without
/// end; below this rate a slider on its dish stays there.
constexpr double small_bounce = 1e-5;
} // namespace

void BuildingDynamics::update_modes(BearingModes &modes, double t, const VectorXd &y, int leaving) const {
  BearingModes trial = modes;
  for (int b = 0; b < n_bearings(); ++b) {
    const Vector3d u = slider[b].of(y.data()), v = slider[b].of(y.data() + n);
    const auto p = laws[b].height.at(u[0], u[1]);
    const bool rests =
        u[2] - p.z <= on_dish && std::abs(v[2] - p.gradient.dot(v.head<2>())) <= small_bounce * laws[b].speed_scale;
    if (modes[b].support == Support::airborne && rests) trial[b].support = Support::sliding;
    if (b == leaving) trial[b].support = Support::airborne;
  }
  std::vector<int> closed;
  std::vector<Vector3d> per_normal;
  const BuildingResponse r = unsupported(trial, t, y, closed, per_normal);
  const VectorXd N = support_equations(r, closed, per_normal).solve_without_pull(1e-14 * weight);
  modes = trial;
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (!(N[i] > 0)) modes[closed[i]].support = Support::airborne;
}

double BuildingDynamics::land(int b, BearingModes &modes, double t, VectorXd &y) const {
  const auto G_of = [&](int i) {
    const Vector3d u = slider[i].of(y.data());
    const auto p = laws[i].height.at(u[0], u[1]);
    VectorXd G = VectorXd::Zero(n);
    slider[i].add({-p.gradient[0], -p.gradient[1], 1}, G);
    return G;
  };
  const double before = kinetic_energy(y), approach = G_of(b).dot(y.segment(n, n));
  const double rebound = -vertical_restitution * approach;
  const bool bounces = rebound > small_bounce * laws[b].speed_scale;
  std::vector<int> held{b};
  for (int i = 0; i < n_bearings(); ++i) {
    if (i == b) continue;
    const Vector3d u = slider[i].of(y.data());
    const bool lands_too = u[2] - laws[i].height.at(u[0], u[1]).z < 10 * on_dish && G_of(i).dot(y.segment(n, n)) < 0;
    if (modes[i].support != Support::airborne || lands_too) held.push_back(i);
  }
  VectorXd impulse;
  MatrixXd G;
  for (;;) { // bearings that would have to be pulled down are let go
    const int m = static_cast<int>(held.size());
    G.resize(n, m);
    for (int i = 0; i < m; ++i) G.col(i) = G_of(held[i]);
    VectorXd change = -(G.transpose() * y.segment(n, n));
    for (int i = 0; bounces && i < m; ++i) // of all that land
      if (modes[held[i]].support == Support::airborne) change[i] *= 1 + vertical_restitution;
    impulse = (G.transpose() * model.mass.cwiseInverse().asDiagonal() * G).ldlt().solve(change);
    int pulled = 0;
    for (int i = 1; i < m; ++i)
      if (impulse[i] < (pulled ? impulse[pulled] : -1e-9 * std::abs(impulse[0]))) pulled = i;
    if (!pulled) break;
    modes[held[pulled]].support = Support::airborne;
    held.erase(held.begin() + pulled);
  }
  y.segment(n, n) += model.mass.cwiseInverse().cwiseProduct(G * impulse);
  if (!bounces) {
    for (const int i : held) modes[i].support = Support::sliding;
    project(modes, y);
    update_modes(modes, t, y);
    project(modes, y);
  }
  return before - kinetic_energy(y);
}

} // namespace rimpact::buildings
