#include "calibration/export/self_check.h"
#include <algorithm>
#include <cmath>

namespace rimpact::calibration {

SelfCheck self_check(const ExportedRim &rim, const std::string &form, const MakeContact &make, double stiffness) {
  SelfCheck check{.form = form, .rows = {}, .dents = rim.law().yields};
  for (const double speed : speeds_between(rim.from, rim.to, 5)) {
    LawContact law(rim.element());
    const auto spring = make(speed);
    CheckRow row{.speed = speed,
                 .law = fly(law, rim.mass, speed, rim.settings.k_i),
                 .spring = fly(*spring, rim.mass, speed, stiffness),
                 .law_again = {},
                 .spring_again = {}};
    check.peak_force = std::max(check.peak_force, std::abs(row.spring.peak_force / row.law.peak_force - 1));
    check.penetration = std::max(check.penetration, std::abs(row.spring.penetration / row.law.penetration - 1));
    check.rebound = std::max(check.rebound, std::abs(row.spring.rebound - row.law.rebound));
    if (check.dents) {
      row.law_again = fly(law, rim.mass, speed, rim.settings.k_i);
      row.spring_again = fly(*spring, rim.mass, speed, stiffness);
    }
    check.rows.push_back(row);
  }
  return check;
}

double SelfCheck::again() const {
  double most = 0;
  for (const auto &row : rows)
    if (dents) most = std::max(most, std::abs(row.spring_again.peak_force / row.law_again.peak_force - 1));
  return most;
}

double SelfCheck::again_new() const {
  double most = 0;
  for (const auto &row : rows)
    if (dents && !new_form.empty())
      most = std::max(most, std::abs(row.spring.peak_force / row.law_again.peak_force - 1));
  return most;
}

} // namespace rimpact::calibration
