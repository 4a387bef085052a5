#include "fe_contact/drive/start_on_dish.h"

#include "fe_contact/drive/cached_preload.h"
#include "fe_contact/drive/forces.h"
#include "fe_contact/solver/march.h"
#include "io/files/error.h"
#include "reduced_models/bearings/physical_model.h"
#include <cmath>

namespace rimpact::fe {
namespace {

constexpr double first_gap = 5e-5; ///< a window starts here [m]

/// Of the mass as it comes to the rim at a window's speed, by the reduced model [m/s^2].
Eigen::Vector3d arriving_acceleration(const scene::Scene &scene) {
  const reduced::PhysicalModel model(scene);
  reduced::BearingState state;
  const Eigen::Vector2d direction = scene.excitation.direction();
  const scene::SurfacePoint surface =
      model.height(scene.bearing.lateral_capacity() * direction.x(), scene.bearing.lateral_capacity() * direction.y());
  state.u << scene.bearing.lateral_capacity() * direction, surface.z;
  state.v << scene.excitation.impact_speed() * direction, 0;
  state.v.z() = surface.gradient.dot(state.v.head<2>());
  const reduced::BearingForces forces = model.forces(state);
  return (forces.pendular + forces.friction) / scene.load.mass -
         scene.load.vertical / scene.load.mass * Eigen::Vector3d::UnitZ();
}

} // namespace

double StartOnDish::end() const {
  return scene_.bearing.lateral_capacity() - first_gap;
}

StartOnDish::Start StartOnDish::at_rest() const {
  SystemState state = system_.at_rest();
  preload_on_dish(system_, state, system_.dead_load(scene_.load.vertical), steps_);
  const double height = system_.top_of(state.u).z();
  return {std::move(state), height};
}

void StartOnDish::slide(SystemState &state, TopDrive &drive, double from, double to, double first, double longest,
                        const Eigen::VectorXd &load) const {
  const Eigen::Vector2d direction = scene_.excitation.direction();
  const auto go = [&](double at, double step) {
    if (is_interrupted(options_)) throw Interrupted();
    const auto report = drive.move_to(system_, state, {(at + step) / ratio() * direction, {}}, load, steps_);
    if (const auto stop = stop_of_halves(system_, state, "the way out to the rim")) throw SolverStopped(*stop);
    if (options_.progress)
      options_.progress(
          {0, scene_.excitation.duration, step, report.iterations, end() - at - step, 0, Phase::sliding_out});
    return Attempt{report.converged, 0, report.reason};
  };
  const MarchReport report = march(from, to, {first, 1e-5 * longest, longest, 2.0}, go);
  if (!report.finished) throw SolverStopped("the slide out to the rim stopped: " + report.reason);
}

StartOnDish::Start StartOnDish::nearly_there(TopDrive &drive, double to) const {
  constexpr double longest = 0.025; // step [m]
  const CachedPreload kept(scene_, plan_, options_);
  Start start{system_.at_rest(), 0};
  if (!kept.take(start.first, drive, start.second)) {
    start = at_rest();
    slide(start.first, drive, 0, to, 1e-3 * longest, longest, system_.dead_load(scene_.load.vertical));
    kept.keep(start.first, drive, start.second);
  }
  system_.start_afresh_at(start.first); // as the run that takes it will
  return start;
}

StartOnDish::Start StartOnDish::near_the_rim() const {
  constexpr double last = 1e-3; // the stretch on which the dish takes the load of the arriving mass [m]
  const Eigen::Vector2d direction = scene_.excitation.direction();
  TopDrive drive;
  Start start = nearly_there(drive, end() - last);
  // As if it came sliding at its speed: the dish carries the weight less what the path's curve takes off.
  const Eigen::VectorXd load =
      system_.dead_load(scene_.load.vertical + scene_.load.mass * arriving_acceleration(scene_).z());
  slide(start.first, drive, end() - last, end(), 0.1 * last, 0.3 * last, load);
  // What the dish takes on the last stretch is added, so that the walls meet at the speed asked for. Under rung full
  // the plate dips, and its rim leans away by some micrometres: a graze would stop short of it.
  const BearingForces forces = forces_of(system_, start.first);
  const double slowing = -(forces.pendular + forces.friction).head<2>().dot(direction) / scene_.load.mass;
  const double way = ratio() * system_.top_of(start.first.u).head<2>().norm(),
               until_touch = system_.wall_distance(start.first, scene_.bearing.lateral_capacity() - way);
  const double speed = std::sqrt(std::pow(scene_.excitation.impact_speed(), 2) + 2 * slowing * until_touch);
  start.first.v = drive.last_change * (speed / ratio() / drive.last_way.norm());
  return start;
}

} // namespace rimpact::fe
