#include "calibration/fit/impact_curves.h"
#include "calibration/data/measured_name.h"
#include "calibration/data/measured_run.h"
#include "calibration/fit/shooting.h"
#include "io/files/file.h"
#include "scene/toml_writer.h"
#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

using nlohmann::json;

RunSource source_of(const StoredRun &run) {
  if (is_mapping(run.folder)) return RunSource::measured;
  return run.summary.rung == SolvedBy::reduced ? RunSource::reduced_model : RunSource::finite_elements;
}

/// Last instant with force [s]; the first instant where there is none.
double release(const std::vector<double> &times, const std::vector<double> &force) {
  const auto last = std::find_if(force.rbegin(), force.rend(), [](double f) { return f != 0; });
  return last == force.rend() ? times.front() : times[force.rend() - last - 1];
}

Curve between(double from, double to, double touch, double capacity, const std::vector<double> &times,
              const std::vector<double> &displacement, const std::vector<double> &force) {
  Curve curve;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < from || times[i] > to) continue;
    curve.time.push_back(times[i] - touch);
    curve.penetration.push_back(displacement[i] - capacity);
    curve.force.push_back(force[i]);
  }
  return curve;
}

ImpactCurve curve_of(const StoredRun &run, const ImpactWindow &window, const scene::Scene &scene, bool fitted) {
  const Flight flight = fly(scene, window);
  const double touch = window.impact.touch_time, capacity = run.scene.bearing.lateral_capacity(),
               end = std::max(window.measurement ? window.impact.release_time : release(window.times, window.force),
                              release(flight.times, flight.force)),
               from = touch - 0.05 * (end - touch), to = end + 0.1 * (end - touch);
  return {run.folder,
          source_of(run),
          touch,
          window.impact.approach_speed,
          fitted,
          window.grazing,
          between(from, to, touch, capacity, window.times, window.displacement, window.force),
          between(from, to, touch, capacity, flight.times, flight.displacement, flight.force)};
}

/// Seven digits draw like all of them.
json rounded(const std::vector<double> &values) {
  json list = json::array();
  for (const double value : values) {
    const std::string text = fmt::format("{:.7g}", value);
    double shorter = value;
    std::from_chars(text.data(), text.data() + text.size(), shorter);
    list.push_back(shorter);
  }
  return list;
}

json to_json(const Curve &curve) {
  return {{"time_s", rounded(curve.time)},
          {"penetration_m", rounded(curve.penetration)},
          {"force_N", rounded(curve.force)}};
}

} // namespace

ImpactCurves impact_curves(const std::vector<StoredRun> &fitted, const std::vector<StoredRun> &predicted,
                           const FitResult &law) {
  ImpactCurves curves;
  curves.scene = with_fitted(fitted.front().scene, law);
  for (const auto *runs : {&fitted, &predicted})
    for (const auto &run : *runs) {
      const auto scene = with_fitted(run.scene, law);
      for (const auto &window : run.impacts) curves.impacts.push_back(curve_of(run, window, scene, runs == &fitted));
    }
  return curves;
}

void write_curves(const ImpactCurves &curves, const std::string &folder) {
  json impacts = json::array();
  for (const auto &c : curves.impacts)
    impacts.push_back({{"run", c.run},
                       {"source", word(c.source)},
                       {"touch_time_s", c.touch_time},
                       {"approach_speed_m_s", c.approach_speed},
                       {"fitted", c.fitted},
                       {"grazing", c.grazing},
                       {"reference", to_json(c.reference)},
                       {"law", to_json(c.law)}});
  const json file{{"scene", scene::to_toml(curves.scene)},
                  {"lateral_capacity_m", curves.scene.lateral_capacity()},
                  {"law", curves.scene.reduced.impact_law->name},
                  {"impacts", impacts}};
  write_atomically(file.dump() + "\n", folder + "/curves.json");
}

} // namespace rimpact::calibration
