#include "calibration/export/csi.h"
#include "calibration/export/comment.h"
#include "calibration/export/dish_text.h"
#include "calibration/export/self_check_text.h"
#include "io/files/error.h"
#include <fmt/format.h>
#include <string_view>

namespace rimpact::calibration {

namespace {

/// A point of a link's table, positive in tension.
struct Point {
  double displacement, force; ///< [m], [kN]
};

CsiRim plastic_rim(const ExportedRim &rim) {
  const PlasticLink link = plastic_link(rim);
  CsiRim out{.plastic = link,
             .gap_stiffness = link.gap_stiffness,
             .stiffness = link.unloading,
             .damping = 0,
             .check = {},
             .notes = {}};
  out.contact = [link](double) { return std::make_unique<PlasticLinkContact>(link); };
  out.check = self_check(rim, "Gap and MultiLinear Plastic (Kinematic) in series", out.contact, link.unloading);
  out.notes = {"RIM: hysteresis type Kinematic. It unloads in a straight line with the slope of its first segment, "
               "chosen to give back the law's rebound; the dent stays. Takeda and Pivot do the same "
               "for a link that a gap keeps out of tension. The tension side of the table is never reached; do not "
               "shorten it: unloading runs on its first segment.",
               "One link alone, its table zero up to the gap, does not do: Kinematic unloads along its first segment, "
               "which would have no stiffness."};
  return out;
}

CsiRim linear_rim(const ExportedRim &rim) {
  const auto element = rim.element();
  CsiRim out{.plastic = {},
             .gap_stiffness = 100 * element.stiffness,
             .stiffness = element.stiffness,
             .damping = element.damping,
             .check = {},
             .notes = {}};
  const double softer = 1 / (1 / out.stiffness + 1 / out.gap_stiffness);
  out.contact = [softer, damping = element.damping](double) {
    return std::make_unique<DashpotContact>(softer, damping, false);
  };
  out.check = self_check(rim, "Gap and Linear (k_i, c_i) in series", out.contact, element.stiffness);
  if (!element.law->unilateral)
    out.notes.push_back("RIM: behind a gap the links cannot pull; the law does just before release, so that the links "
                        "rebound a little faster.");
  return out;
}

std::vector<std::string> head(const ExportedRim &rim, const CsiRim &links, const std::optional<Dish> &dish,
                              const std::vector<std::string> &header, const std::string &program) {
  std::vector<std::string> lines = header;
  lines.insert(lines.end(), rim.statement.begin(), rim.statement.end());
  lines.insert(lines.end(), links.notes.begin(), links.notes.end());
  lines.push_back("Rim: from the slider's joint outwards RIM_GAP, a joint of a thousandth of the mass, RIM, the "
                  "plate's joint; local axis 1 along the motion, so that moving out shortens them. "
                  "Two such pairs, left and right, for motion along one axis. Around the slider n pairs touch between "
                  "two of them late by L_c (1 / cos(pi / n) - 1): " +
                  fmt::format("{:.1f} mm for 4, {:.1f} mm for 16, {:.1f} mm for 36.",
                              1e3 * rim.lateral_capacity * (1 / std::cos(M_PI / 4) - 1),
                              1e3 * rim.lateral_capacity * (1 / std::cos(M_PI / 16) - 1),
                              1e3 * rim.lateral_capacity * (1 / std::cos(M_PI / 36) - 1)));
  if (dish) {
    for (const auto &line : flat_lines(*dish, rim.vertical)) lines.push_back(line);
    if (!dish->sphere)
      lines.push_back(fmt::format("DISH is flat (no radius) and slides; DISH_SPRING beside it restores along axes 2 "
                                  "and 3. In between the two are off by {:+.1f} % at the rim.",
                                  100 * dish->diagonal_error));
  }
  for (const auto &line : lines_of(links.check)) lines.push_back(line);
  lines.push_back(
      "Units: kN, m, s. Tables and fields are held against files that SAP2000 20.1 and ETABS 2015 wrote; import into " +
      program +
      " was not tried: the program is not here. SAP2000 before 20 has no field Point: strike it there. Where a line is "
      "refused, type in the numbers, or paste rim-link.csv.");
  return lines;
}

/// RIM's table: compression negative, from the largest to the tension side's one long elastic segment.
std::vector<Point> rim_points(const PlasticLink &link) {
  std::vector<Point> points;
  for (std::size_t i = link.force.size(); i-- > 0;)
    points.push_back({-link.displacement[i] + 0.0, -link.force[i] / 1e3 + 0.0});
  const double far = 2 * link.force.back();
  points.push_back({far / link.unloading, far / 1e3});
  points.push_back({2 * far / link.unloading, 1.01 * far / 1e3});
  return points;
}

std::vector<Point> dish_points(const ExportedRim &rim, const Dish &dish) {
  std::vector<Point> points;
  for (std::size_t i = dish.travel.size(); i-- > 1;)
    points.push_back({-dish.travel[i], -rim.vertical * dish.slope[i] / 1e3});
  for (std::size_t i = 0; i < dish.travel.size(); ++i)
    points.push_back({dish.travel[i], rim.vertical * dish.slope[i] / 1e3});
  return points;
}

/// DJ, the distance of the shear spring, is a field of U2 and U3 alone.
std::string shear_distance(const std::string &dof) {
  return dof == "U1" ? "" : "   DJ=0";
}

std::string sap_points(const std::string &link, const std::string &dof, double linear, const std::string &hysteresis,
                       const std::vector<Point> &points) {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += fmt::format("   Link={}   DOF={}", link, dof);
    if (i == 0)
      text += fmt::format("   Fixed=No   NonLinear=Yes   TransKE={:.8g}   TransCE=0{}{}", linear, shear_distance(dof),
                          hysteresis);
    text += fmt::format("   Point={}   Force={:.8g}   Displ={:.8g}\n", i + 1, points[i].force, points[i].displacement);
  }
  return text + "\n";
}

/// Of the direction that the line before them names.
std::string etabs_points(const std::string &link, const std::vector<Point> &points) {
  std::string text;
  for (const auto &point : points)
    text +=
        fmt::format("  LINKPROPFORCEDISPL  \"{}\"  DISPL {:.8g} FORCE {:.8g}\n", link, point.displacement, point.force);
  return text;
}

} // namespace

