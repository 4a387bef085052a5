/// What a run has asked of an inelastic frame's end sections. SI units.
#pragma once
#include "buildings/basis.h"
#include <nlohmann/json.hpp>

namespace rimpact::buildings {

struct HingeEnvelope {
  struct End {
    double moment = 0, plastic_rotation = 0, ductility = 0; ///< largest magnitudes
    HingeResponse last{};
  };
  std::vector<End> ends; ///< i and j of each member
  void widen(const std::vector<HingeResponse> &hinges);
};

/// hinges.csv: one row a member's end.
void write_hinges(const Frame &frame, const HingeEnvelope &envelope, const std::string &path);
/// Of each section's members: yield moment, number of ends that yielded, largest ductility and plastic rotation, least
/// strength and stiffness left; and the frame's assumptions.
nlohmann::json to_json(const Frame &frame, const HingeEnvelope &envelope);

} // namespace rimpact::buildings
