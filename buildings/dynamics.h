/// Equations of motion of a linear building on bearings with a rim, one branch at a time (thesis 2.2, 2.4). SI units.
///
///   M q'' + C q' + K q = -M r a_g - g M_v + sum_b W_b^T (N_b (n_b + f_b) + I_b),      z_b = h_b(x_b, y_b) while
///   closed,
///
/// W_b leads from q to the slider of bearing b, n_b the upward normal of its dish, f_b its friction over N_b
/// (Park-Wen), I_b its rim. With G_b = (-grad h, 1) W_b every closed bearing keeps G_b q'' = v^T H v, which gives all N
/// together:
///   sum_c G_b M^-1 W_c^T (n_c + f_c) N_c = v^T H v - G_b a_0,      a_0 the acceleration without them.
/// The sliders stand at the building's nodes: moments of the horizontal forces over the bearings' own height are left
/// out.
#pragma once
#include "buildings/basis.h"
#include "buildings/support_equations.h"
#include "reduced_models/bearings/dynamics.h"
#include "scene/scene.h"

namespace rimpact::buildings {

/// Branch of every bearing: `support` is sliding or airborne.
using BearingModes = std::vector<reduced::Mode>;

/// Throws InputError for an excitation or a normal force that no building takes, and for a [superstructure].
void check_building_scene(const scene::Scene &scene);

class BuildingDynamics : public BuildingBasis {
public:
  /// `bearings`: of each supported node, in their order (frame_source.h); the scene's for none. Throws InputError for
  /// what branches cannot have: rigid bodies, and Coulomb's law, which leaves open how bearings that stick share a
  /// force.
  BuildingDynamics(const BuildingModel &model, const scene::Scene &scene,
                   const std::vector<scene::Scene> &bearings = {});

  Eigen::VectorXd
  start() const; ///< at rest under its weight, displaced and moving as the scene's `free` excitation says
  BuildingResponse evaluate(const BearingModes &modes, double t, const Eigen::VectorXd &y) const;
  /// Fills the rates; returns what acts, which they were made of.
  BuildingResponse rhs(const BearingModes &modes, double t, const Eigen::VectorXd &y, Eigen::VectorXd &dy) const;
  /// Closed sliders onto their dishes.
  void project(const BearingModes &modes, Eigen::VectorXd &y) const;
  /// Which bearings carry: of those on their dish and not approaching it, N >= 0, no slider driven through its dish,
  /// the smaller of N and opening zero. `leaving` (or -1) opens.
  void update_modes(BearingModes &modes, double t, const Eigen::VectorXd &y, int leaving = -1) const;
  /// Frictionless impulses that end the approach of bearing `b` (by its vertical restitution), no other bearing pulled
  /// down. Returns the energy lost [J].
  double land(int b, BearingModes &modes, double t, Eigen::VectorXd &y) const;
  /// Slider of one bearing as its own law's state, for its rim's events.
  reduced::State bearing_state(int b, const Eigen::VectorXd &y) const;

  std::vector<reduced::Dynamics> laws; ///< each bearing's dish, friction and rim under its static load
  double vertical_restitution;

private:
  BearingResponse contact(int b, const reduced::Mode &mode, double t, const Eigen::VectorXd &y,
                          Eigen::Vector3d &per_normal) const;
  /// Without the closed bearings' N: their pendular and friction over it, v^T H v in its place.
  BuildingResponse unsupported(const BearingModes &modes, double t, const Eigen::VectorXd &y, std::vector<int> &closed,
                               std::vector<Eigen::Vector3d> &per_normal) const;
  SupportEquations support_equations(const BuildingResponse &r, const std::vector<int> &closed,
                                     const std::vector<Eigen::Vector3d> &per_normal) const;
  scene::Excitation excitation_;
};

} // namespace rimpact::buildings
