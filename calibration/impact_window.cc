#include "calibration/impact_window.h"
#include "calibration/series.h"
#include "scene/error.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>

namespace rimpact::calibration {

namespace {

/// A rim touched again counts as one impact within this time [s]: walls chatter, bearings do not.
constexpr double chatter_time = 2e-3;
/// Travel beyond L_c without rim force that means a dent [m]; above the contact's own gap tolerance.
constexpr double dent_tolerance = 1e-5;
/// Travel within which a sample counts as the instant of touch [m].
constexpr double touch_tolerance = 1e-9;

void complete_velocities(scene::Response &response) {
  for (const char *axis : {"x", "y", "z"}) {
    const std::string u = std::string("displacement_") + axis, v = std::string("velocity_") + axis;
    if (response.has(u) && !response.has(v))
      response.series(v) = differentiate(response.series("time"), response.series(u));
  }
}

Eigen::Vector2d planar(const scene::Response &response, const std::string &name, std::size_t i) {
  return {response.series(name + "_x")[i], response.series(name + "_y")[i]};
}

void silence_noise(scene::Response &response, double share) {
  if (share <= 0) return;
  double peak = 0;
  for (std::size_t i = 0; i < response.size(); ++i)
    peak = std::max(peak, planar(response, "impact", i).norm());
  for (std::size_t i = 0; i < response.size(); ++i)
    if (planar(response, "impact", i).norm() < share * peak)
      response.series("impact_x")[i] = response.series("impact_y")[i] = 0;
}

std::vector<scene::Impact> merge_chatter(const std::vector<scene::Impact> &impacts) {
  std::vector<scene::Impact> merged;
  for (const auto &next : impacts) {
    if (merged.empty() || next.touch_time - merged.back().release_time > chatter_time) {
      merged.push_back(next);
      continue;
    }
    auto &impact = merged.back();
    impact.release_time = next.release_time;
    impact.rebound_speed = next.rebound_speed;
    impact.peak_force = std::max(impact.peak_force, next.peak_force);
    impact.peak_penetration = std::max(impact.peak_penetration, next.peak_penetration);
  }
  return merged;
}

class Cutter {
public:
  Cutter(const StoredRun &run, const WindowOptions &options)
      : run_(run), r_(run.response), times_(run.response.series("time")), options_(options),
        model_(run.scene), L_c_(run.scene.bearing.lateral_capacity()) {}

  /// Empty with a reason when the impact cannot be fitted.
  std::optional<ImpactWindow> cut(std::size_t index, std::string &reason) const {
    ImpactWindow w;
    w.impact = run_.summary.impacts[index];
    const std::size_t touch = touch_sample(w.impact);
    w.direction = planar(r_, "displacement", touch).normalized();
    w.capacity = touch_travel(touch, w.dented);
    std::size_t start = touch;
    while (start > 0 && travel(start) > w.capacity + touch_tolerance) --start;
    if (travel(start) > w.capacity + touch_tolerance) {
      reason = fmt::format("it begins pressed {:.3g} mm into the rim", 1e3 * (travel(start) - w.capacity));
      return {};
    }
    w.start = state(start);
    const double next = index + 1 < run_.summary.impacts.size() ? run_.summary.impacts[index + 1].touch_time
                                                                : std::numeric_limits<double>::infinity();
    collect(w, start, std::min(w.impact.release_time + options_.tail, next));
    const auto pressed = std::count_if(w.force.begin(), w.force.end(), [](double f) { return f != 0; });
    if (pressed < options_.minimum_samples) {
      reason = fmt::format("only {} samples carry rim force, {} are needed: run it with a smaller step",
                           pressed, options_.minimum_samples);
      return {};
    }
    w.peak = smooth_peak(w.times, w.force);
    w.overshoot = overshoot(w);
    w.grazing = w.overshoot < options_.grazing_overshoot * L_c_;
    return w;
  }

private:
  double travel(std::size_t i) const { return planar(r_, "displacement", i).norm(); }
  double pressing(std::size_t i) const { return planar(r_, "impact", i).norm(); }

  std::size_t touch_sample(const scene::Impact &impact) const {
    auto i = static_cast<std::size_t>(
        std::lower_bound(times_.begin(), times_.end(), impact.touch_time - 1e-12) - times_.begin());
    while (i + 1 < times_.size() && pressing(i) == 0) ++i;
    return std::min(i, times_.size() - 1);
  }

  double touch_travel(std::size_t touch, bool &dented) const {
    dented = touch > 0 && travel(touch - 1) > L_c_ + dent_tolerance;
    const bool own = options_.touch == TouchReference::own_touch ||
                     (options_.touch == TouchReference::automatic && dented);
    if (!own || touch == 0 || touch + 1 >= times_.size()) return L_c_;
    // the force of the first two samples, followed back to zero: touch lies between two samples
    const double u = travel(touch), slope = (pressing(touch + 1) - pressing(touch)) / (travel(touch + 1) - u);
    const double back = slope > 0 ? u - pressing(touch) / slope : u;
    return std::clamp(back, std::min(travel(touch - 1), u), u);
  }

