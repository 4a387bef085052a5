// Time of a reduced run beside its error against the same run at tight tolerance: `bench_reduced`.
#include "reduced_models/physical_model.h"
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>

using namespace rimpact;

namespace {

/// 12 s of the 0.78 g pulse at scale 1.05: one clear impact.
scene::Scene pulse(const char *friction, double tolerance) {
  scene::Scene s;
  s.excitation.scale = 1.05;
  s.excitation.duration = 12;
  s.reduced.friction = friction;
  s.reduced.tolerance = tolerance;
  return s;
}

void report(benchmark::State &state, const scene::Summary &run, const scene::Summary &tight) {
  state.counters["error_displacement"] = std::abs(run.peak_displacement / tight.peak_displacement - 1);
  state.counters["error_force"] = std::abs(*run.peak_impact_force / *tight.peak_impact_force - 1);
  state.counters["imbalance"] = std::abs(run.energy->imbalance_relative());
  state.counters["steps"] = static_cast<double>(run.n_steps);
}

/// range(0): -log10 of the tolerance.
void own_stepper(benchmark::State &state, const char *friction) {
  const scene::Scene s = pulse(friction, std::pow(10, -static_cast<double>(state.range(0))));
  scene::Summary run;
  for (auto _ : state) run = reduced::simulate_summary(s);
  report(state, run, reduced::simulate_summary(pulse(friction, 1e-13)));
}

void cvode(benchmark::State &state, const char *friction) {
  const scene::Scene s = pulse(friction, std::pow(10, -static_cast<double>(state.range(0))));
  scene::Summary run;
  for (auto _ : state) run = reduced::simulate_with_cvode(s).summary;
  report(state, run, reduced::simulate_summary(pulse(friction, 1e-13)));
}

/// The same pulse on another dish; `table` has the ellipse's rows every 10 mm.
void on_dish(benchmark::State &state, const char *kind) {
  scene::Scene s = pulse("coulomb", 1e-9), tight = pulse("coulomb", 1e-13);
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
  scene::Summary run;
  for (auto _ : state) run = reduced::simulate_summary(s);
  report(state, run, reduced::simulate_summary(tight));
}

void stored(benchmark::State &state) {
  const scene::Scene s = pulse("coulomb", 1e-9);
  for (auto _ : state) benchmark::DoNotOptimize(reduced::simulate(s));
}

void scout(benchmark::State &state) {
  scene::Scene s = pulse("coulomb", 1e-9);
  s.reduced.finite_pad = s.reduced.socket_friction = true;
  for (auto _ : state) benchmark::DoNotOptimize(reduced::simulate_summary(s));
}

void critical(benchmark::State &state) {
  const scene::Scene s = pulse("coulomb", 1e-9);
  for (auto _ : state) benchmark::DoNotOptimize(reduced::critical_scale(s));
}

} // namespace

BENCHMARK_CAPTURE(own_stepper, coulomb, "coulomb")->DenseRange(5, 11, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(own_stepper, park_wen, "park-wen")->DenseRange(5, 9, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cvode, coulomb, "coulomb")->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cvode, park_wen, "park-wen")->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(on_dish, cone, "cone")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(on_dish, polynomial, "polynomial")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(on_dish, table, "table")->Unit(benchmark::kMillisecond);
BENCHMARK(stored)->Unit(benchmark::kMillisecond);
BENCHMARK(scout)->Unit(benchmark::kMillisecond);
BENCHMARK(critical)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
