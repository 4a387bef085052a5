/// The bearing of a run that slides on its dish: alone beside a rim that stands still as it was left, or with the rim's
/// solids in the equations.
#pragma once
#include "fe_contact/drive/order.h"
#include "fe_contact/drive/rim_hand_over.h"
#include <map>

namespace rimpact::fe {

class SlidingStack {
public:
  SlidingStack(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan);
  SlidingStack(const SlidingStack &) = delete;

  const BearingModel &model() const { return model_; }
  bool all_solid() const { return model_.rung.dish == DishKind::solid; }
  bool rim_is_solid() const { return near_rim || all_solid(); }
  BearingSystem &active() { return rim_is_solid() ? joined_ : alone_; }
  const BearingSystem &active() const { return rim_is_solid() ? joined_ : alone_; }
  int unknowns() const { return joined_.equations().n; } ///< with the rim

  Eigen::VectorXd displacements() const; ///< by dof, the held rim's shape included [m]
  Eigen::Vector3d travel() const;        ///< of what is carried, from rest on the vertex [m]
  Eigen::Vector3d velocity() const { return model_.rate_ratio * active().top_of(state.v); }     ///< of it [m/s]
  Eigen::Vector3d acceleration() const { return model_.rate_ratio * active().top_of(state.a); } ///< of it [m/s^2]
  Eigen::Vector2d ridden() const; ///< the travel that the dishes have, the slip of the slider's halves taken off [m]
  double gap() const;             ///< left of the lateral capacity by it [m]
  double closing_speed() const;   ///< towards the rim [m/s]
  bool touching() const { return active().walls_touch(state); }
  double kinetic_energy() const { return model_.energy_share() * active().kinetic_energy(state); } ///< [J]

  /// The rim's solids join, at rest in their permanent shape; where all is solid they are there already.
  void join();
  /// The rim's solids leave, and stop where they are. Returns the kinetic energy that is lost with them [J].
  double part();
  /// Where another one stands, whose mesh has a sector less. Throws SolverStopped where the state cannot be carried.
  void carry_over(const SlidingStack &old);
  /// Interpolated stresses do not balance: the parts would ring with what is missing. So they take the accelerations
  /// they have as dead loads and come to balance under them and `load` [N], with the top face where it is. Then what
  /// the held rim stores is known again.
  void balance(const Eigen::VectorXd &load, const StepOptions &options);

  std::map<std::string, double> time_split() const;
  SolverWork work() const;

  SystemState state;
  HeldRim held;
  bool near_rim = false;
  double rest_height = 0;                    ///< of the top face, or the middle, at rest on the vertex [m]
  double rest_elastic = 0, rest_plastic = 0; ///< of the bearing as the run begins [J]

private:
  BearingModel model_;
  BearingSystem alone_, joined_;
};

} // namespace rimpact::fe
