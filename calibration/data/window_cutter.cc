#include "calibration/data/window_cutter.h"
#include "calibration/data/pulse.h"
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace rimpact::calibration {

namespace {

/// Travel within which a sample counts as the instant of touch [m].
constexpr double touch_tolerance = 1e-9;

double overshoot(const ImpactWindow &w, const StoredRun &run, const reduced::PhysicalModel &model) {
  const auto &x = run.scene.excitation;
  if (x.kind == scene::ExcitationKind::window && !x.with_weight && !x.with_friction && !x.with_ground)
    return std::numeric_limits<double>::infinity();
  const auto forces = model.forces(w.start);
  const double a = (forces.pendular + forces.friction).head<2>().dot(w.direction) / run.scene.load.mass -
                   model.ground_acceleration(w.start.t).head<2>().dot(w.direction);
  const double v = w.start.v.head<2>().dot(w.direction);
  return a < 0 ? v * v / (-2 * a) : std::numeric_limits<double>::infinity();
}

} // namespace

void press_earlier(reduced::BearingState &start, const StoredRun &run, std::size_t index) {
  for (std::size_t earlier = 0; earlier < index; ++earlier) {
    const auto &impact = run.summary.impacts[earlier];
    const double angle = impact.direction_deg * std::numbers::pi / 180;
    start.rim.press({std::cos(angle), std::sin(angle)}, impact.peak_penetration, reduced::dent_shape(run.scene));
  }
}

void judge_grazing(ImpactWindow &w, const StoredRun &run, const reduced::PhysicalModel &model,
                   const WindowOptions &options) {
  w.overshoot = overshoot(w, run, model);
  w.grazing = !run.is_window() && w.overshoot < options.grazing_overshoot * run.scene.bearing.lateral_capacity();
}

WindowCutter::WindowCutter(const StoredRun &run, const WindowOptions &options)
    : run_(run), r_(run.response), times_(run.response.series("time")), options_(options), model_(run.scene),
      L_c_(run.scene.bearing.lateral_capacity()) {}

std::optional<ImpactWindow> WindowCutter::cut(std::size_t index, std::string &reason) const {
  ImpactWindow w;
  w.impact = run_.summary.impacts[index];
  const std::size_t touch = touch_sample(w.impact);
  w.direction = planar(r_, "displacement", touch).normalized();
  w.capacity = touch_travel(touch, w.dented);
  std::size_t start = touch;
  const double begin = w.capacity - options_.lead;
  while (start > 0 && travel(start) > begin + touch_tolerance) --start;
  if (travel(start) > w.capacity + touch_tolerance) {
    reason = fmt::format("it begins pressed {:.3g} mm into the rim", 1e3 * (travel(start) - w.capacity));
    return {};
  }
  w.start = state(start);
  press_earlier(w.start, run_, index);
  const double next = index + 1 < run_.summary.impacts.size() ? run_.summary.impacts[index + 1].touch_time
                                                              : std::numeric_limits<double>::infinity();
  collect(w, start, std::min(w.impact.release_time + options_.tail, next));
  const auto pressed = std::count_if(w.force.begin(), w.force.end(), [](double f) { return f != 0; });
  if (pressed < options_.minimum_samples) {
    reason = fmt::format("only {} samples carry rim force, {} are needed: run it with a smaller step", pressed,
                         options_.minimum_samples);
    return {};
  }
  if (index + 1 == run_.summary.impacts.size() && doubt_of_rebound(r_, run_.summary.impacts)) {
    reason = still_pressed;
    return {};
  }
  w.peak = smooth_peak(w.times, w.force);
  judge_grazing(w, run_, model_, options_);
  return w;
}

std::size_t WindowCutter::touch_sample(const Impact &impact) const {
  auto i = static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), impact.touch_time - 1e-12) -
                                    times_.begin());
  while (i + 1 < times_.size() && pressing(i) == 0) ++i;
  return std::min(i, times_.size() - 1);
}

double WindowCutter::touch_travel(std::size_t touch, bool &dented) const {
  dented = touch > 0 && travel(touch - 1) > L_c_ + dent_tolerance;
  const bool own =
      options_.touch == TouchReference::own_touch || (options_.touch == TouchReference::automatic && dented);
  if (!own || touch == 0 || touch + 1 >= times_.size()) return L_c_;
  // the force of the first two samples, followed back to zero: touch lies between two samples
  const double u = travel(touch), slope = (pressing(touch + 1) - pressing(touch)) / (travel(touch + 1) - u);
  const double back = slope > 0 ? u - pressing(touch) / slope : u;
  return std::clamp(back, std::min(travel(touch - 1), u), u);
}

reduced::BearingState WindowCutter::state(std::size_t i) const {
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
  if (s.v.head<2>().norm() > 0) s.eta = s.v.head<2>().normalized(); // it has slid far beyond the elastic slip
  return s;
}

void WindowCutter::collect(ImpactWindow &w, std::size_t start, double end) const {
  std::size_t i = start;
  for (; i < times_.size() && times_[i] <= end; ++i) {
    if (!w.times.empty() && times_[i] <= w.times.back()) { // a jump stored twice: the later value is the one after
      w.force.back() = -planar(r_, "impact", i).dot(w.direction);
      continue;
    }
    w.times.push_back(times_[i]);
    w.displacement.push_back(planar(r_, "displacement", i).dot(w.direction));
    w.force.push_back(-planar(r_, "impact", i).dot(w.direction));
  }
  w.end_time = w.times.back();
}

} // namespace rimpact::calibration
