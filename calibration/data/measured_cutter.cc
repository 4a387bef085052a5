#include "calibration/data/measured_cutter.h"
#include "calibration/data/functionals.h"
#include "calibration/data/measured_record.h"
#include "calibration/data/series.h"
#include "calibration/data/window_cutter.h"
#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace rimpact::calibration {

namespace {

constexpr double pressed_share = 0.05;  ///< of its peak the force must reach to be compared
constexpr double dent_tolerance = 1e-5; ///< travel beyond L_c without force that means a dent [m], beside its own error
constexpr double noise_reach = 5;       ///< standard errors

class MeasuredCutter {
public:
  MeasuredCutter(StoredRun &run, const MeasuredRecord &record, const WindowOptions &options)
      : run_(run), record_(record), r_(run.response), times_(run.response.series("time")), options_(options),
        model_(run.scene), L_c_(run.scene.bearing.lateral_capacity()) {}

  std::optional<ImpactWindow> cut(std::size_t index, std::string &reason);

private:
  struct Start {
    std::size_t sample = 0, flown = 0; ///< where the shot begins; first sample behind those it is fitted to
    Eigen::Vector2d u, v;
    Eigen::Matrix2d covariance; ///< radial (u, v)
  };
  std::optional<Start> start_of(std::size_t index, ImpactWindow &w, std::string &reason) const;
  std::optional<Start> stated_start(const Contact &contact, std::string &reason) const;
  void find_capacity(const Contact &contact, const FlightFit &fit, double t_ref, ImpactWindow &w) const;
  void collect(ImpactWindow &w, const Start &start, double end) const;
  void find_pressed(ImpactWindow &w, const Contact &contact, const Start &start) const;
  void find_rebound(ImpactWindow &w, std::size_t index, const Start &start) const;
  void doubt_impulse(const ImpactWindow &w, const Contact &contact);

  StoredRun &run_;
  const MeasuredRecord &record_;
  const Response &r_;
  const std::vector<double> &times_;
  const WindowOptions &options_;
  reduced::PhysicalModel model_;
  double L_c_;
};

/// Where the reduced rim begins: at L_c, or where a dented rim was touched, if that is surely beyond it.
void MeasuredCutter::find_capacity(const Contact &contact, const FlightFit &fit, double t_ref, ImpactWindow &w) const {
  const Eigen::Vector2d touch = fit.u + (contact.touch_time - t_ref) * fit.v;
  const double late =
      std::abs(times_[contact.first] - contact.touch_time) + times_[contact.first] - times_[contact.first - 1];
  const double error = std::hypot(record_.sigma() * std::sqrt(fit.shape(0, 0)), fit.v.norm() * late);
  w.dented = touch.norm() > L_c_ + dent_tolerance + noise_reach * error;
  const bool own =
      options_.touch == TouchReference::own_touch || (options_.touch == TouchReference::automatic && w.dented);
  w.capacity = own ? touch.norm() : L_c_;
}

std::optional<MeasuredCutter::Start> MeasuredCutter::start_of(std::size_t index, ImpactWindow &w,
                                                              std::string &reason) const {
  const Contact &contact = record_.contacts()[index];
  const Span flight = record_.flights(index).before;
  w.capacity = L_c_;
  if (flight.size() < shortest_flight) return stated_start(contact, reason);
  const double end = times_[flight.last];
  auto fit = record_.state(flight, end);
  find_capacity(contact, fit, end, w);
  const double error = record_.sigma() * std::sqrt(record_.inflation() * fit.shape(0, 0)),
               speed = fit.u.normalized().dot(fit.v);
  const auto travel = [&](std::size_t i) { return fit.u.norm() + speed * (times_[i] - end) + 4 * error; };
  std::size_t sample = flight.last;
  while (sample > flight.first && travel(sample) > w.capacity - options_.lead) --sample;
  if (travel(sample) > w.capacity + 8 * error) {
    reason = fmt::format("{:.3g} mm beyond the rim's place before it bears force; is the displacement's zero right? "
                         "(--fit ...,capacity_offset "
                         "looks for the rim)",
                         1e3 * (travel(sample) - w.capacity));
    return {};
  }
  fit = record_.state(flight, times_[sample]);
  return Start{sample, flight.last + 1, fit.u, fit.v,
               record_.sigma() * record_.sigma() * record_.inflation() * fit.shape};
}

/// Of a window record that begins at touch: the scene states the speed.
std::optional<MeasuredCutter::Start> MeasuredCutter::stated_start(const Contact &contact, std::string &reason) const {
  const Eigen::Vector2d u = planar(r_, "displacement", 0);
  const double beyond = u.norm() - L_c_, sigma = record_.sigma();
  const double speed = run_.scene.excitation.impact_speed(),
               a_sample = speed * (times_[1] - times_[0]); // touched since the sample before
  if (run_.is_window() && contact.first <= 2 && beyond < a_sample + noise_reach * sigma) {
    const Eigen::Vector2d variance(sigma * sigma + a_sample * a_sample / 3,
                                   std::pow(options_.stated_speed_error * speed, 2));
    return Start{0, 1, std::min(u.norm(), L_c_) * u.normalized(), speed * u.normalized(), variance.asDiagonal()};
  }
  reason = fmt::format("the record holds {:.2g} ms before this touch ({} samples are free of the rim's force there, {} "
                       "are needed; 10 ms "
                       "or more tell the speed well): let it begin earlier, or sample it faster",
                       1e3 * std::max(0.0, contact.touch_time - times_.front()),
                       record_.flights(&contact - record_.contacts().data()).before.size(), shortest_flight);
  return {};
}

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
  const auto start = start_of(index, w, reason);
  if (!start) return {};
  w.direction = start->u.normalized();
  w.start.t = times_[start->sample];
  w.start.u.head<2>() = start->u, w.start.v.head<2>() = start->v;
  const auto ground = model_.height(start->u.x(), start->u.y());
  w.start.u.z() = ground.z, w.start.v.z() = ground.gradient.dot(start->v);
  if (start->v.norm() > 0) w.start.eta = start->v.normalized();
  press_earlier(w.start, run_, index);
  auto &m = *w.measurement;
  m.sigma_displacement = record_.sigma(), m.inflation = record_.inflation(), m.sigma_force = record_.force().sigma;
  m.freedom_displacement = std::max(1.0, record_.freedom()),
  m.freedom_force = std::max(1.0, record_.force().n_quiet - 1.0);
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
  doubt_impulse(w, contact);
  run_.summary.impacts[index] = w.impact;
  return w;
}

