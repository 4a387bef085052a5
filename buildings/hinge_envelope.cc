#include "buildings/hinge_envelope.h"
#include "io/files/file.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::buildings {

void HingeEnvelope::widen(const std::vector<HingeResponse> &hinges) {
  ends.resize(hinges.size());
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    End &end = ends[i];
    end.moment = std::max(end.moment, std::abs(hinges[i].moment));
    end.plastic_rotation = std::max(end.plastic_rotation, std::abs(hinges[i].plastic_rotation));
    end.ductility = std::max(end.ductility, hinges[i].ductility), end.last = hinges[i];
  }
}

void write_hinges(const Frame &frame, const HingeEnvelope &envelope, const std::string &path) {
  std::string text =
      "element,node,end,section,yield_moment_N_m,peak_moment_N_m,peak_ductility,peak_plastic_rotation_rad,"
      "residual_plastic_rotation_rad,strength_left,stiffness_left\n";
  for (std::size_t i = 0; i < envelope.ends.size(); ++i) {
    const Element &member = frame.elements[i / 2];
    const Section &section = frame.sections[member.section];
    const auto &end = envelope.ends[i];
    text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", i / 2 + 1,
                        (i % 2 ? member.j : member.i) + 1, i % 2 ? "j" : "i", section.name,
                        section.inelastic->yield_moment, end.moment, end.ductility, end.plastic_rotation,
                        end.last.plastic_rotation, end.last.strength_left, end.last.stiffness_left);
  }
  write_atomically(text, path);
}

nlohmann::json to_json(const Frame &frame, const HingeEnvelope &envelope) {
  nlohmann::json sections = nlohmann::json::array();
  for (std::size_t s = 0; s < frame.sections.size(); ++s) {
    int yielded = 0;
    double moment = 0, ductility = 0, rotation = 0, strength = 1, stiffness = 1;
    for (std::size_t i = 0; i < envelope.ends.size(); ++i) {
      if (frame.elements[i / 2].section != static_cast<int>(s)) continue;
      const auto &end = envelope.ends[i];
      yielded += end.ductility > 1, moment = std::max(moment, end.moment),
                                    ductility = std::max(ductility, end.ductility);
      rotation = std::max(rotation, end.plastic_rotation);
      strength = std::min(strength, end.last.strength_left), stiffness = std::min(stiffness, end.last.stiffness_left);
    }
    sections.push_back({{"name", frame.sections[s].name},
                        {"yield_moment_N_m", frame.sections[s].inelastic->yield_moment},
                        {"yielded_ends", yielded},
                        {"peak_moment_N_m", moment},
                        {"peak_ductility", ductility},
                        {"peak_plastic_rotation_rad", rotation},
                        {"strength_left", strength},
                        {"stiffness_left", stiffness}});
  }
  return {{"sections", sections}, {"assumed", frame.assumed}};
}

} // namespace rimpact::buildings
