#include "fe_contact/laws/pad_loss.h"

#include <cmath>
#include <Eigen/LU>

namespace rimpact::fe {

IsochoricResult PadLoss::step(const HenckyJ2 &spring, const HenckyVolumetric &volume, const J2State &old,
                              const Matrix3 &F, double dt, bool with_tangent) const {
  IsochoricResult result = spring.step({}, F, dt, with_tangent);
  if (!result.admissible) return result;
  result.state = old;
  result.state.cp_inverse = to_vector((F.transpose() * F).inverse());
  result.state.overstress = 0;
  if (!(dt > 0)) return result;
  const IsochoricResult shear = spring.step({.cp_inverse = old.cp_inverse}, F, 0, with_tangent);
  const VolumetricResult swell = volume.at(F.determinant() * std::sqrt(to_matrix(old.cp_inverse).determinant()));
  if (!shear.admissible || !swell.admissible) {
    result.admissible = false;
    return result;
  }
  const double factor = retardation / dt;
  result.response.stress += factor * (shear.response.stress + swell.response.stress);
  if (with_tangent) result.response.tangent += factor * (shear.response.tangent + swell.response.tangent);
  const double power = 2 * factor * (shear.energy + swell.energy) / dt;
  result.state.viscous_work += 0.5 * dt * (old.overstress + power); // by the trapezoid, as the ledgers take work
  result.state.overstress = power;
  return result;
}

} // namespace rimpact::fe
