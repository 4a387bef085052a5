#include "problem.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact::work_precision {

Problem::Problem(const std::string &called, const scene::Scene &s)
    : name(called), R0(s.bearing.surface.R0), a(s.bearing.surface.a), mass(s.load.mass), weight(s.load.vertical),
      mu(s.reduced.mu_fast), elastic_slip(s.reduced.elastic_slip), k_i(s.reduced.k_i),
      lateral_capacity(s.bearing.lateral_capacity()), duration(s.excitation.duration),
      output_step(s.reduced.output_step), excitation(s.excitation), gravity(s.load.gravity) {
  const double log_e = std::log(s.reduced.restitution), xi = -log_e / std::hypot(std::numbers::pi, log_e);
  c_i = 2 * xi * std::sqrt(k_i * mass); // (2-20), rim fixed to the ground
}

void Problem::rhs(const scene::GroundMotion &ground, double t, const double *y, double *dy) const {
  const double x[2] = {y[0], y[1]}, v[2] = {y[2], y[3]}, eta[2] = {y[4], y[5]};
  const double r = std::hypot(x[0], x[1]), s = std::sqrt(1 - r * r / (a * a));
  const double slope = 1 / (R0 * s),
               bend = slope / (a * a * s * s); // grad h = slope x, hess h = slope I + bend x x
  const double g[2] = {slope * x[0], slope * x[1]}, S = std::sqrt(1 + g[0] * g[0] + g[1] * g[1]);
  const auto a_g = ground.acceleration(t);
  double F[2] = {-mass * a_g[0], -mass * a_g[1]};
  const double depth = r - lateral_capacity, xv = x[0] * v[0] + x[1] * v[1];
  if (depth > 0)
    for (int i : {0, 1}) F[i] -= (k_i * depth + c_i * xv / r) * x[i] / r;
  const double curvature = slope * (v[0] * v[0] + v[1] * v[1]) + bend * xv * xv;
  const double N = (mass * curvature + g[0] * F[0] + g[1] * F[1] + weight + mass * a_g[2]) / S;
  const double eta_z = g[0] * eta[0] + g[1] * eta[1], eta_2 = eta[0] * eta[0] + eta[1] * eta[1];
  const double rub = eta_2 > 0 ? mu * std::sqrt(eta_2 / (eta_2 + eta_z * eta_z)) : 0;
  const double work = std::max(0.0, eta[0] * v[0] + eta[1] * v[1]);
  for (int i : {0, 1}) {
    dy[i] = v[i];
    dy[2 + i] = (F[i] - N * g[i] / S - N * rub * eta[i]) / mass;
    dy[4 + i] = (v[i] - work * eta[i]) / elastic_slip;
  }
}

nlohmann::json Problem::to_json() const {
  nlohmann::json j{{"name", name},
                   {"R0", R0},
                   {"a", a},
                   {"mass", mass},
                   {"weight", weight},
                   {"mu", mu},
                   {"slip", elastic_slip},
                   {"k_i", k_i},
                   {"c_i", c_i},
                   {"capacity", lateral_capacity},
                   {"duration", duration},
                   {"output_step", output_step}};
  if (excitation.kind == scene::ExcitationKind::ricker) {
    j["pulse"] = {{"amplitude", excitation.scale * excitation.amplitude_g * gravity},
                  {"period", excitation.period},
                  {"centre", excitation.centre}};
    return j;
  }
  j["record_dt"] = excitation.x.dt;
  for (std::size_t i = 0; i < std::min(excitation.x.values.size(), excitation.y.values.size()); ++i) {
    j["record_x"].push_back(excitation.scale * excitation.x.values[i]);
    j["record_y"].push_back(excitation.scale * excitation.y.values[i]);
  }
  for (const char *axis : {"record_x", "record_y"}) j[axis].insert(j[axis].end(), 2, 0.0); // to interpolate at the end
  return j;
}

} // namespace rimpact::work_precision
