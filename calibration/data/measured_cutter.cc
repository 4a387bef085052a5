#include "calibration/data/measured_cutter.h"
#include "calibration/data/functionals.h"
#include "calibration/data/measured_doubts.h"
#include "calibration/data/measured_history.h"
#include "calibration/data/measured_record.h"
#include "calibration/data/pulse.h"
#include "calibration/data/series.h"
#include "calibration/data/shot_start.h"
#include "calibration/data/window_cutter.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::calibration {

namespace {

constexpr double pressed_share = 0.05; ///< of its peak the force must reach to be compared

class MeasuredCutter {
public:
  MeasuredCutter(StoredRun &run, const MeasuredRecord &record, const WindowOptions &options)
      : run_(run), record_(record), r_(run.response), times_(run.response.series("time")), options_(options),
        model_(run.scene) {}

  std::optional<ImpactWindow> cut(std::size_t index, std::string &reason);

private:
  void collect(ImpactWindow &w, const ShotStart &start, double end) const;
  void find_pressed(ImpactWindow &w, const Contact &contact, const ShotStart &start) const;
  void find_rebound(ImpactWindow &w, std::size_t index, const ShotStart &start) const;

  StoredRun &run_;
  const MeasuredRecord &record_;
  const Response &r_;
  const std::vector<double> &times_;
  const WindowOptions &options_;
  reduced::PhysicalModel model_;
};

std::optional<ImpactWindow> MeasuredCutter::cut(std::size_t index, std::string &reason) {
  const Contact &contact = record_.contacts()[index];
  ImpactWindow w;
  w.measurement.emplace();
  const std::size_t n = contact.last - contact.first + 1;
  if (n < static_cast<std::size_t>(options_.minimum_samples)) {
    reason =
        fmt::format("only {} samples carry rim force, {} are needed: sample it faster", n, options_.minimum_samples);
    return {};
  }
  const auto &smooth = record_.force().smooth;
  if (contact.last + 1 == times_.size() &&
      smooth[contact.last] > pressed_share * *std::max_element(smooth.begin() + contact.first, smooth.end())) {
    reason = still_pressed;
    return {};
  }
  const auto start = shot_start(run_, record_, options_, index, reason);
  if (!start) return {};
  w.capacity = start->capacity, w.dented = start->dented;
  w.direction = start->u.normalized();
  w.start = on_the_dish(model_, times_[start->sample], start->u, start->v);
  press_earlier(w.start, run_, index);
  auto &m = *w.measurement;
  m.sigma_displacement = record_.sigma(), m.inflation = record_.inflation(), m.sigma_force = record_.force().sigma;
  m.inflation_force = record_.force().inflation;
  m.freedom_displacement = std::max(1.0, record_.freedom()),
  m.freedom_force = std::max(1.0, record_.force().n_quiet / m.inflation_force - 1.0);
  m.start_factor = start->covariance.llt().matrixL();
  if (!m.start_factor.allFinite()) m.start_factor.setZero();
  w.impact = run_.summary.impacts[index];
  w.impact.approach_speed = start->v.dot(w.direction);
  const Span after = record_.flights(index).after;
  collect(w, *start, after.size() > 0 ? times_[after.last] : times_[contact.last]);
  find_pressed(w, contact, *start);
  find_rebound(w, index, *start);
  w.impact.peak_force = w.peak;
  judge_grazing(w, run_, model_, options_);
  doubt(run_, record_, options_, {index, w, *start});
  run_.summary.impacts[index] = w.impact;
  return w;
}

void MeasuredCutter::collect(ImpactWindow &w, const ShotStart &start, double end) const {
  for (std::size_t i = start.sample; i < times_.size() && times_[i] <= end; ++i) {
    w.times.push_back(times_[i]);
    w.displacement.push_back(planar(r_, "displacement", i).dot(w.direction));
    w.force.push_back(record_.force().push[i]);
  }
  w.end_time = w.times.back();
  w.measurement->flown = start.flown - start.sample;
}

/// From touch to where the force sinks below a share of its peak. A force that sets in with a step is taken up late
/// enough that the model has touched too: a step a sample off is no noise. Chosen by the smoothed force, as samples
/// chosen by their own noise would be biased.
void MeasuredCutter::find_pressed(ImpactWindow &w, const Contact &contact, const ShotStart &start) const {
  auto &m = *w.measurement;
  const auto &push = record_.force().push, &smooth = record_.force().smooth;
  const auto top = static_cast<std::size_t>(
      std::max_element(smooth.begin() + contact.first, smooth.begin() + contact.last + 1) - smooth.begin());
  std::size_t first = start.sample;
  if (contact.jumps) {
    const double level = std::max(pressed_share * smooth[top], noise_reach * m.sigma_force);
    first = contact.first;
    while (first < top && push[first] < level) ++first;
    const double place = std::sqrt(m.start_factor.row(0).squaredNorm()),
                 speed = std::max(w.impact.approach_speed, 1e-6);
    const double late = times_[first] + 3 * place / speed;
    if (m.noisy()) // without noise touch lies exactly between two samples
      while (first < top && times_[first] <= late) ++first;
  } else {
    while (first < top && times_[first] < contact.touch_time) ++first;
  }
  std::size_t last = top;
  while (last < contact.last && smooth[last + 1] > pressed_share * smooth[top]) ++last;
  m.pressed_first = first - start.sample, m.pressed_last = last - start.sample;
  const std::vector<double> near(smooth.begin() + start.sample, smooth.begin() + start.sample + w.times.size());
  m.peak = peak_functional(w.times, w.force, near);
  w.peak = m.peak.weights.empty() ? smooth[top] : m.peak.of(w.force);
}

void MeasuredCutter::find_rebound(ImpactWindow &w, std::size_t index, const ShotStart &start) const {
  const Contact &contact = record_.contacts()[index];
  const Span after = record_.flights(index).after;
  if (after.size() >= shortest_flight) {
    w.measurement->rebound = slope_functional(w.times, after.first - start.sample, after.last - start.sample, -1);
    w.impact.rebound_speed = 0 - record_.state(after, times_[after.first]).v.dot(w.direction);
  } else { // by its impulse
    w.impact.rebound_speed = contact.impulse / run_.scene.load.mass - w.impact.approach_speed;
  }
}

/// As far as the samples of contact tell; its speeds and peak are filled in by the cutter.
Impact impact_of(const StoredRun &run, const MeasuredRecord &record, const Contact &c) {
  const Eigen::Vector2d u = planar(run.response, "displacement", c.first);
  Impact impact{};
  impact.touch_time = c.touch_time, impact.release_time = c.release_time;
  impact.direction_deg = std::atan2(u.y(), u.x()) * 180 / std::numbers::pi;
  std::vector<double> times, depth;
  for (std::size_t i = c.first; i <= c.last; ++i) {
    times.push_back(run.response.series("time")[i]);
    depth.push_back(planar(run.response, "displacement", i).norm() - run.scene.bearing.lateral_capacity());
    impact.peak_force = std::max(impact.peak_force, record.force().smooth[i]);
  }
  impact.peak_penetration = smooth_peak(times, depth);
  return impact;
}

} // namespace

