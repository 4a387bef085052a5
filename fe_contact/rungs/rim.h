/// Rung rim: a sector of the rim with the plate below it, and the upper slider, at the place of first touch. Local
/// frame: +x radially outwards through the sector's middle, z up. One system serves every arc of the rim; each arc has
/// its own state.
#pragma once
#include "fe_contact/rungs/rung.h"

namespace rimpact::fe {

namespace rungs {
extern const Rung rim;
}

/// Slider against rim, `stiffer` times as stiff as the cells of `cell` at level 1 [m] are. Of a slider between two
/// dishes its edge: against the rim as stiff as cells of its rounding, and on the dish beside it.
std::vector<Pair> wall_pairs(const BearingModel &model, double cell, double stiffer);

} // namespace rimpact::fe
