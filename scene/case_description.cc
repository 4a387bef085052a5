#include "scene/case_description.h"
#include "io/files/json_text.h"

#include "io/files/key_list.h"
#include "scene/assumptions.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include "scene/keys.h"
#include "scene/scene_keys.h"
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

using nlohmann::json;

/// Keys of [excitation] that its kind reads, "kind" first.
std::vector<KeyEntry> motion_of(const Scene &scene) {
  KeyList list;
  Scene copy = scene;
  visit_settings(list, copy);
  std::erase_if(list.entries, [](const KeyEntry &entry) { return entry.section != "excitation"; });
  return list.entries;
}

std::string plain(std::string value) {
  if (value.ends_with(".0")) value.resize(value.size() - 2);
  if (value.size() >= 2 && value.front() == '"') value = value.substr(1, value.size() - 2);
  return value;
}

std::string motion_line(const Scene &scene) {
  std::string text;
  for (const auto &entry : motion_of(scene))
    text += text.empty() ? plain(entry.value) : fmt::format(", {} {}", entry.key.name, plain(entry.value));
  return text;
}

std::string bearing_line(const Scene &scene) {
  if (scene.rigid_bodies())
    return fmt::format("{}, C_t = {:.1f} mm, R_eff = {:.3f} m", scene.bearing_name(), 1e3 * scene.lateral_capacity(),
                       scene.isolator.effective_radius());
  return fmt::format("{}, L_c = {:.1f} mm, {}", scene.bearing.name, 1e3 * scene.bearing.lateral_capacity(),
                     rim_in_words(scene.bearing));
}

std::string load_line(const Scene &scene) {
  const Load &l = scene.load;
  const bool is_thesis = l.vertical == Load{}.vertical && l.mass == Load{}.mass;
  return fmt::format("W = {:.6g} kN, m = {:.6g} kg (W = {:.3g} m g){}", l.vertical / 1e3, l.mass,
                     l.vertical / (l.mass * l.gravity),
                     !load_is_assumed(scene) ? ""
                     : is_thesis             ? ", the thesis's: none is given, an assumption"
                                             : ", an assumption");
}

std::string source_of(const Scene &scene) {
  const auto &r = scene.reduced;
  if (r.impact_law->pushed) return "the curve " + r.impact_curve;
  if (!r.calibration.empty()) return "calibration " + r.calibration;
  if (!has_default_element(scene)) return "the scene";
  return r.impact_law->of_mass ? "the thesis's pair for shfps-225" : "defaults of the law, for shfps-225";
}

std::string range_of(const ImpactElement &r, const std::string &joint) {
  std::string text;
  if (r.fitted_from && r.fitted_to) text += fmt::format("; fitted from {:g} to {:g} m/s", *r.fitted_from, *r.fitted_to);
  if (r.fitted_speeds_mass) text += fmt::format(" under {:g} kg", *r.fitted_speeds_mass);
  if (r.foot_force && r.foot_joint == joint)
    text += fmt::format("; ends at {:.4g} kN, where the rim's foot goes", *r.foot_force / 1e3);
  if (r.fitted_mass) text += fmt::format("; for {:g} kg only", *r.fitted_mass);
  return text;
}

} // namespace

std::string joint_at_foot(const Scene &scene) {
  return scene.rigid_bodies() ? scene.reduced.foot_joint : strength_in_words(scene.bearing.rim.connection);
}

std::string rim_in_words(const Bearing &bearing) {
  return fmt::format("rim {:.4g} mm high, {:.4g} mm thick", 1e3 * bearing.rim.height, 1e3 * bearing.rim.thickness);
}

std::string element_line(const Scene &scene) {
  if (scene.reduced.k_i == 0) return "none (k_i = 0)";
  if (scene.reduced.impact_law->pushed) return "curve, " + scene.reduced.impact_curve;
  return fmt::format("{}, {} ({}{})", scene.reduced.impact_law->name, numbers_of_element(scene), source_of(scene),
                     range_of(scene.reduced, joint_at_foot(scene)));
}

std::string inner_element_line(const Scene &scene) {
  const ImpactElement &inner = scene.inner_element();
  if (&inner == &scene.reduced) return {};
  if (inner.k_i == 0) return "none (k_i = 0)";
  return fmt::format("{}, {} ({}{})", inner.impact_law->name, numbers_of_inner_element(scene),
                     inner.calibration.empty() ? "the scene" : "calibration " + inner.calibration,
                     range_of(inner, inner.foot_joint));
}

std::string load_sentence(const Scene &scene) {
  return "load: " + load_line(scene) + "\n";
}

std::string foot_sentence(const Bearing &bearing) {
  const RimConnection &c = bearing.rim.connection;
  const std::string held = fmt::format("rim's foot: {}", in_words(c));
  if (c.kind != ConnectionKind::monolithic) return held + ", judged after every finite-element run\n";
  return held + ", assumed by solids and laws alike; welds or bolts are to be named in bearing.rim.connection\n";
}

std::string describe_case(const Scene &scene, bool load_is_read) {
  const std::string inner = inner_element_line(scene);
  return fmt::format("bearing: {}\n{}motion: {}\nimpact element: {}\n{}", bearing_line(scene),
                     load_is_read ? load_sentence(scene) : "", motion_line(scene), element_line(scene),
                     inner.empty() ? "" : "of the inner rims: " + inner + "\n");
}

json case_json(const Scene &scene) {
  const auto &r = scene.reduced;
  json motion = json::object();
  for (const auto &entry : motion_of(scene)) {
    const json value =
        json::parse(entry.value, nullptr, false); // numbers, words and lists are written alike in TOML and JSON
    motion[entry.key.name] = value.is_discarded() ? json(entry.value) : value;
  }
  return {{"load",
           {{"vertical_kN", scene.load.vertical / 1e3},
            {"mass_kg", scene.load.mass},
            {"gravity_m_per_s2", scene.load.gravity},
            {"assumed", load_is_assumed(scene)}}},
          {"motion", motion},
          {"impact_element",
           {{"law", r.impact_law->name},
            {"k_i_kN_per_m", r.k_i / 1e3},
            {"e", r.impact_law->reads("e") ? json(r.restitution) : json(nullptr)},
            {"sentence", element_line(scene)},
            {"source", source_of(scene)},
            {"fitted_from_m_per_s", or_null(r.fitted_from)},
            {"fitted_to_m_per_s", or_null(r.fitted_to)},
            {"fitted_mass_kg", or_null(r.fitted_mass)},
            {"fitted_speeds_mass_kg", or_null(r.fitted_speeds_mass)},
            {"foot_force_kN", r.foot_force ? json(*r.foot_force / 1e3) : json(nullptr)},
            {"fitted_rim", r.fitted_rim.empty() ? json(nullptr) : json(r.fitted_rim)}}}};
}

} // namespace rimpact::scene