void cut_measured(StoredRun &run, const WindowOptions &options) {
  if (!run.scene.excitation.is_dynamic()) {
    differentiate_path(run.response);
    summarise_response(run.response, run.summary);
    run.notes.push_back("a quasi-static path holds no impact");
    return;
  }
  const MeasuredRecord record(run, options);
  keep_contacts_only(run.response, record.force());
  complete_velocities(run, record);
  summarise_response(run.response, run.summary);
  run.summary.impacts.clear();
  for (const auto &c : record.contacts()) run.summary.impacts.push_back(impact_of(run, record, c));
  if (record.contacts().empty()) return;
  run.summary.peak_impact_force = record.force().peak;
  MeasuredCutter cutter(run, record, options);
  std::vector<std::string> left_out;
  for (std::size_t i = 0; i < record.contacts().size(); ++i) {
    std::string reason;
    if (auto window = cutter.cut(i, reason))
      run.impacts.push_back(std::move(*window));
    else
      left_out.push_back(fmt::format("impact at {:.4f} s left out: {}", record.contacts()[i].touch_time, reason));
  }
  run.notes.insert(run.notes.begin(), left_out.begin(), left_out.end());
  run.noise.insert(run.noise.end(), record.force().notes.begin(), record.force().notes.end());
  run.noise.push_back(record.sentence());
  run.notes.insert(run.notes.end(), run.noise.begin(), run.noise.end());
}

} // namespace rimpact::calibration