  reduced::BearingState state(std::size_t i) const {
    reduced::BearingState s;
    s.t = times_[i];
    s.u.head<2>() = planar(r_, "displacement", i);
    s.v.head<2>() = planar(r_, "velocity", i);
    const auto ground = model_.height(s.u.x(), s.u.y());
    const bool has_height = r_.has("displacement_z");
    const double z = has_height ? r_.series("displacement_z")[i] : ground.z;
    s.airborne = run_.scene.excitation.kind != scene::ExcitationKind::window && z > ground.z + 1e-4;
    s.u.z() = s.airborne ? z : ground.z;
    s.v.z() = s.airborne ? r_.series("velocity_z")[i] : ground.gradient.dot(s.v.head<2>());
    if (s.v.head<2>().norm() > 0)
      s.eta = s.v.head<2>().normalized(); // it has slid far beyond the elastic slip
    return s;
  }

  void collect(ImpactWindow &w, std::size_t start, double end) const {
    std::size_t i = start;
    for (; i < times_.size() && times_[i] <= end; ++i) {
      if (!w.times.empty() &&
          times_[i] <= w.times.back()) { // a jump stored twice: the later value is the one after
        w.force.back() = -planar(r_, "impact", i).dot(w.direction);
        continue;
      }
      w.times.push_back(times_[i]);
      w.displacement.push_back(planar(r_, "displacement", i).dot(w.direction));
      w.force.push_back(-planar(r_, "impact", i).dot(w.direction));
    }
    w.end_time = w.times.back();
  }

  double overshoot(const ImpactWindow &w) const {
    const auto &x = run_.scene.excitation;
    if (x.kind == scene::ExcitationKind::window && !x.with_weight && !x.with_friction && !x.with_ground)
      return std::numeric_limits<double>::infinity();
    const auto forces = model_.forces(w.start);
    const double a = (forces.pendular + forces.friction).head<2>().dot(w.direction) / run_.scene.load.mass -
                     model_.ground_acceleration(w.start.t).head<2>().dot(w.direction);
    const double v = w.start.v.head<2>().dot(w.direction);
    return a < 0 ? v * v / (-2 * a) : std::numeric_limits<double>::infinity();
  }

  const StoredRun &run_;
  const scene::Response &r_;
  const std::vector<double> &times_;
  const WindowOptions &options_;
  reduced::PhysicalModel model_;
  double L_c_;
};

void require(bool ok, const std::string &name, double value, const std::string &bound) {
  if (!ok) throw InputError(fmt::format("{} {:g} must be {}", name, value, bound));
}

} // namespace

void WindowOptions::validate() const {
  require(tail > 0, "tail", tail, "> 0 s");
  require(force_threshold >= 0 && force_threshold <= 0.5, "force_threshold", force_threshold, "in 0..0.5");
  require(minimum_samples >= 4, "minimum_samples", minimum_samples, ">= 4");
  require(grazing_overshoot >= 0, "grazing_overshoot", grazing_overshoot, ">= 0");
}

double StoredRun::peak_force() const {
  double peak = 0;
  for (const auto &w : impacts) peak = std::max(peak, w.peak);
  return peak;
}

double StoredRun::approach_speed() const {
  double speed = 0;
  for (const auto &w : impacts) speed = std::max(speed, w.impact.approach_speed);
  return speed;
}

StoredRun make_run(const std::string &folder, const scene::Scene &scene, scene::Response response,
                   const WindowOptions &options) {
  options.validate();
  StoredRun run{.folder = folder,
                .scene = scene,
                .response = std::move(response),
                .summary = {},
                .impacts = {},
                .notes = {}};
  if (run.response.size() < 2) throw DataError(folder + ": the response has fewer than two samples");
  complete_velocities(run.response);
  silence_noise(run.response, options.force_threshold);
  scene::summarise_response(run.response, run.summary);
  run.summary.impacts = merge_chatter(run.summary.impacts);
  const Cutter cutter(run, options);
  for (std::size_t i = 0; i < run.summary.impacts.size(); ++i) {
    std::string reason;
    if (auto window = cutter.cut(i, reason))
      run.impacts.push_back(std::move(*window));
    else
      run.notes.push_back(
          fmt::format("impact at {:.4f} s left out: {}", run.summary.impacts[i].touch_time, reason));
  }
  return run;
}

StoredRun read_run(const std::string &folder, const WindowOptions &options) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(folder)) throw DataError(folder + ": not a run folder");
  if (!fs::exists(fs::path(folder) / "scene.toml"))
    throw DataError(folder + ": no scene.toml, so its bearing and load are unknown");
  const auto scene = scene::load_scene((fs::path(folder) / "scene.toml").string());
  StoredRun run = make_run(folder, scene, scene::read_response(folder), options);
  if (std::ifstream file(fs::path(folder) / "summary.json"); file) {
    const auto json = nlohmann::json::parse(file, nullptr, false);
    if (json.is_discarded()) throw DataError(folder + "/summary.json is not valid JSON");
    run.summary.status = json.value("status", "done");
    if (json.contains("rung") && json["rung"].is_string()) run.summary.rung = json["rung"];
    if (run.summary.status != "done")
      run.notes.push_back(fmt::format("the run is {}: only what it holds is used", run.summary.status));
  }
  return run;
}

} // namespace rimpact::calibration
