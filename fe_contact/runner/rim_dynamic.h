/// The dynamic run of rung R1 as a state machine: flight (reduced model) and contact (solids), handing the
/// mass over at touch and release. Private to the runner; see rim_run.h.
#pragma once
#include "fe_contact/runner/rim_run.h"

namespace rimpact::fe {

class DynamicRun {
public:
  DynamicRun(const scene::Scene &scene, const Plan &plan, const RunOptions &options, RimSolver &solver,
             RunRecord &record)
      : scene_(scene), plan_(plan), options_(options), solver_(solver), record_(record), model_(scene),
        loads_(scene, model_), bearing_(model_.initial_state()), support_(loads_.initial_support()),
        touch_height_(model_.height(scene.bearing.lateral_capacity(), 0).z) {}

  void run();

private:
  bool window() const { return scene_.excitation.kind == scene::ExcitationKind::window; }
  double end_time() const { return scene_.excitation.duration; }
  double capacity() const { return scene_.bearing.lateral_capacity(); }
  double radial_speed() const { return bearing_.v.head<2>().dot(bearing_.u.head<2>().normalized()); } ///< outwards [m/s]

  void start();

  /// Distance of the walls at a slider displacement: exact for fresh arcs, by projection for dented ones.
  double wall_gap(const Eigen::Vector3d &u) const;

  const Arc *arc_at(const Eigen::Vector3d &u) const;

  Arc &touched_arc();

  /// Reduced flight until the walls touch. False: the scene ended first.
  bool fly();

  /// One stretch of flight into the record, whole even where the reduced model stops.
  reduced::FlightEnd reduced_flight(double t_end, const std::function<double(const Eigen::Vector3d &)> &stop);

  void pad_fe_signals();

  /// Global forces at the present end of the step.
  MassForces forces_now(const Arc &arc, double t) const;

  /// The walls touch: the solids take over, moving as the mass does.
  void begin_contact(Arc &arc);

  void contact();

  void step(Arc &arc);

  /// Throws SolverStopped where the rim has let go of a slider that still moves outwards: it has passed the rim.
  void refuse_passage(double outward_speed);

  bool lifts_off(const StepReport &report) const;
  /// The dish is held by its speed (see MasterLoad), so that heights drift by microns: those since the lift-off count.
  bool lands(const Arc &arc) const;
  double height_above_dish(const Arc &arc) const; ///< [m]

  /// Lift-off, landing and release are cut down to a fine step, so that their instants are sharp.
  bool event_is_sharp(const Arc &arc, const StepReport &report, double dt, double finest);

  /// Local errors of the top face's displacement and of the energy; also sets the next step's length.
  bool error_is_small(const Arc &arc, const ArcState &kept, const MassForces &before,
                      const StepReport &report, double dt);

  void accept(Arc &arc, const ArcState &kept, const MassForces &before, const StepReport &report, double dt);

  /// Touchdown on the dish: the normal velocity is reversed with the stated restitution, its energy booked as
  /// contact.
  void land(Arc &arc);

  /// The walls have parted: the parts come to rest, what they still vibrated with is booked as lost in the
  /// impact.
  void end_contact(Arc &arc);

  void sample(const Arc &arc, const StepReport &report, const MassForces &forces, double dt);

  void finish();

  void save() const;
  void restore();

  const scene::Scene &scene_;
  const Plan &plan_;
  const RunOptions &options_;
  RimSolver &solver_;
  RunRecord &record_;
  reduced::PhysicalModel model_;
  MassLoads loads_;
  reduced::BearingState bearing_;
  Support support_;
  double touch_height_;
  std::vector<Arc> arcs_;
  std::size_t current_ = 0; ///< arc in contact
  bool in_contact_ = false, touched_ = false, peak_written_ = false;
  double dt_ = 0, multiplier_ = 0, others_elastic_ = 0, others_plastic_ = 0;
  double lift_height_ = 0; ///< above the dish when the mass lifted off, at most 0 [m]
  scene::Impact impact_{};
};

} // namespace rimpact::fe
