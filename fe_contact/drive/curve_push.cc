#include "fe_contact/drive/curve_push.h"

#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/path_course.h"
#include "fe_contact/drive/run_record.h"
#include "fe_contact/planning/plan_parts.h"
#include "fe_contact/rungs/rim.h"
#include "fe_contact/solver/march.h"
#include "fe_contact/solver/ranks.h"
#include "io/files/error.h"
#include "responses/build_version.h"
#include "scene/rim_identity.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::fe {
namespace {

constexpr double share_in = 0.12; ///< longest step over the penetration: gentle impacts need it
constexpr int curve_steps_in = 40,
              curve_steps_out = 14; ///< to the deepest point; of an unloading, by falls of the force
constexpr double furthest = 20;     ///< times the rim's thickness: folded over

/// The slider's way: along the dish, or held at the height of first touch.
struct Way {
  const reduced::PhysicalModel &model;
  RimFrame frame;
  bool held;
  TopTarget at(double d) const { return beyond_touch(frame, held ? nullptr : &model, d); }
};

class CurvePush {
public:
  CurvePush(const scene::Scene &scene, BearingSystem &system, const Way &way, const RunOptions &options)
      : system_(system), way_(way), options_(options), step_options_(step_options(system.model().rung, scene)),
        no_load_(Eigen::VectorXd::Zero(system.equations().n)), state_(system.at_rest()) {}

  /// Loads until `works` [J, rising] are done, unloading from the first step beyond each.
  laws::CurvePath run(const std::vector<double> &works, double depth, double thickness) {
    path_.loading = {{0}, {0}}, strain_ = {{0}, {0}}, foot_ = {};
    std::size_t next = 0;
    const auto attempt = [&](double d, double step) {
      Attempt result = push(drive_, state_, d + step);
      if (!result.accepted) return result;
      const double force = force_of(state_), work = work_ + (force + path_.loading.force.back()) / 2 * step;
      path_.loading.penetration.push_back(d + step), path_.loading.force.push_back(force);
      if (way_.held) note_strain(d + step), note_foot(d + step);
      work_ = work;
      result.suggested_step = std::min(push_growth * step, share_in * (d + step) + first_push_step);
      if (options_.progress)
        options_.progress({work, works.back(), step, 0, -(d + step), force, way_.held ? Phase::held : Phase::dish});
      if (work < works[next]) return result;
      while (next < works.size() && work >= works[next]) ++next;
      path_.unloading.push_back(unloading(d + step));
      result.last = next == works.size();
      return result;
    };
    const MarchReport report = march(
        0, furthest * thickness, {first_push_step, smallest_push_step, depth / curve_steps_in, push_growth}, attempt);
    if (next < works.size())
      throw SolverStopped(fmt::format("the curve stopped at {:.4f} mm beyond touch, with {:.4g} of {:.4g} J: {}; try a "
                                      "finer mesh or a lower --speed",
                                      1e3 * report.reached, work_, works.back(),
                                      report.finished ? "the rim is folded over" : report.reason));
    return std::move(path_);
  }

  /// Along the held path; empty along the dish.
  const reduced::CurveStrain &strain() const { return strain_; }
  const reduced::CurveFoot &foot() const { return foot_; }

private:
  void note_strain(double d) {
    const auto judged = judged_strain(steel_of(system_.model(), state_), {});
    if (judged) strain_.penetration.push_back(d), strain_.strain.push_back(judged->largest);
  }
  void note_foot(double d) {
    const auto use = system_.model().foot.of(system_.expand(state_), state_.history).use;
    if (!use) return;
    if (foot_.use.empty()) foot_ = {{0}, {0}};
    foot_.penetration.push_back(d), foot_.use.push_back(std::max(foot_.use.back(), *use));
  }
  Attempt push(TopDrive &drive, SystemState &state, double d) {
    if (is_interrupted(options_)) throw Interrupted();
    const ContactStepReport report = drive.move_to(system_, state, way_.at(d), no_load_, step_options_);
    return {report.converged, 0, report.reason};
  }
  double force_of(const SystemState &state) const { return -way_.frame.force(system_.force_of(state, Role::wall)).x(); }

  laws::CurveSamples unloading(double deepest) {
    SystemState state = state_;
    TopDrive drive = drive_;
    const double top = force_of(state), stiffness = stiffest();
    laws::CurveSamples back{{deepest}, {top}};
    const auto attempt = [&](double way, double step) {
      Attempt result = push(drive, state, deepest - way - step);
      if (!result.accepted) return result;
      const double d = deepest - way - step, force = force_of(state), slope = (back.force.back() - force) / step;
      result.last = !system_.walls_touch(state) || force <= 0;
      if (!result.last) result.suggested_step = top / curve_steps_out / std::max(slope, 1e-3 * stiffness);
      if (result.last) return end(back, d), result;
      back.penetration.push_back(d), back.force.push_back(force);
      return result;
    };
    const double first = top / stiffness / curve_steps_out;
    const MarchReport report = march(0, deepest, {first, smallest_push_step, 8 * first, push_growth}, attempt);
    if (!report.finished)
      throw SolverStopped(fmt::format("the unloading from {:.4f} mm stopped after {:.4f} mm: {}; try a finer mesh",
                                      1e3 * deepest, 1e3 * report.reached, report.reason));
    if (back.force.back() != 0) end(back, 0);
    return back;
  }