CsiRim csi_rim(const ExportedRim &rim) {
  switch (rim.law().csi) {
  case laws::CsiLink::plastic:
    return plastic_rim(rim);
  case laws::CsiLink::linear:
    return linear_rim(rim);
  case laws::CsiLink::none:
    break;
  }
  throw DataError(fmt::format(
      "SAP2000 and ETABS have no links for the impact law {}; export elastoplastic, signed or no-tension (--law)",
      rim.law().name));
}

FlownBearing flown_bearing(const ExportedRim &rim, const CsiRim &links, const Dish &dish) {
  return {.slider = Slider::flat,
          .dish = &dish,
          .mass = rim.mass,
          .weight = rim.vertical,
          .capacity = rim.lateral_capacity,
          .rim = links.contact,
          .stiffness = links.stiffness};
}

std::string sap2000(const ExportedRim &rim, const CsiRim &r, const std::optional<Dish> &dish,
                    const std::vector<std::string> &header) {
  std::string text = comment_lines("$", head(rim, r, dish, header, "SAP2000")) +
                     "\nTABLE:  \"PROGRAM CONTROL\"\n   ProgramName=SAP2000   CurrUnits=\"KN, m, C\"\n\n";
  text += "TABLE:  \"LINK PROPERTY DEFINITIONS 01 - GENERAL\"\n";
  const auto general = [&](const char *link, const char *type) {
    const bool quoted = std::string_view(type).find(' ') != std::string_view::npos; // as the program writes words
    text += fmt::format("   Link={}   LinkType={}   Mass=0   Weight=0   RotInert1=0   RotInert2=0   RotInert3=0   "
                        "DefLength=1   DefArea=1   PDM2I=0   PDM2J=0   PDM3I=0   PDM3J=0\n",
                        link, quoted ? fmt::format("\"{}\"", type) : type);
  };
  general("RIM_GAP", "Gap"), general("RIM", r.plastic ? "MultiLinear Plastic" : "Linear");
  if (dish) general("DISH", "Friction Isolator");
  if (dish && !dish->sphere) general("DISH_SPRING", "MultiLinear Elastic");
  text += "\n";
  if (!r.plastic)
    text += fmt::format("TABLE:  \"LINK PROPERTY DEFINITIONS 02 - LINEAR\"\n   Link=RIM   DOF=U1   Fixed=No   "
                        "TransKE={:.8g}   TransCE={:.8g}\n\n",
                        r.stiffness / 1e3, r.damping / 1e3);
  if (dish && !dish->sphere) {
    text += "TABLE:  \"LINK PROPERTY DEFINITIONS 03 - MULTILINEAR\"\n";
    for (const char *dof : {"U2", "U3"})
      text += sap_points("DISH_SPRING", dof, rim.vertical / dish->radius / 1e3, "", dish_points(rim, *dish));
  }
  text += fmt::format("TABLE:  \"LINK PROPERTY DEFINITIONS 05 - GAP\"\n   Link=RIM_GAP   DOF=U1   Fixed=No   "
                      "NonLinear=Yes   TransKE=0   TransCE=0   TransK={:.8g}   TransOpen={:.8g}\n\n",
                      r.gap_stiffness / 1e3, rim.lateral_capacity);
  if (dish) {
    text += "TABLE:  \"LINK PROPERTY DEFINITIONS 08 - SLIDING ISOLATOR\"\n";
    text += fmt::format("   Link=DISH   DOF=U1   Fixed=No   NonLinear=Yes   TransKE={0:.8g}   TransCE=0   "
                        "TransK={0:.8g}   TransC=0\n",
                        dish->vertical_stiffness / 1e3);
    for (const char *dof : {"U2", "U3"})
      text += fmt::format("   Link=DISH   DOF={}   Fixed=No   NonLinear=Yes   TransKE={:.8g}   TransCE=0   DJ=0   "
                          "TransK={:.8g}   Slow={:.8g}   Fast={:.8g}   Rate={:.8g}   Radius={:.8g}\n",
                          dof, dish->sphere ? rim.vertical / dish->radius / 1e3 : 0.0,
                          dish->flat_stiffness(rim.vertical) / 1e3, dish->mu_slow, dish->mu_fast,
                          dish->is_coulomb() ? 1 : dish->rate, dish->sphere ? dish->radius : 0.0);
    text += "\n";
  }
  if (r.plastic)
    text += "TABLE:  \"LINK PROPERTY DEFINITIONS 11 - MULTILINEAR PLASTIC\"\n" +
            sap_points("RIM", "U1", r.stiffness / 1e3, "   HysType=Kinematic", rim_points(*r.plastic));
  return text + "END TABLE DATA\n";
}

