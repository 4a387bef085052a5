/// The curve of a rim at the strain rate of one approach speed, from the one that is pushed infinitely slowly.
///
/// Where every flow stress is s times as large and the stiffness is not, small strains and displacements are s times as
/// large under s times the force: F_s(d) = s F(d / s), on the way back alike. The factor is that of the rim's steel at
/// one rate for the whole impact,
///   s = 1 + w(rate),   rate = v alpha(D) / D,
/// with D the depth at which the static curve stops the mass from the speed v, and alpha the rim's judged strain there.
/// Large strains, and a rate that falls on the way in, are left out: docs/results/refinement.md has the error.
#pragma once
#include "reduced_models/bearings/rim_curve_file.h"

namespace rimpact::fe {

struct FastCurve {
  reduced::RimCurveFile file;
  double rate = 0;   ///< [1/s]
  double factor = 1; ///< s [-], >= 1
};

/// Throws InputError where the rim's steel knows no rate: to be asked before the minutes of a push.
void require_rate(const scene::Bearing &bearing);
/// `mass` [kg] at `speed` [m/s], > 0. Throws InputError where the rim's steel knows no rate, the file has no strain, or
/// its curve does not stop the mass.
FastCurve fast_curve(const reduced::RimCurveFile &slow, const scene::Bearing &bearing, double mass, double speed);

} // namespace rimpact::fe
