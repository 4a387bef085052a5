/// One touched arc in motion, from the touch to the parts at rest after the release: the solids of rung rim, with the
/// rest of the bearing acting on the slider's top face, which carries the mass.
#pragma once
#include "fe_contact/drive/flight_step.h"
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/step_control.h"
#include "fe_contact/drive/stepper.h"
#include "fe_contact/drive/touched_arcs.h"

namespace rimpact::fe {

class ArcContact {
public:
  ArcContact(const scene::Scene &scene, const planning::Plan &plan, BearingSystem &system, TouchedArcs &arcs,
             const reduced::PhysicalModel &model);

  /// The solids take over, moving as the mass does. The forces on it [N].
  MassForces begin(const reduced::BearingState &bearing, const EnergyLedger &ledger);
  ContactStepReport solve(double t, double dt);
  /// Of the step that was solved: whether it is taken, by local errors of the top face's displacement and of the
  /// energy.
  Attempt assess(const SolvedStep &step, const EnergyLedger &ledger);
  /// Of a step that is taken.
  void follow(const SolvedStep &step) { multiplier_ = step.report.multiplier; }
  /// `touched`: the walls have borne something.
  std::vector<Event> events(const SolvedStep &step, bool touched) const;
  /// Smaller steps are not asked to hold an event more sharply [s].
  double finest_step() const;
  double smallest_step() const { return plan_.step_in_contact / 4096; } ///< [s]
  /// A first step that moves the slider by 10 um at this speed at the most [s].
  double first_step(double approach_speed) const;

  void lift_off();
  /// Touchdown on the dish: the normal velocity is reversed with the stated restitution, its energy booked as contact.
  void land(EnergyLedger &ledger);
  /// The walls have parted: the parts come to rest, what they still vibrated with is booked as lost in the impact.
  void rest(EnergyLedger &ledger);
  /// The height and the support with which the bearing flies on.
  void leave(reduced::BearingState &bearing) const;

  Eigen::Vector3d displacement() const { return arc().frame.displacement(top()); } ///< of the mass, global [m]
  Eigen::Vector3d speed() const { return arc().frame.rate(top_speed()); }          ///< [m/s]
  double outward_speed() const { return top_speed().x(); }                         ///< of the edge [m/s]
  /// Of the rim on what is carried, global [N].
  Eigen::Vector3d rim_force() const { return arc().frame.force(system_.force_of(arc().state, Role::wall)); }
  bool walls_touch() const { return system_.walls_touch(arc().state); }
  const MassForces &forces() const { return forces_after_; } ///< at the step's end [N]
  const StepEnergies &energies() const { return energies_; } ///< of the step
  void visit(StateVisitor &v);

private:
  Arc &arc() { return arcs_.current(); }
  const Arc &arc() const { return arcs_.current(); }
  Eigen::Vector3d top() const { return system_.top_of(arc().state.u); } ///< local, from first touch [m]
  Eigen::Vector3d top_speed() const { return system_.top_of(arc().state.v); }
  double height_above_dish() const { return loads_.height_above_dish(displacement()); } ///< [m]
  /// Global forces where the arc's slider is now, at t, with the dish's push on the mass [N].
  MassForces forces_at(double t, double multiplier) const {
    return loads_.forces(displacement(), speed(), t, support_, multiplier);
  }

  const scene::Scene &scene_;
  const planning::Plan &plan_;
  BearingSystem &system_;
  TouchedArcs &arcs_;
  const reduced::PhysicalModel &model_;
  const StepOptions step_options_;
  MassLoads loads_;
  Support support_;
  double multiplier_ = 0;                          ///< the dish's push on the mass [N]
  double others_elastic_ = 0, others_plastic_ = 0; ///< of the other arcs [J]
  double lift_height_ = 0;                         ///< above the dish when the mass lifted off, at most 0 [m]
  MassForces forces_before_, forces_after_;        ///< of the step
  StepEnergies energies_;                          ///< of the step
};

} // namespace rimpact::fe
