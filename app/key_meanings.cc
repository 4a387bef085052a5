#include "app/key_meanings.h"

#include <map>

namespace rimpact::app {
namespace {

using Words = std::map<std::string, const char *>;

std::string word_for(const Words &words, const std::string &path) {
  const auto found = words.find(path);
  return found == words.end() ? "" : found->second;
}

} // namespace

std::string meaning_of(const std::string &path) {
  static const Words words{
      {"bearing.surface.c3_per_m2", "coefficient of r^3"},
      {"bearing.surface.c4_per_m3", "coefficient of r^4"},
      {"bearing.surface.c5_per_m4", "coefficient of r^5"},
      {"bearing.surface.c6_per_m5", "coefficient of r^6"},
      {"bearing.surface.kind", "form of the sliding surface"},
      {"bearing.slider.diameter_mm", "of the upper slider; what meets the rim"},
      {"bearing.rim.thickness_mm", "radial thickness of the rim"},
      {"bearing.pad.inner_radius_mm", "of the ring-shaped pad; 0: a full disc"},
      {"bearing.pad.outer_radius_mm", "of the pad"},
      {"bearing.pad.thickness_mm", "of the pad"},
      {"bearing.pad.shape_radius_mm", "radius of the pad's sliding face"},
      {"bearing.foot.radius_mm", "of the foot below its cap"},
      {"bearing.material.steel.density_kg_per_m3", "of the steel"},
      {"bearing.material.rim.density_kg_per_m3", "of the rim's steel"},
      {"bearing.material.dish.density_kg_per_m3", "of the plate's steel"},
      {"bearing.material.slider.density_kg_per_m3", "of the slider's and the foot's steel"},
      {"bearing.material.ertalyte.density_kg_per_m3", "of the pad's Ertalyte"},
      {"bearing.contact.steel_steel", "friction of the socket on the foot's cap"},
      {"bearing.contact.steel_ertalyte", "friction of the pad on the dish"},
      {"bearing.contact.rim", "friction of the slider on the rim"},
      {"bearing.contact.pad_foot", "how the pad sits in the foot"},
      {"load.vertical_kN", "dead load W"},
      {"load.gravity_m_per_s2", "acceleration of gravity; records in g are multiplied by it"},
      {"excitation.kind", "what moves the bearing"},
      {"excitation.period_s", "T_p of the Ricker pulse"},
      {"excitation.amplitude_m", "of the prescribed displacement"},
      {"excitation.travel_mm", "of the push, beyond touch"},
      {"excitation.direction_deg", "of motion, push or impact, in the plane, from x"},
      {"excitation.x",
       "record along x: a file of any form (FILE#2: its second channel), or a built-in one; empty: no motion"},
      {"excitation.y", "record along y"},
      {"excitation.z", "record along z"},
      {"excitation.displacement_m", "initial displacement x, y"},
      {"excitation.velocity_m_per_s", "initial velocity x, y"},
      {"excitation.duration_s", "of the motion and of the run"},
      {"model.rung", "which parts deform by finite elements"},
      {"model.mesh", "fineness, cells 1.5 times smaller a level; 0: a draft"},
      {"model.symmetry", "half: the motion is along x; auto: decided by the plan"},
      {"reduced.model", "a reduced model of `rimpact list models`"},
      {"reduced.restitution", "e of the impact element"},
      {"reduced.impact_law", "law of the rim, see laws"},
      {"reduced.friction", "law of friction; park-wen has an elastic slip"},
      {"reduced.mu_fast", "coefficient of friction at speed"},
      {"reduced.mu_slow", "coefficient of friction at rest"},
      {"reduced.integrator", "own steps, or SUNDIALS CVODE as a check of them for one dish: the difference is printed"},
      {"reduced.normal_force",
       "inertia: with vertical inertia; static: by the slope; constant: W; pad: by the pad's spring"},
      {"isolator.space", "motion in a plane or in space"},
      {"superstructure.kind", "what the bearing carries"},
      {"superstructure.storeys", "number of floors above the base"},
      {"model.own_mesh.groups.plate", "name of the file's volume"},
  };
  const std::string own = word_for(words, path);
  if (!own.empty() || !path.starts_with("model.own_mesh.groups.")) return own;
  return "name in the file of what the built-in mesh calls " + path.substr(path.rfind('.') + 1);
}

std::string preset_by_hand(const std::string &path) {
  static const Words words{{"excitation.centre_s", "2 period_s; of a window 0"},
                           {"excitation.duration_s", "2 period_s + 6; of a window 0.2; of a record its length"},
                           {"load.mass_kg", "W / g where vertical_kN is given, else 86952"},
                           {"load.vertical_kN", "m g where mass_kg is given, else 853"},
                           {"reduced.mu_fast", "bearing.contact.steel_ertalyte"},
                           {"reduced.mu_slow", "mu_fast"},
                           {"isolator.points", "2; in space 8"}};
  return word_for(words, path);
}

std::string further_condition(const std::string &path) {
  static const Words words{{"isolator.points", ", or dishes of a building stand on springs"},
                           {"isolator.contact_stiffness_kN_per_m", ", or dishes of a building stand on springs"},
                           {"isolator.contact_restitution", ", or dishes of a building stand on springs"},
                           {"isolator.step_tolerance", ", or dishes of a building stand on springs"}};
  return word_for(words, path);
}

std::string conditions_by_hand(const std::string &path) {
  if (path.starts_with("model.own_mesh.groups.")) return "the file's groups have other names";
  if (path.starts_with("model.own_mesh.")) return "model.own_mesh.file is given";
  return "it is given";
}

} // namespace rimpact::app
