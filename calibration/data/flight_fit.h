/// State of the slider at an instant of free flight, from the displacement samples around it.
///
/// The reduced model flies from a first guess (ground motion, friction and dish included); what the samples differ from
/// it by is fitted, in x and y, by  du + dv s + a s^2 / 2,  s = t - t_ref, with a prior of zero on a: the model's
/// acceleration may be off by 0.02 m/s^2 + 5 % of itself. So curvature costs certainty only where it is in doubt, and
/// the covariance of (u, v) holds it.
#pragma once
#include "reduced_models/bearings/physical_model.h"
#include <Eigen/Core>
#include <optional>

namespace rimpact::calibration {

/// The model's slider at a place in plan and a velocity there, on the dish; its friction is fully developed.
reduced::BearingState on_the_dish(const reduced::PhysicalModel &model, double t, const Eigen::Vector2d &u,
                                  const Eigen::Vector2d &v);

/// How far the model's acceleration in flight may be off [m/s^2].
inline double acceleration_doubt(double acceleration) {
  return 0.02 + 0.05 * acceleration;
}

struct FlightFit {
  Eigen::Vector2d u, v;  ///< at t_ref [m], [m/s]
  Eigen::Matrix2d shape; ///< covariance of (u, v) of one component over sigma^2
  double square = 0;     ///< sum of squared residuals of the components measured [m^2]
  double freedom = 0;    ///< degrees of freedom left to it
  double lag = 0;        ///< correlation of neighbouring residuals
};

/// Samples first..last of the response (four or more), t_ref within them; `sigma` [m] of a sample, for the prior's
/// weight; `planar`: y is measured too.
FlightFit fit_flight(const scene::Scene &scene, const Response &response, std::size_t first, std::size_t last,
                     double t_ref, double sigma, bool planar);

/// Noise of a displacement's samples by their third differences (root mean square) [m]; 0 for fewer than four.
double displacement_noise(const std::vector<double> &values, std::size_t first, std::size_t last);

} // namespace rimpact::calibration
