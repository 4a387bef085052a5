/// The dynamic run of rungs rigid-dish and full. rigid-dish: the stack slides on the exact dish, and while the rim may
/// be touched its solids join. full: everything is solid all the time. Private to the runner; see stack_run.h.
#pragma once
#include "fe_contact/drive/checkpoint.h"
#include "fe_contact/drive/stack_drive.h"
#include "fe_contact/drive/stack_recorder.h"
#include "fe_contact/drive/stack_transfer.h"
#include <optional>

namespace rimpact::fe {

class StackDynamic {
public:
  StackDynamic(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options, RunRecord &record);
  /// From the beginning, from a checkpoint whose sectors the plan has, or from where another one stands, whose plan has
  /// a sector less.
  void start();
  void restore(const Checkpoint &file);
  void take_over(const StackDynamic &old);
  /// To the end, or to a place where the rim is not meshed, whose direction it returns [rad].
  std::optional<double> run();
  std::map<std::string, double> time_split() const;
  SolverWork work() const;

private:
  double end_time() const { return scene_.excitation.duration; }
  bool rim_is_solid() const { return near_rim_ || model_.full(); }
  StackSystem &active() { return rim_is_solid() ? joined_ : alone_; }
  const StackSystem &active() const { return rim_is_solid() ? joined_ : alone_; }
  Eigen::VectorXd displacements() const; ///< by dof, the held rim's shape included
  Eigen::Vector3d travel() const;        ///< of the top face from rest on the vertex [m]
  double gap() const;                    ///< left of the lateral capacity [m]
  double wall_gap() const;               ///< between the walls as they are [m]
  double surface_gap() const;            ///< the same once they have touched, before that gap() [m]
  double closing_speed() const;          ///< towards the rim [m/s]
  bool touching() const;
  bool rests() const; ///< as the scout has for good

  /// Quasi-static slide to just short of the rim, then the speed of a window's impact.
  void come_to_rest();
  void slide_out();
  void slide_near(TopDrive &drive, double to);
  /// Along the window's direction, from one distance from the vertex to another [m].
  void slide_to(TopDrive &drive, double from, double to, double first, double longest, const Eigen::VectorXd &load);
  void march_on();
  Attempt attempt(double t, double dt);
  double longest_at_turn() const; ///< step [s]
  /// Length instead of a step that would overshoot a turn, the rim's joining or the touch; 0: it would not.
  double clipped(double dt) const;
  void after_step(double t, double dt, const ContactStepReport &step);
  void account();
  void follow_impact(double t, double dt);
  /// Of the slider, where the rim it comes to is not meshed. Throws SolverStopped where it cannot be.
  std::optional<double> unmeshed_direction() const;
  double book_hand_over(const SolidEnergies &held_before);
  void join();
  void part();
  Eigen::VectorXd load(double t) const;
  void write_fields();
  void save() const;

  const scene::Scene &scene_;
  const planning::Plan plan_;
  const RunOptions &options_;
  RunRecord &record_;
  StackModel model_;
  StackSystem alone_;
  StackSystem joined_;
  StackRecorder recorder_;
  scene::GroundMotion ground_;
  TransientOptions transient_;
  SystemState state_;
  TransientReport report_; ///< its ledger: of the model, without the held rim
  HeldRim held_;
  bool near_rim_ = false, touched_ = false, peak_written_ = false, resting_ = false;
  double t_ = 0, next_step_ = 0, rest_height_ = 0, rest_elastic_ = 0, rest_plastic_ = 0;
  double external_before_ = 0, height_before_ = 0, closing_before_ = 0;
  long steps_kept_ = 0; ///< steps made when the last checkpoint was written
  Impact impact_{};
};

} // namespace rimpact::fe
