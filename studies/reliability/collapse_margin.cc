#include "studies/reliability/collapse_margin.h"
#include "studies/reliability/normal.h"
#include <algorithm>
#include <cmath>

namespace rimpact::reliability {

double uncertainty(Rating rating) {
  switch (rating) {
  case Rating::superior:
    return 0.10;
  case Rating::good:
    return 0.20;
  case Rating::fair:
    return 0.35;
  case Rating::poor:
    return 0.50;
  }
  return 0.50;
}

double spectral_shape_factor(double period, double ductility, ShapeCategory category) {
  constexpr double most_ductility = 8;
  const double epsilon = category == ShapeCategory::high ? 1.5 : category == ShapeCategory::near ? 1.2 : 1.0;
  const double of_records = std::clamp(0.6 * (1.5 - period), 0.0, 0.6);
  const double slope = 0.14 * std::pow(std::clamp(ductility, 1.0, most_ductility) - 1, 0.42);
  return std::exp(slope * (epsilon - of_records));
}

double record_uncertainty(double ductility) {
  return std::clamp(0.1 + 0.1 * ductility, 0.2, 0.4);
}

double total_uncertainty(double ductility, Rating design, Rating tests, Rating model) {
  const double records = record_uncertainty(ductility);
  double squares = records * records;
  for (const Rating rating : {design, tests, model}) squares += uncertainty(rating) * uncertainty(rating);
  constexpr double rounding = 0.025;
  return std::round(std::sqrt(squares) / rounding) * rounding;
}

double acceptable_margin(double beta, double probability) {
  return std::exp(-beta * standard_score(probability));
}

} // namespace rimpact::reliability
