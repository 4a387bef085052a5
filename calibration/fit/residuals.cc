#include "calibration/fit/residuals.h"
#include "calibration/data/series.h"
#include "calibration/fit/measured_residuals.h"
#include "calibration/fit/shooting.h"
#include "reduced_models/simulate.h"
#include <cmath>

namespace rimpact::calibration {

double ResidualBlock::add_group(Compared kind, int count, double weight, double sigma) {
  if (weight == 0 || count == 0) return 0;
  groups_.push_back({kind, size(), count, weight});
  return weight / (sigma * std::sqrt(static_cast<double>(count)));
}

namespace {

/// Share of its peak the reference's force must reach to be compared.
constexpr double pressed_share = 0.05;

class ImpactBlock final : public ResidualBlock {
public:
  ImpactBlock(const StoredRun &run, const ImpactWindow &window, const FitOptions &options)
      : ResidualBlock(with_settings(run.scene, options.law, options.fixed)), window_(window) {
    for (std::size_t i = 0; i < window.force.size(); ++i)
      if (window.force[i] >= pressed_share * window.peak) pressed_.push_back(i);
    const Uncertainty u = run.uncertainty.value_or(options.uncertainty);
    const auto &w = options.weights;
    const double force = u.force * run.peak_force(), speed = u.speed * run.approach_speed();
    force_ = add_group(Compared::force, static_cast<int>(pressed_.size()), w.force, force);
    displacement_ = add_group(Compared::displacement, static_cast<int>(window.times.size()), w.displacement,
                              u.displacement * run.scene.bearing.lateral_capacity());
    rebound_ = add_group(Compared::rebound, 1, w.rebound, speed);
    peak_ = add_group(Compared::peak, 1, w.peak, force);
    phase_ = u.time > 0 ? add_group(Compared::phase, 1, 1, u.time) : 0;
  }

  void evaluate(const scene::Scene &scene, const Beside &, std::span<double> r) const override {
    Shot shot = shoot(scene, window_);
    std::size_t n = compare_curves(shot, r);
    const double shifted = phase_ > 0 ? shift(shot, r) : 0;
    if (rebound_ > 0) r[n++] = rebound_ * (shot.rebound_speed - window_.impact.rebound_speed);
    if (peak_ > 0) r[n++] = peak_ * (shot.peak - window_.peak);
    if (phase_ > 0) r[n] = shifted;
  }

private:
  /// Fills the groups force and displacement; returns their size.
  std::size_t compare_curves(const Shot &shot, std::span<double> r) const {
    std::size_t n = 0;
    if (force_ > 0)
      for (const std::size_t i : pressed_) r[n++] = force_ * (shot.force[i] - window_.force[i]);
    if (displacement_ > 0)
      for (std::size_t i = 0; i < window_.times.size(); ++i)
        r[n++] = displacement_ * (shot.displacement[i] - window_.displacement[i]);
    return n;
  }

  /// Moves the model's force and displacement by the time that makes all residuals smallest (Gauss-Newton);
  /// returns the time over its uncertainty.
  double shift(Shot &shot, std::span<double> r) const {
    constexpr int iterations = 4; // the curves are smooth over such a time
    const Shot own = shot;
    double delay = 0;
    for (int n = 0; n < iterations; ++n) {
      const auto force = differentiate(window_.times, shot.force),
                 speed = differentiate(window_.times, shot.displacement);
      double along = delay * phase_ * phase_, square = phase_ * phase_;
      std::size_t i = 0;
      const auto add = [&](double slope) { along += slope * r[i++], square += slope * slope; };
      if (force_ > 0)
        for (const std::size_t j : pressed_) add(-force_ * force[j]);
      if (displacement_ > 0)
        for (const double v : speed) add(-displacement_ * v);
      delay -= along / square;
      for (std::size_t j = 0; j < window_.times.size(); ++j) {
        const double t = window_.times[j] - delay;
        shot.force[j] = pulse_at(window_.times, own.force, t);
        shot.displacement[j] = own.displacement.front() + std::min(0.0, t - window_.times[0]) * speed[0];
        if (t > window_.times[0]) shot.displacement[j] = linear_at(window_.times, own.displacement, t);
      }
      compare_curves(shot, r);
    }
    return phase_ * delay;
  }

  const ImpactWindow &window_;
  std::vector<std::size_t> pressed_;
  double force_, displacement_, rebound_, peak_, phase_;
};

class FlightBlock final : public ResidualBlock {
public:
  FlightBlock(const StoredRun &run, const FitOptions &options)
      : ResidualBlock(with_settings(run.scene, options.law, options.fixed)), response_(run.response) {
    const auto &times = response_.series("time");
    const double end = run.summary.impacts.empty() ? times.back() : run.summary.impacts.front().touch_time;
    while (n_ < times.size() && times[n_] < end) ++n_;
    const bool moved = run.scene.excitation.is_dynamic();
    compared_ = moved ? Compared::displacement : Compared::force;
    const Uncertainty u = run.uncertainty.value_or(options.uncertainty);
    const double sigma =
        moved ? u.displacement * run.scene.bearing.lateral_capacity() : u.force * run.summary.peak_lateral_force;
    scale_ = add_group(Compared::flight, static_cast<int>(2 * n_), options.weights.flight, sigma);
  }

  void evaluate(const scene::Scene &scene, const Beside &, std::span<double> r) const override {
    const auto run = reduced::simulate(scene);
    const auto &times = run.response.series("time");
    std::size_t n = 0;
    const bool travel = compared_ == Compared::displacement;
    for (const char *axis : {"_x", "_y"}) {
      const std::string signal = (travel ? "displacement" : "force") + std::string(axis);
      const auto &ours = run.response.series(signal), &theirs = response_.series(signal);
      for (std::size_t i = 0; i < n_; ++i) {
        const double t = response_.series("time")[i];
        const double value = travel ? hermite_at(times, ours, run.response.series(std::string("velocity") + axis), t)
                                    : linear_at(times, ours, t);
        r[n++] = scale_ * (value - theirs[i]);
      }
    }
  }

private:
  const Response &response_;
  Compared compared_ = Compared::displacement;
  std::size_t n_ = 0;
  double scale_;
};

class GainBlock final : public ResidualBlock {
public:
  explicit GainBlock(const scene::Scene &scene) : ResidualBlock(scene) { add_group(Compared::gain, 1, 1, 1); }
  void evaluate(const scene::Scene &, const Beside &beside, std::span<double> r) const override { r[0] = beside.gain; }
  Eigen::VectorXd gain_slope(double, const Eigen::VectorXd &) const override { return Eigen::VectorXd::Ones(1); }
};

} // namespace

std::unique_ptr<ResidualBlock> impact_block(const StoredRun &run, const ImpactWindow &window,
                                            const FitOptions &options) {
  if (window.measurement) return measured_block(run, window, options);
  return std::make_unique<ImpactBlock>(run, window, options);
}

std::unique_ptr<ResidualBlock> gain_block(const scene::Scene &scene) {
  return std::make_unique<GainBlock>(scene);
}

std::unique_ptr<ResidualBlock> flight_block(const StoredRun &run, const FitOptions &options) {
  return std::make_unique<FlightBlock>(run, options);
}

} // namespace rimpact::calibration
