/// The bearing as link properties of SAP2000 (.s2k tables) and ETABS (.e2k lines), kN, m, s; and the same table as
/// plain CSV.
///
/// Rim: RIM_GAP (Gap) in series with RIM (elastoplastic: MultiLinear Plastic, Kinematic; signed, no-tension: Linear,
/// k_i and c_i), joined by a joint of small mass. Drawn from the slider outwards along the motion: moving out shortens
/// them. Dish: DISH (Friction Isolator), beside it DISH_SPRING (MultiLinear Elastic) where it is no sphere. Tables and
/// fields are those of files that SAP2000 20.1 and ETABS 2015 wrote (tests/app/test_export_csi.py names them); import
/// was not tried.
#pragma once
#include "calibration/export/dish.h"
#include "calibration/export/plastic_link.h"
#include "calibration/export/self_check.h"

namespace rimpact::calibration {

struct CsiRim {
  std::optional<PlasticLink> plastic; ///< elastoplastic
  double gap_stiffness;               ///< [N/m]
  double stiffness, damping;          ///< of Linear [N/m], [N s/m]; else of small motions
  SelfCheck check;
  std::vector<std::string> notes;
  MakeContact contact = {}; ///< of one side, as these programs integrate it
};
/// Throws DataError for a law that these programs have no links for (printed, hunt-crossley).
CsiRim csi_rim(const ExportedRim &rim);
/// The whole bearing of the file: the slider stays in its plane, and each side keeps its dent.
FlownBearing flown_bearing(const ExportedRim &rim, const CsiRim &links, const Dish &dish);

std::string sap2000(const ExportedRim &rim, const CsiRim &links, const std::optional<Dish> &dish,
                    const std::vector<std::string> &header);
std::string etabs(const ExportedRim &rim, const CsiRim &links, const std::optional<Dish> &dish,
                  const std::vector<std::string> &header);
/// Force over displacement of RIM (and DISH_SPRING), to paste.
std::string link_csv(const ExportedRim &rim, const CsiRim &links, const std::optional<Dish> &dish,
                     const std::vector<std::string> &header);

} // namespace rimpact::calibration
