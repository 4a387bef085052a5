#include "reduced_models/friction_law.h"
#include "files/error.h"
#include <cmath>
#include <string>

namespace rimpact::reduced {

void FrictionCoefficient::validate() const {
  const auto text = [](double v) { return std::to_string(v); };
  if (!(mu_slow >= 0)) throw InputError("reduced.mu_slow " + text(mu_slow) + " is below 0");
  if (!(mu_fast >= mu_slow)) throw InputError("reduced.mu_slow " + text(mu_slow) + " exceeds mu_fast " + text(mu_fast));
  if (!constant() && !(rate > 0))
    throw InputError("reduced.rate_s_per_m " + text(rate) + " must be above 0 when mu_slow differs from mu_fast");
}

ValueAndSlope FrictionCoefficient::at(double speed) const {
  if (constant()) return {mu_fast, 0.0};
  const double transition = (mu_fast - mu_slow) * std::exp(-rate * speed);
  return {mu_fast - transition, rate * transition};
}

} // namespace rimpact::reduced
