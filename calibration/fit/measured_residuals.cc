// Residuals of a measured impact: its start is known to the errors of the flight before it, its samples to their noise.
// The equations are in docs/theory/measured-curves.md.
#include "calibration/fit/measured_residuals.h"

#include "calibration/data/functionals.h"
#include "calibration/data/series.h"
#include "calibration/fit/shooting.h"
#include "reduced_models/bearings/pad_on_dish.h"
#include <cmath>

namespace rimpact::calibration {

namespace {

class MeasuredBlock final : public ResidualBlock {
public:
  MeasuredBlock(const StoredRun &run, const ImpactWindow &window, const FitOptions &options)
      : ResidualBlock(with_settings(run.scene, options.law, options.fixed)), record_(run), window_(window),
        m_(*window.measurement) {
    const Uncertainty u = run.uncertainty.value_or(options.uncertainty);
    time_error_ = std::hypot(u.time, run.clock_error), gain_ = u.gain;
    const reduced::PhysicalModel model(run.scene);
    slope_ = model.height(window.start.u.x(), window.start.u.y()).gradient;
    n_pressed_ = static_cast<int>(m_.pressed_last - m_.pressed_first) + 1;
    n_travelled_ = static_cast<int>(window.times.size() - m_.flown);
    if (options.counting == SampleWeighting::sample)
      count_samples();
    else
      count_curves(run, u, options.weights);
    add_group(Compared::start, n_nuisance(), std::sqrt(n_nuisance()), 1);
    last_group().noise = 1;
  }

  int n_nuisance() const override { return time_error_ > 0 ? 3 : 2; }
  bool measured() const override { return m_.noisy(); }

  void evaluate(const scene::Scene &scene, const Beside &beside, std::span<double> r) const override {
    const std::span<const double> nuisance = beside.nuisance;
    Shot shot = shoot(scene, window_, moved(nuisance));
    for (double &force : shot.force) force *= 1 + gain_ * beside.gain; // as the channel shows it
    if (time_error_ > 0) delay(shot, nuisance[2] * time_error_);
    std::size_t n = 0;
    if (force_ > 0)
      for (std::size_t i = m_.pressed_first; i <= m_.pressed_last; ++i)
        r[n++] = force_ * (shot.force[i] - window_.force[i]);
    if (displacement_ > 0)
      for (std::size_t i = m_.flown; i < window_.times.size(); ++i)
        r[n++] = displacement_ * (shot.displacement[i] - window_.displacement[i]);
    if (rebound_ > 0) r[n++] = rebound_ * (m_.rebound.of(shot.displacement) - m_.rebound.of(window_.displacement));
    if (peak_ > 0) r[n++] = peak_ * (m_.peak.of(shot.force) - m_.peak.of(window_.force));
    for (const double known : nuisance) r[n++] = known;
  }

  /// Peak and rebound are sums of the samples that force and displacement compare: what a sample errs moves both.
  Eigen::MatrixXd noise_times(const Eigen::MatrixXd &X, Channel channel) const override {
    const Rows rows = places();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(X.rows(), X.cols());
    if (channel == Channel::force) {
      add_samples(X, result, rows.force, m_.pressed_first, n_pressed_, force_, rows.peak, m_.peak, peak_);
      return m_.noise_force() * m_.noise_force() * result;
    }
    add_samples(X, result, rows.displacement, m_.flown, n_travelled_, displacement_, rows.rebound, m_.rebound,
                rebound_);
    result *= m_.noise_displacement() * m_.noise_displacement();
    result.bottomRows(n_nuisance()) = X.bottomRows(n_nuisance());
    return result;
  }
  double freedom(Channel channel) const override {
    return channel == Channel::force ? m_.freedom_force : m_.freedom_displacement;
  }
  const void *record() const override { return &record_; }

