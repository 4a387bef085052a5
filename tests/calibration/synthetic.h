/// Runs with a known answer: the reduced model's own responses.
#pragma once
#include "calibration/answer/calibration.h"
#include "reduced_models/simulate.h"
#include "responses/run_folder.h"
#include <filesystem>
#include <fmt/format.h>
#include <random>
#include <unistd.h>

namespace rimpact::calibration::testing {

inline std::vector<const StoredRun *> pointers(const std::vector<StoredRun> &runs) {
  std::vector<const StoredRun *> all;
  for (const auto &run : runs) all.push_back(&run);
  return all;
}

inline scene::Scene ricker(double scale, double k_i = 3e8, double e = 0.4, double amplitude_g = 0.78,
                           double period = 1.0) {
  scene::Scene s;
  s.name = fmt::format("ricker-{:g}g-x{:g}", amplitude_g, scale);
  s.excitation.kind = scene::ExcitationKind::ricker;
  s.excitation.amplitude_g = amplitude_g;
  s.excitation.period = period;
  s.excitation.centre = 2 * period;
  s.excitation.duration = 2 * period + 4;
  s.excitation.scale = scale;
  s.reduced.k_i = k_i;
  s.reduced.restitution = e;
  return s;
}

inline scene::Scene window(double speed, double k_i = 3e8, double e = 0.4) {
  scene::Scene s;
  s.name = fmt::format("window-{:g}", speed);
  s.excitation.kind = scene::ExcitationKind::window;
  s.excitation.speed = speed;
  s.excitation.duration = 0.3;
  s.reduced.k_i = k_i;
  s.reduced.restitution = e;
  return s;
}

inline StoredRun run_of(const scene::Scene &s, const WindowOptions &options = {}) {
  return make_run(s.name, s, reduced::simulate(s).response, options);
}

/// Errors as an instrument makes them: force scaled by one draw, each sample of force and displacement under
/// the rim noisy, the returning speed off by one draw; the state before touch stays exact.
inline StoredRun noisy(const scene::Scene &s, unsigned seed, const Uncertainty &u, const WindowOptions &options = {}) {
  auto response = reduced::simulate(s).response;
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  double peak = 0;
  for (const double f : response.series("impact_x")) peak = std::max(peak, std::abs(f));
  const double scale = 1 + u.force * normal(generator);
  bool first = true;
  for (std::size_t i = 0; i < response.size(); ++i) {
    auto &force = response.series("impact_x")[i];
    if (force == 0) continue;
    force = scale * force + u.force * peak * normal(generator);
    if (!first)
      response.series("displacement_x")[i] += u.displacement * s.bearing.lateral_capacity() * normal(generator);
    first = false;
  }
  const double approach = response.series("velocity_x").front(), slip = u.speed * approach * normal(generator);
  for (std::size_t i = 0; i < response.size(); ++i)
    if (response.series("velocity_x")[i] < 0) // from the turn on: the rebound is read at the last pressed sample
      response.series("velocity_x")[i] += slip;
  return make_run(s.name, s, response, options);
}

/// An isolated mass on an elastoplastic rim that cannot pull: stiffness k, yield force, hardening 0.05 k;
/// integrated here (symplectic Euler, 1 us), nothing of the reduced model in it. What a yielding solid rim
/// looks like to a fit.
inline StoredRun yielding_rim(double speed, double k = 6e8, double yield_force = 0.8e6) {
  const auto s = window(speed, 4.5e8, 0.65);
  Response r;
  const double dt = 1e-6, hardening = 0.05 * k;
  double u = s.bearing.lateral_capacity(), v = speed, force = 0, plastic = 0, yield = yield_force;
  for (int n = 0; n <= 150000; ++n) {
    if (n % 500 == 0) {
      r.append("time", n * dt);
      r.append("displacement_x", u);
      r.append("velocity_x", v);
      r.append("impact_x", -force);
      r.append("force_x", -force);
      for (const char *zero :
           {"displacement_y", "displacement_z", "velocity_y", "velocity_z", "impact_y", "force_y", "force_z"})
        r.append(zero, 0);
      r.append("gap", s.bearing.lateral_capacity() - u);
    }
    v -= force / s.load.mass * dt;
    u += v * dt;
    force = k * (u - s.bearing.lateral_capacity() - plastic);
    if (force > yield) {
      const double flow = (force - yield) / (k + hardening);
      plastic += flow;
      yield += hardening * flow;
      force -= k * flow;
    }
    force = std::max(force, 0.0);
  }
  return make_run(s.name, s, r, {});
}

/// A folder that goes away with the test.
class TemporaryFolder {
public:
  TemporaryFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() / fmt::format("rimpact-calibration-{}-{}", ::getpid(), count++);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder &) = delete;
  std::string at(const std::string &name) const { return (path_ / name).string(); }
  /// Simulates and writes a run folder; returns its path.
  std::string write(const scene::Scene &s) const {
    const auto run = reduced::simulate(s);
    write_run_folder(at(s.name), s, run.response, run.summary);
    return at(s.name);
  }

private:
  std::filesystem::path path_;
};

} // namespace rimpact::calibration::testing
