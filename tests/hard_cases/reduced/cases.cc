#include "cases.h"
#include "reduced_models/simulate.h"
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::hard_cases {
namespace {

using scene::ExcitationKind;

scene::Scene pulse(double scale = 1.0) { // 0.78 g, 1.0 s
  scene::Scene s;
  s.excitation.scale = scale;
  return s;
}

scene::Scene free_motion(const Eigen::Vector2d &u, const Eigen::Vector2d &v) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::free;
  s.excitation.initial_displacement = u;
  s.excitation.initial_velocity = v;
  s.excitation.duration = 6;
  return s;
}

scene::Scene window(double speed, double mu) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::window;
  s.excitation.speed = speed;
  s.excitation.with_weight = s.excitation.with_friction = true;
  s.excitation.duration = 0.5;
  s.reduced.mu_slow = s.reduced.mu_fast = mu;
  return s;
}

scene::Scene with(scene::Scene s, const std::function<void(scene::Scene &)> &change) {
  change(s);
  return s;
}

scene::Scene rubbing(double mu) {
  return with(pulse(1.1), [=](auto &s) { s.reduced.mu_slow = s.reduced.mu_fast = mu; });
}

/// A sum of sines under a slow envelope, sampled: `peak` [m/s^2], from rest to rest.
SampledSignal shaking(double peak, double dt, double duration, double shift) {
  SampledSignal a{.dt = dt, .values = {}};
  for (int i = 0; i * dt <= duration; ++i) {
    const double t = i * dt, envelope = std::pow(std::sin(std::numbers::pi * t / duration), 2);
    double sum = 0;
    for (const double frequency : {0.31, 0.53, 1.07, 2.9, 6.1})
      sum += std::sin(2 * std::numbers::pi * frequency * (t + shift)) / std::sqrt(frequency);
    a.values.push_back(peak / 3 * envelope * sum);
  }
  return a;
}

scene::Scene record(double peak_xy, double peak_z, double dt, double duration) {
  scene::Scene s;
  s.excitation.kind = ExcitationKind::record;
  s.excitation.duration = duration;
  s.excitation.x = shaking(peak_xy, dt, duration, 0);
  s.excitation.y = shaking(0.7 * peak_xy, dt, duration, 11.3);
  if (peak_z > 0) s.excitation.z = shaking(peak_z, dt, duration, 27.1);
  return s;
}

double residual(const reduced::ReducedRun &run) {
  return run.summary.residual_displacement;
}

void add_impacts(std::vector<Case> &list) {
  const double critical = reduced::critical_scale(pulse(), 0.9, 1.1, 1e-9).value();
  list.push_back({"critical amplitude - 0.1 %", pulse(critical * 0.999), true, "impacts",
                  [](const auto &run) { return double(run.summary.impacts.size()); }, 0});
  list.push_back({"critical amplitude + 0.1 %", pulse(critical * 1.001), true, "impacts - 1",
                  [](const auto &run) { return double(run.summary.impacts.size()) - 1; }, 0});
  list.push_back({"scale 1.4: impacts, uplift", pulse(1.4), true, "least N",
                  [](const auto &run) { return *run.summary.min_normal_force; }, 0});
  list.push_back({"mu = 0", rubbing(0), true, "friction loss [J]",
                  [](const auto &run) { return run.summary.energy->friction; }, 0});
  list.push_back({"mu = 0.3", rubbing(0.3)});
  list.push_back({"e = 0.05", with(pulse(1.1), [](auto &s) { s.reduced.restitution = 0.05; })});
  list.push_back({"e = 1", with(pulse(1.1), [](auto &s) { s.reduced.restitution = 1; }), true, "rim loss [J]",
                  [](const auto &run) { return run.summary.energy->impact; }, 1e-3});
  list.push_back({"k_i x 100", with(pulse(1.1), [](auto &s) { s.reduced.k_i *= 100; })});
  list.push_back({"oblique impact", with(pulse(1.1), [](auto &s) { s.excitation.direction_deg = 37; })});
  list.push_back({"oblique, other motion", free_motion({0.2, 0}, {1.5, 1.5})});
  list.push_back({"tangential impact", free_motion({0.389, 0}, {0, 3})});
  list.push_back({"stick while in contact", window(0.005, 0.3), true, "final speed [m/s]",
                  [](const auto &run) { return std::abs(run.response.series("velocity_x").back()); }, 0});
}

void add_surfaces(std::vector<Case> &list) {
  const auto dish = [](scene::SurfaceKind kind) {
    return with(pulse(1.1), [=](auto &s) {
      s.bearing.surface.kind = kind;
      s.bearing.surface.coefficients = {1 / 4.5, 0, 0.3, 0, 0.5};
    });
  };
  list.push_back({"a = R0 (ellipse)", with(pulse(1.1), [](auto &s) { s.bearing.surface.a = 2.25; })});
  list.push_back({"sphere", dish(scene::SurfaceKind::sphere)});
  list.push_back({"polynomial", dish(scene::SurfaceKind::polynomial)});
  list.push_back({"cone", with(dish(scene::SurfaceKind::cone), [](auto &s) { s.bearing.surface.R0 = 0.3; })});
  list.push_back({"table, rows each 10 mm", with(dish(scene::SurfaceKind::table), [](auto &s) {
                    const auto ellipse = scene::make_surface(scene::SurfaceSpec{});
                    for (int i = 0; i <= 53; ++i) {
                      s.bearing.surface.table_radius.push_back(0.01 * i);
                      s.bearing.surface.table_height.push_back(ellipse->at(0.01 * i, 0).z);
                    }
                  })});
  list.push_back({"r_p within 1 % of a",
                  with(pulse(1.1), [](auto &s) { s.bearing.surface.planar_radius = 0.995 * s.bearing.surface.a; }),
                  false});
  list.push_back({"leaves the dish", with(pulse(1.8), [](auto &s) { s.reduced.k_i = 0; }), false});
}

void add_records(std::vector<Case> &list) {
  list.push_back({"vertical acceleration 1.3 g", record(1, 1.3 * 9.81, 0.01, 20)});
  list.push_back({"thrown over the rim", record(5, 1.3 * 9.81, 0.01, 20), false});
  list.push_back({"record, dt 0.02 s", record(4, 0, 0.02, 30)});
  list.push_back({"record, dt 0.005 s", record(4, 0, 0.005, 30)});
  list.push_back({"100 s of 0.02 g: holds", record(0.02 * 9.81, 0, 0.01, 100), true, "residual [m]", residual, 0});
  list.push_back({"100 s of 0.05 g: creeps", record(0.05 * 9.81, 0, 0.01, 100)});
  // 0.08 J in all, where the Park-Wen state stores 6 J: its energies close at a tolerance of 1e-10 only.
  const auto park_wen = [](auto &s) { s.reduced.friction = scene::Friction::park_wen, s.reduced.tolerance = 1e-10; };
  list.push_back({"100 s of 0.01 g: park-wen", with(record(0.01 * 9.81, 0, 0.01, 100), park_wen), true, "residual [m]",
                  residual, 1e-5});
  for (const double factor : {10.0, 1000.0})
    list.push_back({fmt::format("tolerance x {:g}", factor),
                    with(pulse(1.1), [=](auto &s) { s.reduced.tolerance *= factor; }), false});
}

} // namespace

std::vector<Case> cases() {
  std::vector<Case> list;
  add_impacts(list);
  add_surfaces(list);
  add_records(list);
  return list;
}

} // namespace rimpact::hard_cases