  double gain_error() const override { return gain_; }
  /// The model's forces are the record's and what is left: by linearity no other flight is needed.
  Eigen::VectorXd gain_slope(double gain, const Eigen::VectorXd &residuals) const override {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(size());
    const Rows rows = places();
    const double share = gain_ / (1 + gain_ * gain);
    if (rows.force >= 0)
      for (Eigen::Index i = 0; i < n_pressed_; ++i)
        slope(rows.force + i) = share * (residuals(rows.force + i) + force_ * window_.force[m_.pressed_first + i]);
    if (rows.peak >= 0) slope(rows.peak) = share * (residuals(rows.peak) + peak_ * m_.peak.of(window_.force));
    return slope;
  }

private:
  /// A curve is one observation: stated uncertainty and noise together.
  void count_curves(const StoredRun &run, const Uncertainty &u, const Weights &w) {
    const double force = u.force * run.peak_force(), speed = u.speed * run.approach_speed();
    const double travel_noise = m_.noise_displacement(), force_noise = m_.noise_force();
    force_ = group(Compared::force, n_pressed_, w.force, force, force_noise, m_.freedom_force);
    displacement_ = group(Compared::displacement, n_travelled_, w.displacement,
                          u.displacement * run.scene.bearing.lateral_capacity(), travel_noise, m_.freedom_displacement);
    if (!m_.rebound.weights.empty())
      rebound_ = group(Compared::rebound, 1, w.rebound, speed, travel_noise * std::sqrt(variance_gain(m_.rebound)),
                       m_.freedom_displacement);
    if (!m_.peak.weights.empty())
      peak_ =
          group(Compared::peak, 1, w.peak, force, force_noise * std::sqrt(variance_gain(m_.peak)), m_.freedom_force);
  }
  /// Every sample is an observation; what peak and rebound say is in them.
  void count_samples() {
    force_ = group(Compared::force, n_pressed_, std::sqrt(n_pressed_), 0, m_.noise_force(), m_.freedom_force);
    displacement_ = group(Compared::displacement, n_travelled_, std::sqrt(n_travelled_), 0, m_.noise_displacement(),
                          m_.freedom_displacement);
  }
  double group(Compared kind, int count, double weight, double stated, double noise, double freedom) {
    const double scale = add_group(kind, count, weight, std::hypot(stated, noise));
    if (scale > 0) last_group().noise = std::pow(scale * noise, 2), last_group().freedom = freedom;
    return scale;
  }

  /// First row of each group; -1: left out.
  struct Rows {
    Eigen::Index force = -1, displacement = -1, rebound = -1, peak = -1;
  };
  Rows places() const {
    Rows rows;
    for (const auto &g : groups()) {
      if (g.kind == Compared::force) rows.force = g.first;
      if (g.kind == Compared::displacement) rows.displacement = g.first;
      if (g.kind == Compared::rebound) rows.rebound = g.first;
      if (g.kind == Compared::peak) rows.peak = g.first;
    }
    return rows;
  }
  /// result += S S^T X, S the factors of a channel's samples in the residuals: `count` of a curve from sample `first`
  /// on, at row `curve`, and those of the functional at row `read`.
  void add_samples(const Eigen::MatrixXd &X, Eigen::MatrixXd &result, Eigen::Index curve, std::size_t first, int count,
                   double curve_factor, Eigen::Index read, const Functional &f, double read_factor) const {
    Eigen::MatrixXd samples = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(window_.times.size()), X.cols());
    const auto weights =
        Eigen::Map<const Eigen::VectorXd>(f.weights.data(), static_cast<Eigen::Index>(f.weights.size()));
    const auto n = weights.size(), from = static_cast<Eigen::Index>(f.first), begin = static_cast<Eigen::Index>(first);
    if (curve >= 0) samples.middleRows(begin, count) = curve_factor * X.middleRows(curve, count);
    if (read >= 0) samples.middleRows(from, n) += read_factor * weights * X.row(read);
    if (curve >= 0) result.middleRows(curve, count) += curve_factor * samples.middleRows(begin, count);
    if (read >= 0) result.row(read) += read_factor * weights.transpose() * samples.middleRows(from, n);
  }

  reduced::BearingState moved(std::span<const double> nuisance) const {
    const Eigen::Vector2d off = m_.start_factor * Eigen::Vector2d(nuisance[0], nuisance[1]);
    reduced::BearingState start = window_.start;
    start.u.head<2>() += off[0] * window_.direction, start.v.head<2>() += off[1] * window_.direction;
    start.u.z() += off[0] * slope_.dot(window_.direction), start.v.z() += off[1] * slope_.dot(window_.direction);
    return start;
  }

  /// The model's force, later by `by` [s] than its motion. When the slider touches, the start's own errors tell.
  void delay(Shot &shot, double by) const {
    const std::vector<double> own = shot.force;
    for (std::size_t j = 0; j < window_.times.size(); ++j)
      shot.force[j] = pulse_at(window_.times, own, window_.times[j] - by);
  }

  const StoredRun &record_;
  const ImpactWindow &window_;
  const Measurement &m_;
  Eigen::Vector2d slope_;
  int n_pressed_ = 0, n_travelled_ = 0;
  double force_ = 0, displacement_ = 0, rebound_ = 0, peak_ = 0, time_error_ = 0, gain_ = 0;
};

} // namespace

std::unique_ptr<ResidualBlock> measured_block(const StoredRun &run, const ImpactWindow &window,
                                              const FitOptions &options) {
  return std::make_unique<MeasuredBlock>(run, window, options);
}

} // namespace rimpact::calibration
