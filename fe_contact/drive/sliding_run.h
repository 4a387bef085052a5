/// Motion in time of a bearing that stands on its dish. Exact dish (rung rigid-dish): the stack slides on it, and while
/// the rim may be touched its solids join. Solid dish (rung full): everything is solid all the time.
#pragma once
#include "fe_contact/drive/drive.h"
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/impact_follower.h"
#include "fe_contact/drive/motion.h"
#include "fe_contact/drive/sliding_pace.h"
#include <optional>

namespace rimpact::fe {

class SlidingRun : public Drive {
public:
  SlidingRun(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
             RunRecord &record);
  /// From the beginning, from a checkpoint whose sectors the plan has, or from where another one stands, whose plan has
  /// a sector less.
  void start();
  using Drive::restore;
  void take_over(const SlidingRun &old);
  /// To the end, or to a place where the rim is not meshed, whose direction it returns [rad].
  std::optional<double> run();
  const SlidingStack &stack() const { return stack_; }
  SteelReport steel() const { return steel_of(stack_.model(), stack_.state); }

private:
  double end_time() const { return scene_.excitation.duration; }
  double surface_gap() const; ///< between the walls as they are once they have touched, before that the gap [m]
  bool leaves() const;        ///< the slider has left the rim

  void march_on();
  /// Of the slider, where the rim it comes to is not meshed. Throws SolverStopped where it cannot be.
  std::optional<double> unmeshed_direction();
  double book_hand_over(const SlidingRun &old);
  void part();
  void follow_impact(const SolvedStep &step);
  void report_lift();
  Eigen::VectorXd load(double t) const;
  void sample(int iterations, double dt);
  void write_fields();

  ContactSystem &system() override { return stack_.active(); }
  SystemState &state() override { return stack_.state; }
  double clipped(double t, double dt) const override { return pace_.clipped(t, dt, stack_, resting_, surface_gap()); }
  ContactStepReport solve(double t, double dt) override;
  std::vector<Event> events(const SolvedStep &step) const override;
  Attempt assess(const SolvedStep &step) override;
  void follow(const SolvedStep &step) override;
  bool take(const std::vector<Event> &events) override { return !events.empty(); }
  void visit(StateVisitor &v) override;

  const scene::Scene &scene_;
  const planning::Plan plan_;
  SlidingStack stack_;
  scene::GroundMotion ground_;
  MotionOptions motion_;
  const SlidingPace pace_;
  bool resting_ = false, reported_lift_ = false;
  double t_ = 0; ///< [s]
  EnergyScale scale_;
  ImpactFollower impact_;
  double height_before_ = 0, closing_before_ = 0; ///< at the step's start [m], [m/s]
  StepEnergies energies_;                         ///< of the step
  Eigen::VectorXd load_before_, load_after_;      ///< likewise
};

} // namespace rimpact::fe
