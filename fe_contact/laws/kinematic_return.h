/// Return map of J2 plasticity about a backstress, at small strains, for any stress that is linear in the deviatoric
/// elastic strain: backward Euler over a step, one scalar equation. With the trial stress s* = 2 mu dev eps*, the old
/// backstresses B_k and x the change of alpha (backstress.h, hardening.h, strain_rate.h)
///   eta(x) = s* - sum theta_k B_k,   n = eta / |eta|,
///   sqrt(3/2) |eta(x)| - 3 mu x - sum theta_k C_k x = sigma_s(alpha + x) (1 + w).
/// The left side falls by 3 mu at least, for no backstress grows beyond C_k / gamma_k: there is one root. The rate's
/// overstress widens the yield surface; the backstress knows no rate. Tensors as in backstress.h.
#pragma once
#include "fe_contact/laws/hencky_j2.h"

namespace rimpact::fe {

struct KinematicReturn {
  Tensor6 strain;             ///< elastic deviator at the step's end
  Backstress back;            ///< there [Pa]
  double flow = 0;            ///< change of alpha [-], >= 0; 0: the step is elastic
  double overstress = 0;      ///< [Pa]
  double back_work = 0;       ///< of the backstress on the plastic strain, by the trapezoid [J/m^3]
  Map6 moduli = Map6::Zero(); ///< d stress / d trial strain [Pa]; unsymmetric where a backstress is turned
};

/// `trial`: deviator of the trial strain.
/// `back`: the old backstress in the trial strain's axes, in the place of the state's own.
KinematicReturn kinematic_return(const HenckyJ2 &law, const Tensor6 &trial, const Backstress &back, const J2State &old,
                                 double dt);

} // namespace rimpact::fe
