#include "reduced_models/rigid_body/bearing_run.h"
#include "io/files/error.h"
#include "reduced_models/rigid_body/bearing_recorder.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace rimpact::reduced {

namespace {

using namespace rigid;

/// One scene: the bodies, what moves them, and the steps.
class Run {
public:
  Run(const scene::Scene &scene, ReducedRun &result)
      : scene_(scene), model_(scene), ground_(scene.excitation, scene.load.gravity),
        duration_(model_.driven ? drive_time() : scene.excitation.duration), loads_(loads()),
        stepper_(model_.system, loads_), recorder_(model_, scene, model_.driven ? duration_ : 1, result) {
    const double g = scene.load.gravity, C = scene.lateral_capacity();
    // A step's local error, relative to a hundredth of the capacity and of its speed.
    position_tolerance_ = scene.isolator.step_tolerance * 0.01 * C;
    velocity_tolerance_ = scene.isolator.step_tolerance * 0.01 * std::sqrt(g * C);
    largest_step_ = model_.driven ? duration_ / (4000 * scene.excitation.whole_rounds()) : 1e-2;
    if (const auto &instants = ground_.breakpoints(); !instants.empty()) quiet_from_ = instants.back();
  }

  void go() {
    const bool free = scene_.excitation.kind == scene::ExcitationKind::free;
    MotionState state =
        free ? model_.state_at(scene_.excitation.start_displacement(), scene_.excitation.start_velocity())
             : model_.state_at({0, 0}, {0, 0});
    stepper_.start(state);
    recorder_.begin(state);
    double h = 1e-2 * largest_step_;
    while (state.t < duration_ * (1 - 1e-12)) {
      try {
        advance(state, h);
      } catch (const SolverStopped &stop) {
        return recorder_.stop(state, stop.what());
      }
      if (const char *why = model_.lost(state))
        return recorder_.stop(state, why + (" at t = " + std::to_string(state.t)) + " s");
      if (recorder_.collapsed()) return recorder_.end(state);
    }
    recorder_.end(state);
  }

private:
  double drive_time() const {
    double length = 0;
    Eigen::Vector2d last = path(0);
    const double n = 1000 * scene_.excitation.whole_rounds();
    for (int i = 1; i <= n; ++i) {
      const Eigen::Vector2d next = path(i / n);
      length += (next - last).norm(), last = next;
    }
    return length / drive_speed;
  }
  Eigen::Vector2d path(double s) const {
    return scene::prescribed_displacement(scene_.excitation, scene_.lateral_capacity(), s);
  }
  Loads loads() const {
    Loads l;
    if (model_.driven) {
      l.ground_acceleration = [](double) { return Eigen::Vector3d(0, 0, 0); };
      l.path = [this](double t) { return path(std::clamp(t / duration_, 0.0, 1.0)); };
      l.driven = model_.plate, l.duration = duration_;
    } else {
      l.ground_acceleration = [this](double t) { return ground_.acceleration(t); };
    }
    return l;
  }
  double error(const StepReport &report) const {
    double largest = 0;
    for (int body = 0; body < static_cast<int>(model_.system.bodies.size()); ++body) {
      largest = std::max(largest, report.position_error.segment<3>(6 * body).norm() / position_tolerance_);
      if (body >= model_.plate)
        largest = std::max(largest, report.velocity_error.segment<3>(6 * body).norm() / velocity_tolerance_);
    }
    return largest;
  }
  /// An accepted step; h becomes the next one's length. It does not grow just after a cut, and two even steps lead to a
  /// sample rather than a long and a short one.
  void advance(MotionState &state, double &h) {
    for (double growth = 2;; growth = 1) {
      h = std::min(h, state.t < quiet_from_ ? largest_step_ : 2 * largest_step_);
      const double limit = std::min(recorder_.next_sample(state), duration_);
      const bool clipped = state.t + h * 1.001 >= limit;
      const double left = limit - state.t, step = clipped ? left : 2 * h > left ? left / 2 : h;
      if (!(step > 1e-9 * largest_step_))
        throw SolverStopped("the time step of reduced.model \"" + word(scene_.reduced.model) +
                            "\" became too small at t = " + std::to_string(state.t) + " s");
      const StepReport report = stepper_.step(state, step, next_);
      recorder_.count(report);
      if (!report.converged) {
        h = step / 4;
        continue;
      }
      const double e = error(report), factor = std::clamp(0.9 / std::cbrt(std::max(e, 1e-9)), 0.2, growth);
      if (e > 1 && step > 1e-6 * largest_step_) {
        h = step * std::min(factor, 0.5);
        continue;
      }
      h = clipped ? std::max(h, step * factor) : step * factor;
      std::swap(state, next_);
      if (clipped) state.t = limit;
      return recorder_.accept(state, next_);
    }
  }

  const scene::Scene &scene_;
  RigidBearing model_;
  scene::GroundMotion ground_;
  double duration_;
  Loads loads_;
  Stepper stepper_;
  BearingRecorder recorder_;
  double position_tolerance_, velocity_tolerance_, largest_step_;
  double quiet_from_ = std::numeric_limits<double>::infinity(); ///< of a record: its end [s]
  MotionState next_;
};

} // namespace

ReducedRun simulate_rigid_bodies(const scene::Scene &scene) {
  const auto begin = std::chrono::steady_clock::now();
  ReducedRun result;
  Run(scene, result).go();
  result.summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.summary.time_split["solve"] = result.summary.wall_time;
  return result;
}

} // namespace rimpact::reduced
