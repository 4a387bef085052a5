/// The bearing as OpenSees reads it, in Tcl and Python (openseespy); ndm 3, ndf 6, z up, SI (N, m, s, kg). Every number
/// is a named variable with its unit; nothing of calibration.json stands outside a comment but numbers.
///
/// Rim: elastoplastic as gap_springs.h in parallel; signed and no-tension as ViscoelasticGap (k_i, c_i); hunt-crossley
/// as Hertzdamp. `rim_springs` puts two along x, each with its own dent. `rim_round` (elastoplastic) is one corotTruss
/// from a node 1 mm below the plate's: its elongation is the travel in any direction, so that the rim is round; it
/// forgets dents ("noDamage"), for one made at one side would be met at all. Dish: rider.h, opensees_dish_texts.h.
#pragma once
#include "calibration/export/dish.h"
#include "calibration/export/opensees_rim.h"

namespace rimpact::calibration {

std::string opensees_tcl(const ExportedRim &rim, const OpenSeesRim &springs, const std::optional<Dish> &dish,
                         const std::vector<std::string> &header);
std::string opensees_python(const ExportedRim &rim, const OpenSeesRim &springs, const std::optional<Dish> &dish,
                            const std::vector<std::string> &header);

} // namespace rimpact::calibration
