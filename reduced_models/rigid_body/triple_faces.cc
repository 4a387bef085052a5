#include "reduced_models/rigid_body/triple_faces.h"
#include "io/files/json_text.h"
#include <algorithm>

namespace rimpact::reduced::rigid {

TripleFaces::RimPress TripleFaces::pressed(const MotionState &s, int joint) const {
  RimPress largest;
  for (std::size_t i = 0; i < s.contact.size(); ++i) {
    const auto &c = model_.system.contacts[i];
    const auto &f = s.contact[i];
    if (c.set != joint || !is_wall(c.surface) || f.size == 0) continue;
    largest = {std::max(largest.force, f.size), std::max(largest.penetration, f.penetration)};
  }
  return largest;
}

void TripleFaces::watch(const MotionState &s) {
  for (int j = 0; j < static_cast<int>(faces_.size()); ++j) {
    Face &face = faces_[j];
    face.travel = std::max(face.travel, model_.travel(s, j).norm());
    const RimPress rim = pressed(s, j);
    if (rim.force == 0) continue;
    face.force = std::max(face.force, rim.force), face.penetration = std::max(face.penetration, rim.penetration);
    if (!face.touched) face.touched = s.t;
  }
}

nlohmann::json TripleFaces::summary() const {
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t j = 0; j < faces_.size(); ++j)
    rows.push_back({{"face", j + 1},
                    {"peak_travel_m", faces_[j].travel},
                    {"rim_touched_s", or_null(faces_[j].touched)},
                    {"rim_peak_force_N", faces_[j].force},
                    {"rim_peak_penetration_m", faces_[j].penetration}});
  return rows;
}

} // namespace rimpact::reduced::rigid
