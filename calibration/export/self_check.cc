#include "calibration/export/self_check.h"
#include <fmt/format.h>

namespace rimpact::calibration {

SelfCheck self_check(const ExportedRim &rim, const std::string &form, const MakeContact &make, double stiffness) {
  SelfCheck check{.form = form, .rows = {}};
  for (const double speed : speeds_between(rim.from, rim.to, 5)) {
    LawContact law(rim.element());
    const auto spring = make(speed);
    const CheckRow row{speed, fly(law, rim.mass, speed, rim.settings.k_i), fly(*spring, rim.mass, speed, stiffness)};
    check.peak_force = std::max(check.peak_force, std::abs(row.spring.peak_force / row.law.peak_force - 1));
    check.penetration = std::max(check.penetration, std::abs(row.spring.penetration / row.law.penetration - 1));
    check.rebound = std::max(check.rebound, std::abs(row.spring.rebound - row.law.rebound));
    check.rows.push_back(row);
  }
  return check;
}

std::string SelfCheck::sentence() const {
  return fmt::format("{}Self-check of the {}, flown by rimpact at {:.3g} to {:.3g} m/s against the law: peak force "
                     "within {:.1f} %, penetration within {:.1f} %, "
                     "rebound within {:.3f} of the approach speed.",
                     serves() ? "" : "DOUBT: ", form, rows.front().speed, rows.back().speed, 100 * peak_force,
                     100 * penetration, rebound);
}

std::vector<std::string> SelfCheck::lines() const {
  std::vector<std::string> all{sentence()};
  for (const auto &[speed, law, spring] : rows)
    all.push_back(fmt::format("  {:.3g} m/s: peak {:.1f} kN (law {:.1f}), penetration {:.3f} mm (law {:.3f}), rebound "
                              "{:.3f} of the approach (law {:.3f}), contact {:.2f} ms.",
                              speed, spring.peak_force / 1e3, law.peak_force / 1e3, 1e3 * spring.penetration,
                              1e3 * law.penetration, spring.rebound, law.rebound, 1e3 * spring.duration));
  return all;
}

nlohmann::json SelfCheck::json() const {
  nlohmann::json all = nlohmann::json::array();
  const auto side = [](const Bounce &i) {
    return nlohmann::json{{"peak_force_kN", i.peak_force / 1e3},
                          {"penetration_mm", 1e3 * i.penetration},
                          {"rebound", i.rebound},
                          {"contact_time_ms", 1e3 * i.duration}};
  };
  for (const auto &row : rows)
    all.push_back({{"speed_m_s", row.speed}, {"law", side(row.law)}, {"spring", side(row.spring)}});
  return {{"form", form},
          {"peak_force_difference", peak_force},
          {"penetration_difference", penetration},
          {"rebound_difference", rebound},
          {"serves", serves()},
          {"sentence", sentence()},
          {"rows", all}};
}

} // namespace rimpact::calibration
