/// Motion in time where the dish is a law: whole histories and windows of rung rim. Between impacts the reduced model
/// flies; while the walls touch, the solids are stepped implicitly with the rest of the bearing acting on the slider's
/// top face. The mass is handed over at touch and release. Each touched arc keeps its own yielded state.
#pragma once
#include "fe_contact/drive/checkpoint.h"
#include "fe_contact/drive/flight_step.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/run_record.h"
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

class FlightRun {
public:
  FlightRun(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options, BearingSystem &system,
            RunRecord &record)
      : scene_(scene), plan_(plan), options_(options), system_(system),
        step_options_(step_options(system.model().rung, scene)), record_(record), model_(scene), loads_(scene, model_),
        bearing_(model_.initial_state()), support_(loads_.initial_support()),
        touch_height_(model_.height(scene.bearing.lateral_capacity(), 0).z) {}

  void run();
  /// Of all touched arcs.
  SteelReport steel() const;

private:
  bool window() const { return scene_.excitation.kind == scene::ExcitationKind::window; }
  double end_time() const { return scene_.excitation.duration; }
  double capacity() const { return scene_.bearing.lateral_capacity(); }
  double radial_speed() const {
    return bearing_.v.head<2>().dot(bearing_.u.head<2>().normalized());
  } ///< outwards [m/s]

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

  /// Global forces where the arc's slider is now, at t, with the dish's push on the mass [N].
  MassForces forces_now(const Arc &arc, double t, double multiplier) const;

  /// The walls touch: the solids take over, moving as the mass does.
  void begin_contact(Arc &arc);

  void contact();

  /// One step from t; false acceptance leaves everything as it was.
  Attempt attempt(Arc &arc, double t, double dt);
  /// Support, release and what else an accepted step calls for. True: the contact has ended.
  bool after_step(Arc &arc, const ContactStepReport &report);
  Eigen::Vector3d top_of(const Arc &arc) const { return system_.top_of(arc.state.u); } ///< local, from first touch [m]
  Eigen::Vector3d top_speed_of(const Arc &arc) const { return system_.top_of(arc.state.v); } ///< [m/s]
  const SurfaceContactReport &wall_of(const Arc &arc) const { return *system_.report_of(arc.state, Role::wall); }
  void write_fields(const Arc &arc);

  /// Throws SolverStopped where the rim is folded over, or has let go of a slider that still moves outwards: it has
  /// passed the rim.
  void refuse_passage(double outward_speed, bool bears);

  bool lifts_off(const ContactStepReport &report) const;
  /// The dish is held by its speed (see RemoteLoad), so that heights drift by microns: those since the lift-off count.
  bool lands(const Arc &arc) const;
  double height_above_dish(const Arc &arc) const; ///< [m]

  /// Lift-off, landing and release are cut down to a fine step, so that their instants are sharp.
  bool event_is_sharp(const Arc &arc, const ContactStepReport &report, double dt, double finest);

  /// Local errors of the top face's displacement and of the energy; also sets the next step's length.
  bool error_is_small(const FlightStep &step, double dt);

  void accept(Arc &arc, const FlightStep &step, const ContactStepReport &report, double dt);

  /// Touchdown on the dish: the normal velocity is reversed with the stated restitution, its energy booked as
  /// contact.
  void land(Arc &arc);

  /// The walls have parted: the parts come to rest, what they still vibrated with is booked as lost in the
  /// impact.
  void end_contact(Arc &arc);

  void sample(const Arc &arc, int iterations, const MassForces &forces, double dt);

  void finish();

  void save();
  void restore();

  const scene::Scene &scene_;
  const planning::Plan &plan_;
  const RunOptions &options_;
  BearingSystem &system_;
  const StepOptions step_options_;
  RunRecord &record_;
  reduced::PhysicalModel model_;
  MassLoads loads_;
  reduced::BearingState bearing_;
  Support support_;
  double touch_height_;
  std::vector<Arc> arcs_;
  std::size_t current_ = 0; ///< arc in contact
  long steps_kept_ = 0;     ///< steps made when the last checkpoint was written
  bool in_contact_ = false, touched_ = false, peak_written_ = false;
  double dt_ = 0, multiplier_ = 0, others_elastic_ = 0, others_plastic_ = 0;
  double lift_height_ = 0; ///< above the dish when the mass lifted off, at most 0 [m]
  Impact impact_{};
};

} // namespace rimpact::fe
