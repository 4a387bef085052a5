// Time of a reduced run beside its error against the same run at tight tolerance: `bench_reduced`.
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>

using namespace rimpact;

namespace {

/// 12 s of the 0.78 g pulse at scale 1.05: one clear impact.
scene::Scene pulse(scene::Friction friction, double tolerance) {
  scene::Scene s;
  s.excitation.scale = 1.05;
  s.excitation.duration = 12;
  s.reduced.friction = friction;
  s.reduced.tolerance = tolerance;
  return s;
}

void report(benchmark::State &state, const Summary &run, const Summary &tight) {
  state.counters["error_displacement"] = std::abs(run.peak_displacement / tight.peak_displacement - 1);
  state.counters["error_force"] = std::abs(*run.peak_impact_force / *tight.peak_impact_force - 1);
  state.counters["imbalance"] = std::abs(run.energy->imbalance_relative());
  state.counters["steps"] = static_cast<double>(run.n_steps);
}

/// range(0): -log10 of the tolerance.
void own_stepper(benchmark::State &state, scene::Friction friction) {
  const scene::Scene s = pulse(friction, std::pow(10, -static_cast<double>(state.range(0))));
  Summary run;
  while (state.KeepRunning()) run = reduced::simulate_summary(s);
  report(state, run, reduced::simulate_summary(pulse(friction, 1e-13)));
}

void cvode(benchmark::State &state, scene::Friction friction) {
  const scene::Scene s = pulse(friction, std::pow(10, -static_cast<double>(state.range(0))));
  Summary run;
  while (state.KeepRunning()) run = reduced::simulate_with_cvode(s).summary;
  report(state, run, reduced::simulate_summary(pulse(friction, 1e-13)));
}

/// The same pulse on another dish; `table` has the ellipse's rows every 10 mm.
void on_dish(benchmark::State &state, scene::SurfaceKind kind) {
  scene::Scene s = pulse(scene::Friction::coulomb, 1e-9), tight = pulse(scene::Friction::coulomb, 1e-13);
  for (scene::Scene *scene : {&s, &tight}) {
    auto &surface = scene->bearing.surface;
    surface.kind = kind;
    surface.coefficients = {1 / 4.5, 0, 0.3, 0, 0.5};
    const auto ellipse = scene::make_surface(scene::SurfaceSpec{});
    for (int i = 0; i <= 53; ++i) {
      surface.table_radius.push_back(0.01 * i);
      surface.table_height.push_back(ellipse->at(0.01 * i, 0).z);
    }
  }
  Summary run;
  while (state.KeepRunning()) run = reduced::simulate_summary(s);
  report(state, run, reduced::simulate_summary(tight));
}

/// 20 s of the built-in near-fault motion on the bearing of the stages' scene, rims struck; bounds: planar
/// 100 ms at 1 % of the peak force, spatial with 4 points 3 s. `points` 2: planar.
void double_concave(benchmark::State &state, scene::ModelKind model, int points) {
  scene::Scene s = scene::load_scene("lir-dcfp-compared", {"excitation.x=\"builtin:near-fault-x\""});
  s.reduced.model = model;
  s.isolator.points = points;
  if (points > 2) {
    s.isolator.space = scene::Space::spatial;
    s.excitation.y = scene::load_scene("pulse-bidirectional").excitation.y;
  }
  s.excitation.scale = 1.2, s.excitation.duration = 20;
  scene::Scene tight = s;
  tight.isolator.step_tolerance = 0.01 * s.isolator.step_tolerance;
  Summary run;
  while (state.KeepRunning()) run = reduced::simulate_summary(s);
  const Summary exact = reduced::simulate_summary(tight);
  report(state, run, exact);
  state.counters["error_lateral"] = std::abs(run.peak_lateral_force / exact.peak_lateral_force - 1);
  state.counters["impacts"] = static_cast<double>(run.impacts.size());
}

/// The four-degrees-of-freedom model of thesis 2.6.1 over 12 s, at the tolerance 10^-range(0).
void four_dof(benchmark::State &state) {
  scene::Scene s = scene::load_scene("frame-four-dof", {"excitation.scale=1.3", "excitation.duration_s=12"}), tight = s;
  s.reduced.tolerance = std::pow(10, -static_cast<double>(state.range(0))), tight.reduced.tolerance = 1e-12;
  Summary run;
  while (state.KeepRunning()) run = reduced::simulate_summary(s);
  const Summary exact = reduced::simulate_summary(tight);
  report(state, run, exact);
  state.counters["error_drift"] =
      std::abs(run.extra["peak_drift_m"].get<double>() / exact.extra["peak_drift_m"].get<double>() - 1);
}

void stored(benchmark::State &state) {
  const scene::Scene s = pulse(scene::Friction::coulomb, 1e-9);
  while (state.KeepRunning()) benchmark::DoNotOptimize(reduced::simulate(s));
}

void scout(benchmark::State &state) {
  scene::Scene s = pulse(scene::Friction::coulomb, 1e-9);
  s.reduced.finite_pad = s.reduced.socket_friction = true;
  while (state.KeepRunning()) benchmark::DoNotOptimize(reduced::simulate_summary(s));
}

void critical(benchmark::State &state) {
  const scene::Scene s = pulse(scene::Friction::coulomb, 1e-9);
  while (state.KeepRunning()) benchmark::DoNotOptimize(reduced::critical_scale(s));
}

} // namespace

BENCHMARK_CAPTURE(own_stepper, coulomb, scene::Friction::coulomb)->DenseRange(5, 11, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(own_stepper, park_wen, scene::Friction::park_wen)->DenseRange(5, 9, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cvode, coulomb, scene::Friction::coulomb)->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cvode, park_wen, scene::Friction::park_wen)->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(on_dish, cone, scene::SurfaceKind::cone)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(on_dish, polynomial, scene::SurfaceKind::polynomial)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(on_dish, table, scene::SurfaceKind::table)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(double_concave, dcfp_planar, scene::ModelKind::dcfp, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(double_concave, lir_planar, scene::ModelKind::lir_dcfp, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(double_concave, lir_spatial, scene::ModelKind::lir_dcfp, 4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(double_concave, lir_spatial_8, scene::ModelKind::lir_dcfp, 8)->Unit(benchmark::kMillisecond);
BENCHMARK(four_dof)->DenseRange(6, 9, 1)->Unit(benchmark::kMillisecond);
BENCHMARK(stored)->Unit(benchmark::kMillisecond);
BENCHMARK(scout)->Unit(benchmark::kMillisecond);
BENCHMARK(critical)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
