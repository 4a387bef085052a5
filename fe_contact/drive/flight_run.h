/// Motion in time where the dish is a law: whole histories and windows of rung rim. Between impacts the reduced model
/// flies; while the walls touch, the solids are stepped implicitly with the rest of the bearing acting on the slider's
/// top face. The mass is handed over at touch and release. Each touched arc keeps its own yielded state.
#pragma once
#include "fe_contact/drive/drive.h"
#include "fe_contact/drive/flight_step.h"
#include "fe_contact/drive/impact_follower.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/rungs/mass_loads.h"

namespace rimpact::fe {

/// Runs a window, a pulse, a record or free motion into `record`. Throws SolverStopped or Interrupted with the record
/// as it stands.
void run_flights(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                 RunRecord &record);

/// One touched arc of the rim.
struct Arc {
  RimFrame frame;
  SystemState state;
  bool yielded = false;
};

class FlightRun : public Drive {
public:
  FlightRun(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options, BearingSystem &system,
            RunRecord &record);
  void run();
  /// Of all touched arcs.
  SteelReport steel() const;

private:
  bool window() const { return scene_.excitation.kind == scene::ExcitationKind::window; }
  double end_time() const { return scene_.excitation.duration; }
  double capacity() const { return scene_.bearing.lateral_capacity(); }
  double penetration() const { return bearing_.u.head<2>().norm() - capacity(); } ///< beyond L_c [m]
  double radial_speed() const {
    return bearing_.v.head<2>().dot(bearing_.u.head<2>().normalized());
  } ///< outwards [m/s]

  void start();
  RimFrame frame_at(double direction) const {
    return RimFrame::of(scene_.bearing, direction, touch_height_, loads_.initial_support() == Support::held);
  }
  /// Distance of the walls at a slider displacement: exact for fresh arcs, by projection for dented ones.
  double wall_gap(const Eigen::Vector3d &u) const;
  const Arc *arc_at(const Eigen::Vector3d &u) const;
  void choose_arc(); ///< that is touched: a known one, or a fresh one
  /// Reduced flight until the walls touch. False: the scene ended first.
  bool fly();
  /// One stretch of flight into the record, whole even where the reduced model stops.
  reduced::FlightEnd reduced_flight(double t_end, const std::function<double(const Eigen::Vector3d &)> &stop);
  void pad_fe_signals();
  void finish();

  // While the walls touch (flight_contact.cc):
  /// Global forces where the arc's slider is now, at t, with the dish's push on the mass [N].
  MassForces forces_now(double t, double multiplier) const;
  /// The walls touch: the solids take over, moving as the mass does.
  void begin_contact();
  void contact();
  double smallest_step() const { return plan_.step_in_contact / 4096; }       ///< [s]
  Eigen::Vector3d top() const { return system_.top_of(arc().state.u); }       ///< local, from first touch [m]
  Eigen::Vector3d top_speed() const { return system_.top_of(arc().state.v); } ///< [m/s]
  /// Of the rim on what is carried, global [N].
  Eigen::Vector3d rim_force() const { return arc().frame.force(system_.force_of(arc().state, Role::wall)); }
  double wall_force() const { return rim_force().head<2>().norm(); } ///< [N]
  double height_above_dish() const;                                  ///< [m]
  FlightStep flight_step(const SolvedStep &step) const;
  void sample(int iterations, const MassForces &forces, double dt);
  void write_fields();
  void picture(double t, double dt); ///< fields at the deepest point, and where they are asked for
  /// Throws SolverStopped where the rim is folded over, or has let go of a slider that still moves outwards: it has
  /// passed the rim.
  void refuse_passage();
  [[noreturn]] void stop_impact(const std::string &reason); ///< saves, and leaves the impact open
  /// Touchdown on the dish: the normal velocity is reversed with the stated restitution, its energy booked as
  /// contact.
  void land();
  /// The walls have parted: the parts come to rest, what they still vibrated with is booked as lost in the
  /// impact.
  void end_contact();

  Arc &arc() { return arcs_[current_]; }
  const Arc &arc() const { return arcs_[current_]; }
  ContactSystem &system() override { return system_; }
  SystemState &state() override { return arc().state; }
  ContactStepReport solve(double t, double dt) override;
  std::vector<Event> events(const SolvedStep &step) const override;
  double sharp_step(const std::vector<Event> &events) const override;
  /// Local errors of the top face's displacement and of the energy.
  Attempt assess(const SolvedStep &step) override;
  void follow(const SolvedStep &step) override;
  bool take(const std::vector<Event> &events) override;
  void visit(StateVisitor &v) override;
  void start_afresh() override;

  const scene::Scene &scene_;
  const planning::Plan &plan_;
  BearingSystem &system_;
  const StepOptions step_options_;
  reduced::PhysicalModel model_;
  MassLoads loads_;
  reduced::BearingState bearing_;
  Support support_;
  double touch_height_;
  std::vector<Arc> arcs_;
  std::size_t current_ = 0; ///< arc in contact
  bool in_contact_ = false;
  double multiplier_ = 0; ///< the dish's push on the mass
  double others_elastic_ = 0, others_plastic_ = 0;
  double lift_height_ = 0; ///< above the dish when the mass lifted off, at most 0 [m]
  ImpactFollower impact_;
  MassForces forces_before_, forces_after_; ///< of the step
  StepEnergies energies_;                   ///< of the step
};

} // namespace rimpact::fe