void MeasuredCutter::collect(ImpactWindow &w, const Start &start, double end) const {
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
void MeasuredCutter::find_pressed(ImpactWindow &w, const Contact &contact, const Start &start) const {
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

void MeasuredCutter::find_rebound(ImpactWindow &w, std::size_t index, const Start &start) const {
  const Contact &contact = record_.contacts()[index];
  const Span after = record_.flights(index).after;
  if (after.size() >= shortest_flight) {
    w.measurement->rebound = slope_functional(w.times, after.first - start.sample, after.last - start.sample, -1);
    w.impact.rebound_speed = 0 - record_.state(after, times_[after.first]).v.dot(w.direction);
  } else { // by its impulse
    w.impact.rebound_speed = contact.impulse / run_.scene.load.mass - w.impact.approach_speed;
  }
}

/// Impulse against the change of momentum of an isolated impact: says what no noise shows, a gain or a mass that is
/// wrong.
void MeasuredCutter::doubt_impulse(const ImpactWindow &w, const Contact &contact) {
  const auto &x = run_.scene.excitation;
  if (!run_.is_window() || x.with_weight || x.with_friction || x.with_ground || w.measurement->rebound.weights.empty())
    return;
  const auto &m = *w.measurement;
  const double change = run_.scene.load.mass * (w.impact.approach_speed + w.impact.rebound_speed),
               ratio = contact.impulse / change;
  const double speeds = std::sqrt(m.start_factor.row(1).squaredNorm() +
                                  std::pow(m.sigma_displacement, 2) * record_.inflation() * variance_gain(m.rebound));
  const double error = std::hypot(contact.impulse_error / change, ratio * run_.scene.load.mass * speeds / change);
  if (std::abs(ratio - 1) > 0.02 && std::abs(ratio - 1) > 4 * error)
    run_.doubts.push_back(fmt::format(
        "at {:.4f} s the force's impulse is {:.3f} +- {:.3f} times the change of momentum: the cell's gain or "
        "the mass ({:g} kg) is off, or something else than the rim slows it; [uncertainty] gain states it",
        contact.touch_time, ratio, error, run_.scene.load.mass));
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

/// The response holds the rim's force of contacts only, freed of the cell's zero: what a history is compared with.
void keep_contacts_only(Response &r, const ContactRecord &record) {
  std::vector<bool> pressed(r.size(), false);
  for (const auto &c : record.contacts) std::fill(pressed.begin() + c.first, pressed.begin() + c.last + 1, true);
  auto &x = r.series("impact_x"), &y = r.series("impact_y");
  for (std::size_t i = 0; i < r.size(); ++i) {
    x[i] = pressed[i] ? x[i] - record.zero_x : 0, y[i] = pressed[i] ? y[i] - record.zero_y : 0;
    if (pressed[i] && x[i] == 0 && y[i] == 0)
      x[i] = std::numeric_limits<double>::min(); // a sample that happens to read nothing is no release
  }
}

/// Velocities for comparisons of histories, where none are measured: slopes that reach across no touch or release, and
/// at these the speeds of the flights. Differences of neighbouring samples would be noise.
void complete_velocities(StoredRun &run, const MeasuredRecord &record) {
  Response &r = run.response;
  const auto &times = r.series("time");
  for (const char *axis : {"_x", "_y"}) {
    if (r.has(std::string("velocity") + axis)) continue;
    std::vector<double> rates(r.size(), 0.0);
    const auto &u = r.series(std::string("displacement") + axis);
    std::size_t next = 0;
    for (std::size_t i = 0; i < record.contacts().size(); ++i) {
      const Contact &c = record.contacts()[i];
      if (c.first > next) smooth_rates(times, u, next, c.first - 1, rates);
      smooth_rates(times, u, c.first, c.last, rates);
      const Span before = record.flights(i).before, after = record.flights(i).after;
      const auto component = [&](const Span &flight, std::size_t at) {
        return record.state(flight, times[at]).v[axis[1] == 'x' ? 0 : 1];
      };
      if (before.size() >= shortest_flight) rates[c.first] = component(before, before.last);
      if (after.size() >= shortest_flight) rates[c.last] = component(after, after.first);
      next = c.last + 1;
    }
    if (next < r.size()) smooth_rates(times, u, next, r.size() - 1, rates);
    r.series(std::string("velocity") + axis) = rates;
  }
}

} // namespace

void cut_measured(StoredRun &run, const WindowOptions &options) {
  if (!run.scene.excitation.is_dynamic()) {
    for (const char *axis : {"_x", "_y"})
      if (!run.response.has(std::string("velocity") + axis))
        run.response.series(std::string("velocity") + axis) =
            differentiate(run.response.series("time"), run.response.series(std::string("displacement") + axis));
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
  run.noise = record.force().notes;
  run.noise.push_back(record.sentence());
  run.notes.insert(run.notes.end(), run.noise.begin(), run.noise.end());
}

} // namespace rimpact::calibration