  /// Of the steps of the loading so far [N/m]: an edge is soft at first, and what springs back is stiffer.
  double stiffest() const {
    const auto &[depth, force] = path_.loading;
    double largest = 0;
    for (std::size_t i = 1; i < depth.size(); ++i)
      largest = std::max(largest, (force[i] - force[i - 1]) / (depth[i] - depth[i - 1]));
    return largest;
  }

  /// The walls part between the last sample and `parted`: where the force goes on to as it came.
  static void end(laws::CurveSamples &back, double parted) {
    const std::size_t n = back.force.size();
    double open = parted;
    if (n > 1) {
      const double slope =
          (back.force[n - 2] - back.force[n - 1]) / (back.penetration[n - 2] - back.penetration[n - 1]);
      open = std::max(parted, back.penetration[n - 1] - back.force[n - 1] / slope);
    }
    back.penetration.push_back(std::max(0.0, open)), back.force.push_back(0);
  }

  BearingSystem &system_;
  const Way way_;
  const RunOptions &options_;
  const StepOptions step_options_;
  const Eigen::VectorXd no_load_;
  SystemState state_;
  TopDrive drive_;
  laws::CurvePath path_;
  reduced::CurveStrain strain_;
  reduced::CurveFoot foot_;
  double work_ = 0;
};

/// Works at which to unload [J]: of the mass at speeds that lie closer where they are low, there the rebound falls
/// fastest.
std::vector<double> works_of(const CurveOrder &order) {
  std::vector<double> works;
  for (int i = 1; i <= order.unloadings; ++i) {
    const double speed = order.speed * std::pow(double(i) / order.unloadings, 1.5);
    works.push_back(order.mass / 2 * speed * speed);
  }
  return works;
}

/// Largest difference of two loadings' forces at the same work, relative.
double difference(const laws::CurvePath &fine, const laws::CurvePath &coarse) {
  const laws::RimCurve a(fine), b(coarse);
  double largest = 0;
  for (double share = 0.1; share <= 1; share += 0.1) {
    const double work = share * share * a.work(a.range()), force = a.loading(a.depth_of(work)).force;
    largest = std::max(largest, std::abs(b.loading(b.depth_of(work)).force / force - 1));
  }
  return largest;
}

void require(const CurveOrder &order) {
  if (!(order.mass > 0)) throw InputError(fmt::format("--mass-kg {:g} must be > 0", order.mass));
  if (!(order.speed > 0)) throw InputError(fmt::format("--speed {:g} must be > 0", order.speed));
  if (order.unloadings < 3) throw InputError(fmt::format("--unloadings {} must be at least 3", order.unloadings));
}

} // namespace

reduced::RimCurveFile push_rim_curve(const scene::Scene &scene, const CurveOrder &order, const RunOptions &options) {
  require(order);
  const OnOneRank alone;
  const reduced::PhysicalModel physical(scene);
  const double capacity = scene.bearing.lateral_capacity(),
               thickness = scene.bearing.dishes() * scene.bearing.rim.thickness;
  const auto works = works_of(order);
  scene::Scene struck = scene;
  struck.load.mass = order.mass;
  const double depth = planning::depth_of_impact(struck, order.speed);
  reduced::RimCurveFile result;
  const auto pushed = [&](int level, bool held, const std::vector<double> &to) {
    scene::Scene at = scene;
    at.model.mesh = level;
    const BearingModel model(rungs::rim, at.bearing, mesh_order(at, planning::Plan{}), model_options(at));
    BearingSystem system(model, 0);
    if (level == scene.model.mesh) result.mesh = fmt::format("level {}, {} unknowns", level, system.equations().n);
    const RimFrame frame = RimFrame::of(at.bearing, 0, physical.height(capacity, 0).z, held);
    CurvePush push(at, system, {physical, frame, held}, options);
    auto path = push.run(to, depth, thickness);
    if (held) result.strain = push.strain(), result.foot = push.foot();
    return path;
  };
  if (!order.held_only) result.dish = pushed(scene.model.mesh, false, works);
  result.held = pushed(scene.model.mesh, true, works);
  result.joint = strength_in_words(scene.bearing.rim.connection);
  result.bearing = scene.bearing.name;
  result.rim_identity = scene::rim_identity(scene.bearing);
  result.rim_values = scene::rim_values(scene.bearing);
  result.made_by = build_version();
  result.errors.left_out_rebound = laws::RimCurve(result.held).left_out_rebound();
  if (order.held_only) return result;
  result.errors.left_out_rebound =
      std::max(laws::RimCurve(result.dish).left_out_rebound(), result.errors.left_out_rebound);
  if (order.estimate && scene.model.mesh > 0) {
    // A coarser mesh's errors are (1.5)^2 times as large, so that the difference is 1.25 times what is left on this
    // one.
    const double refinement = 1.5 * 1.5 - 1;
    result.errors.mesh_force =
        difference(result.dish, pushed(scene.model.mesh - 1, false, {works.back()})) / refinement;
  }
  return result;
}

} // namespace rimpact::fe
