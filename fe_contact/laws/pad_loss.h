/// What a material that never yields loses as it strains: a dashpot beside each of its springs (Kelvin and Voigt).
///
///   tau = tau_spring(b) + theta / dt (2 mu dev Delta + kappa tr Delta 1),   Delta = ln(f f^T) / 2,   f = F F_old^-1
/// with the retardation theta [s]: at the circular frequency omega the loss factor is theta omega, in shear and in
/// volume, and grows with the frequency. Delta is the logarithmic strain of the step in the present axes: a rotation
/// loses nothing. f f^T = F (F_old^T F_old)^-1 F^T has the form of the elastic b of a step beyond yield, so a point
/// keeps C^-1 in `cp_inverse`, the power of its dashpot [W/m^3] in `overstress`, and what it lost in `viscous_work`.
#pragma once
#include "fe_contact/laws/hencky_j2.h"

namespace rimpact::fe {

struct PadLoss {
  double retardation = 0; ///< theta [s], >= 0
  bool none() const { return !(retardation > 0); }
  /// As HenckyJ2's step, the dashpot of the volume in it; its energy is the spring's, isochoric. dt = 0: infinitely
  /// slow, nothing is lost.
  IsochoricResult step(const HenckyJ2 &spring, const HenckyVolumetric &volume, const J2State &old, const Matrix3 &F,
                       double dt, bool with_tangent = true) const;
};

} // namespace rimpact::fe
