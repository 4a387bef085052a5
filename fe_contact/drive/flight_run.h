/// Motion in time where the dish is a law: whole histories and windows of rung rim. Between impacts the reduced model
/// flies; while the walls touch, the solids are stepped implicitly with the rest of the bearing acting on the slider's
/// top face. The mass is handed over at touch and release. Each touched arc keeps its own yielded state.
#pragma once
#include "fe_contact/drive/arc_contact.h"
#include "fe_contact/drive/drive.h"
#include "fe_contact/drive/impact_follower.h"

namespace rimpact::fe {

/// Runs a window, a pulse, a record or free motion into `record`. Throws SolverStopped or Interrupted with the record
/// as it stands.
void run_flights(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                 RunRecord &record);

class FlightRun : public Drive {
public:
  FlightRun(const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options, BearingSystem &system,
            RunRecord &record);
  void run();
  SteelReport steel() const { return arcs_.steel(); }

private:
  bool window() const { return scene_.excitation.kind == scene::ExcitationKind::window; }
  double end_time() const { return scene_.excitation.duration; }
  double capacity() const { return scene_.bearing.lateral_capacity(); }
  double penetration() const { return bearing_.u.head<2>().norm() - capacity(); } ///< beyond L_c [m]
  double radial_speed() const {
    return bearing_.v.head<2>().dot(bearing_.u.head<2>().normalized());
  } ///< outwards [m/s]

  void start();
  /// Reduced flight until the walls touch. False: the scene ended first.
  bool fly();
  /// One stretch of flight into the record, whole even where the reduced model stops.
  reduced::FlightEnd reduced_flight(double t_end, const std::function<double(const Eigen::Vector3d &)> &stop);
  void pad_fe_signals();
  void finish();

  // While the walls touch:
  void begin_contact();
  void contact();
  void sample(int iterations, const MassForces &forces, double dt);
  void write_fields();
  void picture(double t, double dt); ///< fields at the deepest point, and where they are asked for
  /// Throws SolverStopped where the rim is folded over, or has let go of a slider that still moves outwards: it has
  /// passed the rim.
  void refuse_passage();
  [[noreturn]] void stop_impact(const std::string &reason); ///< saves, and leaves the impact open
  void end_contact();

  ContactSystem &system() override { return system_; }
  SystemState &state() override { return arcs_.current().state; }
  ContactStepReport solve(double t, double dt) override { return contact_.solve(t, dt); }
  std::vector<Event> events(const SolvedStep &step) const override { return contact_.events(step, impact_.touched()); }
  double sharp_step(const std::vector<Event> &events) const override;
  Attempt assess(const SolvedStep &step) override { return contact_.assess(step, record_.ledger); }
  void follow(const SolvedStep &step) override;
  bool take(const std::vector<Event> &events) override;
  void visit(StateVisitor &v) override;
  void start_afresh() override;

  const scene::Scene &scene_;
  const planning::Plan &plan_;
  BearingSystem &system_;
  reduced::PhysicalModel model_;
  reduced::BearingState bearing_;
  TouchedArcs arcs_;
  ArcContact contact_;
  bool in_contact_ = false;
  ImpactFollower impact_;
};

} // namespace rimpact::fe
