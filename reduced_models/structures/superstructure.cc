#include "reduced_models/structures/superstructure.h"
#include <cmath>
#include <Eigen/Eigenvalues>
#include <numbers>

namespace rimpact::reduced {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

/// Lowest circular frequency of a chain held at its foot [rad/s].
double first_frequency(const std::vector<double> &masses, const std::vector<double> &stiffnesses) {
  const int n = static_cast<int>(masses.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    K(i, i) += stiffnesses[i];
    if (i == 0) continue;
    K(i - 1, i - 1) += stiffnesses[i];
    K(i, i - 1) -= stiffnesses[i], K(i - 1, i) -= stiffnesses[i];
  }
  const Eigen::MatrixXd M = Eigen::Map<const Eigen::VectorXd>(masses.data(), n).asDiagonal();
  return std::sqrt(
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K, M, Eigen::EigenvaluesOnly).eigenvalues()[0]);
}

} // namespace

Vector3d Storey::force(const Vector3d &drift, const Vector3d &rate, const Vector2d &z) const {
  Vector3d f = -damping * rate;
  const double elastic = hysteresis ? hysteresis->post_yield : 1.0;
  f -= elastic * stiffness * drift;
  if (hysteresis) f.head<2>() -= (1 - elastic) * stiffness * hysteresis->yield * z;
  f[2] = -axial_stiffness * drift[2] - axial_damping * rate[2];
  return f;
}

double Storey::hysteretic_energy(const Vector2d &z) const {
  if (!hysteresis) return 0;
  return (1 - hysteresis->post_yield) * stiffness * hysteresis->yield * hysteresis->yield * z.squaredNorm() / 2;
}

double Storey::elastic_energy(const Vector3d &drift, const Vector2d &z) const {
  const double elastic = hysteresis ? hysteresis->post_yield : 1.0;
  return (elastic * stiffness * drift.head<2>().squaredNorm() + axial_stiffness * drift[2] * drift[2]) / 2 +
         hysteretic_energy(z);
}

double Storey::damping_power(const Vector3d &rate) const {
  return damping * rate.head<2>().squaredNorm() + axial_damping * rate[2] * rate[2];
}

double Storey::hysteretic_power(const Vector3d &rate, const Vector2d &z) const {
  return hysteresis ? (1 - hysteresis->post_yield) * stiffness * hysteresis->yield * z.dot(rate.head<2>()) : 0.0;
}

Superstructure::Superstructure(const scene::Scene &scene) {
  const auto &s = scene.superstructure;
  if (!s.any()) return;
  const std::vector<double> masses = s.floor_masses(scene.load.mass);
  const std::size_t n = masses.size();
  std::vector<double> k = s.inelastic() ? std::vector<double>{} : s.stiffnesses;
  double omega = 2 * std::numbers::pi / s.period;
  if (k.empty()) {
    k.assign(n, 1.0);
    k.assign(n, std::pow(omega / first_frequency(masses, k), 2));
  } else {
    omega = first_frequency(masses, k);
  }
  const double vertical = 2 * std::numbers::pi / s.vertical_period;
  for (std::size_t i = 0; i < n; ++i) {
    const double axial = k[i] * std::pow(vertical / omega, 2);
    storeys.push_back({masses[i], k[i], 2 * s.damping_ratio / omega * k[i], axial,
                       2 * s.vertical_damping_ratio / vertical * axial, std::nullopt});
  }
  if (s.inelastic()) {
    storeys[0].hysteresis = BoucWen{s.yield, s.exponent, s.beta, s.post_yield};
    collapse_drift = storeys[0].hysteresis->collapse_drift();
  }
}

double Superstructure::mass() const {
  double sum = 0;
  for (const auto &storey : storeys) sum += storey.mass;
  return sum;
}

FloorMotion Superstructure::floor(const State &y, int i) const {
  const double *f = y.begin() + iFloors + i * n_floor;
  return {{f[fX], f[fY], f[fZ]}, {f[fVX], f[fVY], f[fVZ]}};
}

Vector2d Superstructure::hysteresis(const State &y, int i) {
  const double *f = y.begin() + iFloors + i * n_floor;
  return {f[fEX], f[fEY]};
}

Vector3d Superstructure::drift(const State &y, const Vector3d &base, int i) const {
  return floor(y, i).position - (i > 0 ? floor(y, i - 1).position : base);
}

Vector3d Superstructure::force_on_base(const State &y, const FloorMotion &base) const {
  const FloorMotion first = floor(y, 0);
  return -storeys[0].force(first.position - base.position, first.velocity - base.velocity, hysteresis(y, 0));
}

void Superstructure::rates(const State &y, const FloorMotion &base, const Vector3d &a_g, State &dy) const {
  FloorMotion below = base;
  for (int i = 0; i < n_floors(); ++i) {
    const Storey &storey = storeys[i];
    const FloorMotion above = floor(y, i);
    const Vector3d rate = above.velocity - below.velocity;
    const Vector2d z = hysteresis(y, i);
    const Vector3d f = storey.force(above.position - below.position, rate, z);
    double *d = dy.begin() + iFloors + i * n_floor;
    for (int c = 0; c < 3; ++c) {
      d[fX + c] = above.velocity[c];
      d[fVX + c] += f[c] / storey.mass - a_g[c];
      if (i > 0) d[fVX + c - n_floor] -= f[c] / storeys[i - 1].mass;
    }
    if (storey.hysteresis) {
      const Vector2d turning = storey.hysteresis->rate(z, rate.head<2>());
      d[fEX] = turning[0], d[fEY] = turning[1];
    }
    dy[iDamping] += storey.damping_power(rate);
    dy[iHysteretic] += storey.hysteretic_power(rate, z);
    dy[iExternal] -= storey.mass * a_g.dot(above.velocity);
    below = above;
  }
}

void Superstructure::follow(const FloorMotion &base, State &y) const {
  for (int i = 0; i < n_floors(); ++i) {
    double *f = y.begin() + iFloors + i * n_floor;
    for (int c = 0; c < 3; ++c) f[fX + c] = base.position[c], f[fVX + c] = base.velocity[c];
    f[fEX] = f[fEY] = 0;
  }
}

double Superstructure::kinetic_energy(const State &y) const {
  double sum = 0;
  for (int i = 0; i < n_floors(); ++i) sum += storeys[i].mass / 2 * floor(y, i).velocity.squaredNorm();
  return sum;
}

double Superstructure::elastic_energy(const State &y, const Vector3d &base) const {
  double sum = 0;
  for (int i = 0; i < n_floors(); ++i) sum += storeys[i].elastic_energy(drift(y, base, i), hysteresis(y, i));
  return sum;
}

double Superstructure::plastic_energy(const State &y) const {
  double stored = 0;
  for (int i = 0; i < n_floors(); ++i) stored += storeys[i].hysteretic_energy(hysteresis(y, i));
  return y[iHysteretic] - stored;
}

double Superstructure::largest_drift(const State &y, const Vector3d &base) const {
  double largest = 0;
  for (int i = 0; i < n_floors(); ++i) largest = std::max(largest, drift(y, base, i).head<2>().norm());
  return largest;
}

} // namespace rimpact::reduced
