/// What one Newton iteration of a RimSolver works on. Internal to its sources.
#pragma once
#include "fe_contact/runner/rim_solver.h"

namespace rimpact::fe {

/// Unknowns and results of one Newton iteration.
struct RimSolver::Trial {
  Eigen::VectorXd u;
  double multiplier = 0;
  SolidHistory history;
  ContactState contact;
  std::vector<double> pressure_change; ///< expected over the step [Pa]; empty: none
  SolidEnergies energies;
  ContactReport report;
  Eigen::VectorXd residual, R; ///< residual = inertia - R; R = loads - internal - contact forces
  MasterLoad load;
  double scale = 0; ///< size of the forces in play [N]
  bool pattern_holds = true;
  bool keeps_tangent = false; ///< the next evaluation gives forces only
};

/// The terms of the time integrator in a step: u -> v, a.
struct RimSolver::Inertia {
  GeneralizedAlpha scheme;
  double dt;
  Eigen::VectorXd u_predicted, v_predicted, a_old;
  Eigen::VectorXd acceleration(const Eigen::VectorXd &u) const {
    return (u - u_predicted) / (scheme.beta * dt * dt);
  }
  Eigen::VectorXd velocity(const Eigen::VectorXd &a) const { return v_predicted + scheme.gamma * dt * a; }
  double mass_factor() const { return (1 - scheme.alpha_m) / (scheme.beta * dt * dt); }
  double velocity_factor() const { return scheme.gamma / (scheme.beta * dt); }
};

} // namespace rimpact::fe