std::string etabs(const ExportedRim &rim, const CsiRim &r, const std::optional<Dish> &dish,
                  const std::vector<std::string> &header) {
  std::string text = comment_lines("$", head(rim, r, dish, header, "ETABS")) +
                     "\n$ CONTROLS\n  UNITS  \"KN\"  \"M\"  \"C\"\n\n$ LINK PROPERTIES\n";
  const auto link = [&](const char *name, const char *type) {
    text += fmt::format("  LINKPROP  \"{}\"  TYPE \"{}\"\n", name, type);
  };
  link("RIM_GAP", "GAP");
  text += fmt::format("  LINKPROP  \"RIM_GAP\"  DOF \"U1\"  KE 0 CE 0 NONLIN \"Yes\"  K {:.8g} OPEN {:.8g}\n",
                      r.gap_stiffness / 1e3, rim.lateral_capacity);
  link("RIM", r.plastic ? "MULTILINEAR PLASTIC" : "LINEAR");
  if (r.plastic)
    text += fmt::format("  LINKPROP  \"RIM\"  DOF \"U1\"  KE {:.8g} CE 0 NONLIN \"Yes\"  HYSTYPE \"Kinematic\"\n",
                        r.stiffness / 1e3) +
            etabs_points("RIM", rim_points(*r.plastic));
  else
    text += fmt::format("  LINKPROP  \"RIM\"  DOF \"U1\"  KE {:.8g} CE {:.8g}\n", r.stiffness / 1e3, r.damping / 1e3);
  if (!dish) return text;
  link("DISH", "FRICTION ISOLATOR");
  text += fmt::format("  LINKPROP  \"DISH\"  DOF \"U1\"  KE {0:.8g} CE 0 NONLIN \"Yes\"  K {0:.8g} CDAMP 0\n",
                      dish->vertical_stiffness / 1e3);
  for (const char *dof : {"U2", "U3"})
    text += fmt::format("  LINKPROP  \"DISH\"  DOF \"{}\"  KE {:.8g} CE 0 DJ 0 NONLIN \"Yes\"  K {:.8g} CSLOW {:.8g} "
                        "CFAST {:.8g} RATE {:.8g} RADIUS {:.8g}\n",
                        dof, dish->sphere ? rim.vertical / dish->radius / 1e3 : 0.0,
                        dish->flat_stiffness(rim.vertical) / 1e3, dish->mu_slow, dish->mu_fast,
                        dish->is_coulomb() ? 1 : dish->rate, dish->sphere ? dish->radius : 0.0);
  if (dish->sphere) return text;
  link("DISH_SPRING", "MULTILINEAR ELASTIC");
  for (const char *dof : {"U2", "U3"})
    text += fmt::format("  LINKPROP  \"DISH_SPRING\"  DOF \"{}\"  KE {:.8g} CE 0 DJ 0 NONLIN \"Yes\"\n", dof,
                        rim.vertical / dish->radius / 1e3) +
            etabs_points("DISH_SPRING", dish_points(rim, *dish));
  return text;
}

std::string link_csv(const ExportedRim &rim, const CsiRim &r, const std::optional<Dish> &dish,
                     const std::vector<std::string> &header) {
  std::string text = comment_lines("#", head(rim, r, dish, header, "SAP2000 and ETABS"));
  text += comment_line("#", fmt::format("RIM_GAP: stiffness {:.8g} kN/m, opening {:.8g} m. Tension positive.",
                                        r.gap_stiffness / 1e3, rim.lateral_capacity));
  if (!r.plastic)
    text += comment_line("#", fmt::format("RIM: Linear, stiffness {:.8g} kN/m, damping {:.8g} kN s/m.",
                                          r.stiffness / 1e3, r.damping / 1e3));
  text += "link,displacement_m,force_kN\n";
  const auto rows = [&](const char *link, const std::vector<Point> &points) {
    for (const auto &point : points) text += fmt::format("{},{:.8g},{:.8g}\n", link, point.displacement, point.force);
  };
  if (r.plastic) rows("RIM", rim_points(*r.plastic));
  if (dish && !dish->sphere) rows("DISH_SPRING", dish_points(rim, *dish));
  return text;
}

} // namespace rimpact::calibration
