#include "buildings/summary_row.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::buildings {

Summary row_summary(Summary s) {
  const nlohmann::json building = s.extra.at("building");
  s.extra.erase("building");
  for (const char *key : {"worst_bearing", "peak_overturning_N_m", "peak_base_rotation_rad",
                          "peak_base_acceleration_m_s2", "peak_base_displacement_m"})
    s.extra[key] = building.at(key);
  int hit = 0;
  double uplift = 0, heaviest = 0;
  for (const auto &bearing : building.at("bearings")) {
    hit += bearing.at("impacts").get<int>() > 0;
    uplift = std::max(uplift, bearing.at("peak_uplift_m").get<double>());
    heaviest = std::max(heaviest, bearing.at("static_normal_force_N").get<double>());
  }
  s.extra["n_bearings_hit"] = hit, s.extra["peak_uplift_m"] = uplift;
  s.extra["largest_static_normal_force_N"] = heaviest;
  int number = 0;
  for (const auto &floor : building.at("floors")) {
    ++number;
    for (const char *key :
         {"peak_drift_m", "peak_drift_x_m", "peak_drift_y_m", "peak_acceleration_m_s2", "peak_shear_N"})
      s.extra[fmt::format("floor_{}_{}", number, key)] = floor.at(key);
  }
  return s;
}

} // namespace rimpact::buildings
