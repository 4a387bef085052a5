// Time of a building's run beside its error against the same run at tight tolerance: `bench_buildings`.
#include "buildings/frame_source.h"
#include "buildings/regular_building.h"
#include "buildings/simulate.h"
#include "plain_cvode.h"
#include <benchmark/benchmark.h>
#include <cmath>
#include <map>

using namespace rimpact;
using namespace rimpact::buildings;

namespace {

/// 40 s in two directions: the built-in near-fault motion, rims struck. `slip` [m].
scene::Scene motion(double slip, double tolerance) {
  scene::Scene s = scene::load_scene("pulse-bidirectional", {"reduced.friction=\"park-wen\""});
  s.excitation.duration = 40, s.reduced.elastic_slip = slip, s.reduced.tolerance = tolerance;
  s.reduced.impact_law = &laws::impact_law("hunt-crossley");
  return s;
}

Frame thesis() {
  return make_frame(load_building("thesis-2.4"));
}

const Summary &exact(double slip) {
  static std::map<double, Summary> kept;
  if (!kept.count(slip)) kept[slip] = simulate(thesis(), motion(slip, 1e-11), {}, false).summary;
  return kept[slip];
}

double drift(const Summary &s) {
  return s.extra.at("building").at("floors")[0].at("peak_drift_m").get<double>();
}

/// What stands beside the time.
void count(benchmark::State &state, const Summary &run, const Summary &fine) {
  state.counters["error_displacement"] = std::abs(run.peak_displacement / fine.peak_displacement - 1);
  state.counters["error_force"] = std::abs(run.peak_lateral_force / fine.peak_lateral_force - 1);
  state.counters["error_drift"] = std::abs(drift(run) / drift(fine) - 1);
  state.counters["imbalance"] = std::abs(run.energy->imbalance_relative());
  state.counters["impacts"] = static_cast<double>(run.impacts.size());
  state.counters["steps"] = static_cast<double>(run.n_steps);
}

/// range(0): -log10 of the tolerance; range(1): elastic slip [um].
void thesis_40_s(benchmark::State &state) {
  const double slip = 1e-6 * static_cast<double>(state.range(1));
  const scene::Scene s = motion(slip, std::pow(10, -static_cast<double>(state.range(0))));
  const Frame frame = thesis();
  Summary run;
  while (state.KeepRunning()) run = simulate(frame, s, {}, false).summary;
  count(state, run, exact(slip));
}

/// The same equations without branches or events by SUNDIALS.
void cvode_40_s(benchmark::State &state) {
  const double slip = 1e-6 * static_cast<double>(state.range(1));
  const scene::Scene s = motion(slip, std::pow(10, -static_cast<double>(state.range(0))));
  const BuildingModel model = assemble(thesis());
  PlainAnswer run;
  while (state.KeepRunning()) run = plain_cvode(model, s, s.reduced.tolerance);
  const Summary &fine = exact(slip);
  state.counters["error_displacement"] = std::abs(run.travel / fine.peak_displacement - 1);
  state.counters["error_force"] = std::abs(run.base_shear / fine.peak_lateral_force - 1);
  state.counters["error_drift"] = std::abs(run.drift / drift(fine) - 1);
  state.counters["least_normal_kN"] = 1e-3 * run.smallest_normal;
  state.counters["steps"] = static_cast<double>(run.n_steps);
}

/// Six LIR-DCFP bearings of four points a set under the thesis's building, rims struck; range(0): -log10 of the step
/// tolerance.
void lir_40_s(benchmark::State &state) {
  const auto at = [](double tolerance) {
    scene::Scene s =
        scene::load_scene("pulse-bidirectional",
                          {"reduced.friction=\"park-wen\"", "reduced.elastic_slip_mm=1", "reduced.model=\"lir-dcfp\"",
                           "reduced.impact_law=\"hunt-crossley\"", "reduced.k_i_kN_per_m=4e4",
                           "isolator.space=\"spatial\"", "isolator.points=4", "excitation.duration_s=40"});
    s.isolator.step_tolerance = tolerance;
    return s;
  };
  const Frame frame = thesis();
  Summary run;
  while (state.KeepRunning())
    run = simulate(frame, at(std::pow(10, -static_cast<double>(state.range(0)))), {}, false).summary;
  static const Summary fine = simulate(frame, at(1e-6), {}, false).summary;
  count(state, run, fine);
}

/// The inelastic frame of thesis 2.5 on three SH-FPS dishes, rims struck, sections yielding; range(0): -log10 of the
/// step tolerance.
void inelastic_frame_40_s(benchmark::State &state) {
  const auto at = [](double tolerance) {
    scene::Scene s = scene::load_scene("ricker-0.78g-1.0s", {"reduced.friction=\"park-wen\"", "excitation.scale=1.4",
                                                             "reduced.elastic_slip_mm=1", "excitation.duration_s=40"});
    s.isolator.step_tolerance = tolerance;
    return s;
  };
  const Frame frame = load_frame("thesis-2.5");
  Summary run;
  while (state.KeepRunning())
    run = simulate(frame, at(std::pow(10, -static_cast<double>(state.range(0)))), {}, false).summary;
  static const Summary fine = simulate(frame, at(1e-8), {}, false).summary;
  count(state, run, fine);
  state.counters["ductility"] =
      run.extra.at("building").at("inelastic").at("sections")[0].at("peak_ductility").get<double>();
}

/// A base and one storey on range(0) x range(0) bearings, 10 s.
void bearings(benchmark::State &state) {
  RegularBuilding b;
  for (int i = 0; i < state.range(0); ++i) b.x.push_back(8.0 * i), b.y.push_back(8.0 * i);
  b.storeys = {3.5};
  const Frame frame = make_frame(b);
  scene::Scene s = motion(1e-3, 1e-6);
  s.excitation.duration = 10;
  Summary run;
  while (state.KeepRunning()) run = simulate(frame, s, {}, false).summary;
  state.counters["bearings"] = static_cast<double>(state.range(0) * state.range(0));
  state.counters["steps"] = static_cast<double>(run.n_steps);
  state.SetComplexityN(state.range(0) * state.range(0));
}

} // namespace

BENCHMARK(thesis_40_s)->ArgsProduct({{4, 5, 6, 8}, {1000, 500, 100}})->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(cvode_40_s)->ArgsProduct({{5, 6, 7, 8}, {1000}})->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(lir_40_s)->DenseRange(3, 5)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(inelastic_frame_40_s)->DenseRange(3, 6)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(bearings)->DenseRange(2, 8, 2)->Unit(benchmark::kMillisecond)->Iterations(1)->Complexity();
BENCHMARK_MAIN();
