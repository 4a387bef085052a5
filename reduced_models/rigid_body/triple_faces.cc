#include "reduced_models/rigid_body/triple_faces.h"
#include "files/json_text.h"
#include <algorithm>

namespace rimpact::reduced::rigid {

double TripleFaces::rim_force(const MotionState &s, int joint) const {
  double largest = 0;
  for (std::size_t i = 0; i < s.contact.size(); ++i) {
    const auto &c = model_.system.contacts[i];
    if (c.set == joint && is_wall(c.surface)) largest = std::max(largest, s.contact[i].size);
  }
  return largest;
}

void TripleFaces::watch(const MotionState &s) {
  for (int j = 0; j < static_cast<int>(faces_.size()); ++j)
    faces_[j].travel = std::max(faces_[j].travel, model_.travel(s, j).norm());
  for (std::size_t i = 0; i < s.contact.size(); ++i) {
    const auto &c = model_.system.contacts[i];
    const auto &f = s.contact[i];
    if (!is_wall(c.surface) || f.size == 0) continue;
    Face &face = faces_[c.set];
    face.force = std::max(face.force, f.size), face.penetration = std::max(face.penetration, f.penetration);
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
