/// Motion in time of a bearing that stands on its dish. Exact dish (rung rigid-dish): the stack slides on it, and while
/// the rim may be touched its solids join. Solid dish (rung full): everything is solid all the time.
#pragma once
#include "fe_contact/drive/drive.h"
#include "fe_contact/drive/forces.h"
#include "fe_contact/drive/impact_follower.h"
#include "fe_contact/drive/motion.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/rim_hand_over.h"
#include <optional>

namespace rimpact::fe {

/// Away from the rim, sliding [s].
constexpr double longest_sliding_step = 0.02;
/// A slower slider rests, if the scout has done sliding too; the stack rings with half of it [m/s].
constexpr double sliding_speed = 1e-2;

/// Runs a window, a pulse or a record into `record`. Throws SolverStopped or Interrupted with the record as it stands.
void run_sliding(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                 RunRecord &record);

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
  std::map<std::string, double> time_split() const;
  SteelReport steel() const { return steel_of(model_, state_); }
  SolverWork work() const;

private:
  double end_time() const { return scene_.excitation.duration; }
  bool all_solid() const { return model_.rung.dish == DishKind::solid; }
  bool rim_is_solid() const { return near_rim_ || all_solid(); }
  BearingSystem &active() { return rim_is_solid() ? joined_ : alone_; }
  const BearingSystem &active() const { return rim_is_solid() ? joined_ : alone_; }
  Eigen::VectorXd displacements() const; ///< by dof, the held rim's shape included
  Eigen::Vector3d travel() const;        ///< of the top face from rest on the vertex [m]
  double gap() const;                    ///< left of the lateral capacity [m]
  double surface_gap() const;   ///< between the walls as they are once they have touched, before that gap() [m]
  double closing_speed() const; ///< towards the rim [m/s]
  bool touching() const;
  bool rests_at(double t) const;  ///< as the scout has for good
  double longest_at_turn() const; ///< step [s]
  bool leaves() const;            ///< the slider has left the rim

  void march_on();
  /// Of the slider, where the rim it comes to is not meshed. Throws SolverStopped where it cannot be.
  std::optional<double> unmeshed_direction();
  double book_hand_over(const SlidingRun &old);
  void join();
  void part();
  void follow_impact(const SolvedStep &step);
  void report_lift();
  Eigen::VectorXd load(double t) const;
  void sample(int iterations, double dt);
  void write_fields();

  ContactSystem &system() override { return active(); }
  SystemState &state() override { return state_; }
  /// Length instead of a step that would overshoot a turn, the rim's joining or the touch.
  double clipped(double t, double dt) const override;
  ContactStepReport solve(double t, double dt) override;
  std::vector<Event> events(const SolvedStep &step) const override;
  Attempt assess(const SolvedStep &step) override;
  void follow(const SolvedStep &step) override;
  bool take(const std::vector<Event> &events) override { return !events.empty(); }
  void visit(StateVisitor &v) override;

  const scene::Scene &scene_;
  const planning::Plan plan_;
  BearingModel model_;
  BearingSystem alone_;
  BearingSystem joined_;
  scene::GroundMotion ground_;
  MotionOptions motion_;
  SystemState state_;
  HeldRim held_;
  bool near_rim_ = false, resting_ = false, reported_lift_ = false;
  double t_ = 0, rest_height_ = 0, rest_elastic_ = 0, rest_plastic_ = 0;
  EnergyScale scale_;
  ImpactFollower impact_;
  double height_before_ = 0, closing_before_ = 0; ///< at the step's start [m], [m/s]
  StepEnergies energies_;                         ///< of the step
  Eigen::VectorXd load_before_, load_after_;      ///< likewise
};

} // namespace rimpact::fe
