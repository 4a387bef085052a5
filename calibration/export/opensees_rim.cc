#include "calibration/export/opensees_rim.h"

#include "calibration/export/flown_there.h"
#include "io/files/error.h"
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

/// The largest stiffness up to the export's highest speed, which sets the self-check's step [N/m].
double stiffest(const ExportedRim &rim, const laws::RimElement &element) {
  constexpr double margin = 4; // the penetration is that of a linear spring
  const double deep = std::sqrt(rim.mass / element.stiffness) * rim.to;
  return std::max(element.stiffness, margin * element.at({.d = deep, .rate = 0}).d_penetration);
}

/// A material with a gap, as OpenSees integrates it.
std::unique_ptr<RimContact> contact_of(const laws::OpenSeesMaterial &material, double touch_speed, bool pulls) {
  const auto number = [&](int i) { return material.numbers[i].value; };
  if (material.material == laws::RimMaterial::hertzdamp)
    return std::make_unique<HertzdampContact>(number(0), number(1), number(2), touch_speed);
  return std::make_unique<DashpotContact>(number(0), number(1), pulls);
}

} // namespace

OpenSeesRim opensees_rim(const ExportedRim &rim) {
  const auto element = rim.element();
  if (!rim.law().opensees)
    throw DataError(fmt::format("OpenSees has no material for the impact law {}", rim.law().name));
  OpenSeesRim out{.material = rim.law().opensees(element)};
  out.in_series = out.material.material == laws::RimMaterial::viscoelastic_gap && rim.law().unilateral;
  if (out.material.material == laws::RimMaterial::gap_springs) {
    out.springs = gap_springs(rim);
    out.contact = [springs = out.springs](double) { return std::make_unique<GapSpringsContact>(springs); };
    out.stiffness = total_stiffness(out.springs);
    out.check = self_check(rim, "four ElasticPPGap in parallel", out.contact, out.stiffness);
    out.check.dented_form = "rim_springs", out.check.new_form = "rim_round, a new rim each time";
  } else {
    out.contact = [material = out.material, pulls = !out.in_series](double speed) {
      return contact_of(material, speed, pulls);
    };
    out.stiffness = stiffest(rim, element);
    out.check = self_check(rim, out.in_series ? "gap in series with spring and dashpot" : word(out.material.material),
                           out.contact, out.stiffness);
  }
  out.check.flown_there = FlownThere{}.json();
  return out;
}

FlownBearing flown_bearing(const ExportedRim &rim, const OpenSeesRim &springs, const Dish &dish) {
  return {.slider = Slider::rides,
          .dish = &dish,
          .mass = rim.mass,
          .weight = rim.vertical,
          .capacity = rim.lateral_capacity,
          .rim = springs.contact,
          .stiffness = springs.stiffness,
          .keeps_dents = springs.springs.empty()};
}

} // namespace rimpact::calibration
