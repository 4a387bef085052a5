/// The collapse margin of FEMA P-695 (Quantification of Building Seismic Performance Factors, 2009).
#pragma once
#include "io/files/choice.h"

namespace rimpact::reliability {

/// How far the far-field records' spectra are from those of rare motions at the site: the seismic design category.
enum class ShapeCategory {
  low,  ///< B, C and the least of D: epsilon 1.0
  high, ///< the most of D: epsilon 1.5
  near  ///< E: epsilon 1.2
};
constexpr auto choices(ShapeCategory) {
  return choices_of<ShapeCategory>({{ShapeCategory::low, "C", "seismic design categories B, C and the least of D"},
                                    {ShapeCategory::high, "Dmax", "the most of seismic design category D"},
                                    {ShapeCategory::near, "E", "seismic design category E"}});
}

/// Quality of the design rules, the test data and the model.
enum class Rating { superior, good, fair, poor };
constexpr auto choices(Rating) {
  return choices_of<Rating>({{Rating::superior, "A", "superior: 0.10"},
                             {Rating::good, "B", "good: 0.20"},
                             {Rating::fair, "C", "fair: 0.35"},
                             {Rating::poor, "D", "poor: 0.50"}});
}
double uncertainty(Rating rating); ///< [-], section 3.4 and tables 3-1, 3-2, 5-3

/// SSF = exp(beta_1 (epsilon - epsilon_records)), with beta_1 = 0.14 (mu_T - 1)^0.42 and epsilon_records =
/// 0.6 (1.5 - T), from 0 to 0.6 (appendix B); it gives tables 7-1a and 7-1b within their rounding. `period` T [s] > 0,
/// `ductility` mu_T >= 1, counted up to 8.
double spectral_shape_factor(double period, double ductility, ShapeCategory category);

/// Of the records at one intensity: 0.1 + 0.1 mu_T, from 0.2 to 0.4 (equation 7-2).
double record_uncertainty(double ductility);
/// beta_TOT, the root of the sum of squares (equation 7-5), to the nearest 0.025 as tables 7-2 have it.
double total_uncertainty(double ductility, Rating design, Rating tests, Rating model);

/// The least adjusted margin at which a collapse has at most `probability` in (0, 1) under the maximum considered
/// earthquake, of a lognormal with deviation `beta` (table 7-3): exp(-beta Phi^-1(probability)).
double acceptable_margin(double beta, double probability);

} // namespace rimpact::reliability
