/// What a fit is asked for: parameters, their bounds and starts, how the data count.
#pragma once
#include "calibration/data/impact_window.h"
#include <map>
#include <string>
#include <vector>

namespace rimpact::calibration {

/// Of the groups, >= 0; 0 leaves one out. Peak and rebound are what an impact element is for, so where its
/// shape cannot follow a yielding rim these two are met first.
struct Weights {
  double force = 1, displacement = 1, rebound = 3, peak = 3, flight = 1;
};
/// How the samples of a measured impact count.
enum class SampleWeighting {
  automatic, ///< by sample where the law follows every measured impact within its noise, else by curve
  curve,     ///< each curve is one observation with a stated uncertainty, widened by its noise; peak and rebound before
             ///< shapes
  sample ///< each sample is an observation with its noise: the likelihood, which holds only if the law is the right one
};
struct Bounds {
  double lower, upper; ///< in the parameter's reported unit
};

struct FitOptions {
  std::vector<std::string> parameters = {"k_i", "e"};
  std::string law;                      ///< impact law; empty: the runs' own
  std::map<std::string, double> fixed;  ///< held at these values, reported units
  std::map<std::string, Bounds> bounds; ///< instead of the catalogue's
  std::map<std::string, double> start;  ///< a first start, reported units; others are added to it
  /// >= 1: what the curves say, then points spread over the bounds. A law that yields is searched from twice its
  /// number of points more where it follows badly or ends at a bound.
  int n_starts = 5;
  double robust_scale = 20.0;    ///< Huber's, on the norm of an impact's residuals; 0: least squares
  double difference_step = 1e-4; ///< of central differences in the fitted variable, >= 1e-6
  int max_iterations = 60;
  double tolerance = 1e-7;   ///< relative change of the cost at which a search ends, 0..0.01
  bool keep_grazing = false; ///< fit grazing impacts beside others too
  SampleWeighting counting = SampleWeighting::automatic;
  Uncertainty uncertainty;
  Weights weights;
  void validate() const; ///< throws InputError naming option, value and bound
  /// The same while `parameters` may still be empty: those of a law that the runs name.
  void validate_words() const;
};

} // namespace rimpact::calibration
