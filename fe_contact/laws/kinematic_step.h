/// A step of HenckyJ2 with a backstress, after Eterovic and Bathe (International Journal for Numerical Methods in
/// Engineering 30, 1990): the return map of small strains on logarithmic ones, in the intermediate configuration.
///
/// That is unloaded by U_p = C_p^(1/2), without a turn. With F_e = F U_p^-1 = V R, the trial strain ln V turned back by
/// R, and the backstress that is kept there, kinematic_return.h gives the elastic strain eps_e, taken back by R. Where
/// it is not coaxial with the trial strain, exp(2 eps_e) = b_e is exact and the flow rule is off by the product of an
/// elastic and a plastic strain. There is no plastic spin: what F_p = R^T exp(-eps_e) F turns beyond its own U_p is
/// taken out of the backstress. So C_p^-1 and the backstress are all that is kept, and a turned body has a turned
/// stress.
#pragma once
#include "fe_contact/laws/hencky_j2.h"

namespace rimpact::fe {

/// As HenckyJ2::step. The tangent is the derivative, which has no major symmetry where a backstress is turned.
IsochoricResult kinematic_step(const HenckyJ2 &law, const J2State &old, const Matrix3 &F, double dt, bool with_tangent);

} // namespace rimpact::fe
