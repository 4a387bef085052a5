/// Rims that are pressed one behind the other: each bears the force of all, and is pressed its share of the way.
#pragma once
#include "laws/impact/impact_law.h"
#include <optional>

namespace rimpact::laws {

/// Numbers of one of `rims` alike in series that together follow `law` with `numbers`: F_one(d) = F(rims d). None where
/// no stiffness of one rim does that. A dashpot scaled by the supported mass is left to who runs the rims: it is the
/// pair's restitution that counts.
std::optional<LawNumbers> one_in_series(const ImpactLaw &law, LawNumbers numbers, int rims);

} // namespace rimpact::laws
