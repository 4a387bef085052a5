/// The physical model of a single bearing (thesis 2.2): a mass riding a curved dish with Coulomb or Park-Wen
/// friction, unilateral vertical support, and an impact element at the rim. Rung reduced, and the part of rim that
/// is not solid (on the dish itself, whatever spring the scene's pad is). SI units; the plate is fixed, u is the upper
/// slider's displacement relative to the plate.
#pragma once
#include "laws/friction/regularised.h"
#include "laws/friction/sliding_heat.h"
#include "reduced_models/bearings/dented_rim.h"
#include "responses/summary.h"
#include "scene/scene.h"
#include <functional>

namespace rimpact::reduced {

/// Where the mass is and whether the dish carries it.
struct BearingState {
  double t = 0.0;
  Eigen::Vector3d u = Eigen::Vector3d::Zero();   ///< [m]; on the surface u_z = height(u_x, u_y)
  Eigen::Vector3d v = Eigen::Vector3d::Zero();   ///< [m/s]
  bool airborne = false;                         ///< lifted off the dish
  Eigen::Vector2d eta = Eigen::Vector2d::Zero(); ///< Park-Wen state, |eta| <= 1 (unused for coulomb)
  DentedRim rim;                                 ///< read by laws that yield
  friction::HeatModes heat{};                    ///< read by friction that goes by temperature
};

/// Forces on the mass [N] (what the bearing does to the mass), and the surface's normal force.
struct BearingForces {
  Eigen::Vector3d pendular, friction, impact;
  double normal; ///< N >= 0
};

/// What a flight or a run hands back besides its samples.
struct FlightEnd {
  BearingState state;
  bool stopped = false; ///< the stop function crossed zero before t_end
};

/// Friction force for a given normal force, smoothed at zero speed, with its derivatives (laws/friction/regularised.h).
/// Includes the socket's share when switched on.
using friction::FrictionForce;

class PhysicalModel {
public:
  explicit PhysicalModel(const scene::Scene &scene);
  ~PhysicalModel();
  PhysicalModel(PhysicalModel &&) noexcept;

  BearingState initial_state() const;

  /// Integrates WITHOUT the rim element from `start` to t_end, or until stop(u) falls to zero (located to
  /// 1e-12 s). Samples go to `response` (all signals of the reduced model, impact zero), energies accumulate
  /// in `ledger`.
  FlightEnd fly(const BearingState &start, double t_end, const std::function<double(const Eigen::Vector3d &u)> &stop,
                Response &response, EnergyLedger &ledger) const;

  /// Height the slider rides at, with gradient and Hessian; includes the finite pad's lift when switched on.
  scene::SurfacePoint height(double x, double y) const;
  Eigen::Vector3d ground_acceleration(double t) const;
  /// `speed_scale` [m/s] > 0: |v| is replaced by sqrt(|v|^2 + speed_scale^2).
  FrictionForce smoothed_friction(const Eigen::Vector3d &u, const Eigen::Vector3d &v, double normal_force,
                                  double speed_scale) const;
  /// Forces and normal force in a state, without the rim element.
  BearingForces forces(const BearingState &state) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace rimpact::reduced
