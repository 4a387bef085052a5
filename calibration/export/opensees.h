/// The bearing as OpenSees reads it, in Tcl and Python (openseespy); ndm 3, ndf 6, z up, SI (N, m, s, kg). Every number
/// is a named variable with its unit; nothing of calibration.json stands outside a comment but numbers.
///
/// Rim: elastoplastic as gap_springs.h in parallel; signed and no-tension as ViscoelasticGap (k_i, c_i); hunt-crossley
/// as Hertzdamp. `rim_springs` puts two along x, each with its own dent. `rim_round` (elastoplastic) is one corotTruss
/// from a node 1 mm below the plate's: its elongation is the travel in any direction, so that the rim is round; it
/// forgets dents ("noDamage"), for one made at one side would be met at all. Dish: a sphere is singleFPBearing; any
/// other flatSliderBearing with a corotTruss of the table W h'(r), round alike.
#pragma once
#include "calibration/export/dish.h"
#include "calibration/export/gap_springs.h"
#include "calibration/export/self_check.h"

namespace rimpact::calibration {

/// OpenSees' name of a uniaxial material.
enum class RimMaterial { viscoelastic_gap, hertzdamp };
constexpr auto choices(RimMaterial) {
  return choices_of<RimMaterial>(
      {{RimMaterial::viscoelastic_gap, "ViscoelasticGap"}, {RimMaterial::hertzdamp, "Hertzdamp"}});
}
/// The rim's materials, the same for both languages.
struct OpenSeesRim {
  std::vector<GapSpring> springs;                 ///< elastoplastic; else empty
  std::optional<RimMaterial> material;            ///< empty for elastoplastic
  std::vector<std::array<std::string, 3>> values; ///< name, number, what it is, in the order the material takes them
  SelfCheck check;
  std::vector<std::string> notes; ///< how far the material is the law
};
/// Throws DataError for a law that OpenSees has no material for (printed).
OpenSeesRim opensees_rim(const ExportedRim &rim);

std::string opensees_tcl(const ExportedRim &rim, const OpenSeesRim &springs, const std::optional<Dish> &dish,
                         const std::vector<std::string> &header);
std::string opensees_python(const ExportedRim &rim, const OpenSeesRim &springs, const std::optional<Dish> &dish,
                            const std::vector<std::string> &header);

} // namespace rimpact::calibration
