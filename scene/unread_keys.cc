#include "scene/unread_keys.h"
#include "io/files/key_list.h"
#include "io/files/path_visitor.h"
#include "scene/bearing_keys.h"
#include "scene/face_friction.h"
#include "scene/keys.h"
#include "scene/scene_keys.h"
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace rimpact::scene {
namespace {

/// Of which a part of the scene depends. The choices that are always named are those of its settings.
struct ScenePart {
  const char *prefix, *choice;
  bool always_named = false;
};
constexpr std::array parts{ScenePart{"excitation.", "excitation.kind", true},
                           ScenePart{"isolator.inner.rims.", "isolator.inner.own_rims"},
                           ScenePart{"isolator.", "reduced.model", true},
                           ScenePart{"reduced.elastic_slip_mm", "reduced.friction"},
                           ScenePart{"reduced.rate_s_per_m", "reduced.mu_slow"},
                           ScenePart{"reduced.mu_fast", "reduced.mu_table"},
                           ScenePart{"reduced.mu_slow", "reduced.mu_table"},
                           ScenePart{"reduced.temperature_C", "reduced.mu_by_temperature"},
                           ScenePart{"reduced.conductivity_W_per_m_K", "reduced.mu_by_temperature"},
                           ScenePart{"reduced.diffusivity_mm2_per_s", "reduced.mu_by_temperature"},
                           ScenePart{"reduced.contact_radius_mm", "reduced.mu_by_temperature"},
                           ScenePart{"reduced.", "reduced.impact_law", true},
                           ScenePart{"superstructure.", "superstructure.kind", true},
                           ScenePart{"bounds.", "bounds.standard"},
                           ScenePart{"bearing.surface.", "bearing.surface.kind"},
                           ScenePart{"bearing.slider.interface_gap_mm", "bearing.slider.mu_interface"},
                           ScenePart{"bearing.slider.", "bearing.surface.concave"},
                           ScenePart{"bearing.pad.", "bearing.surface.concave"},
                           ScenePart{"bearing.foot.", "bearing.surface.concave"},
                           ScenePart{"bearing.material.steel.rate_", "bearing.material.steel.rate"},
                           ScenePart{"bearing.material.steel.softening_", "bearing.material.steel.softening"},
                           ScenePart{"bearing.material.steel.taylor_quinney", "bearing.material.steel.softening"},
                           ScenePart{"bearing.material.steel.heat_", "bearing.material.steel.softening"},
                           ScenePart{"bearing.material.steel.melting_K", "bearing.material.steel.softening"},
                           ScenePart{"bearing.material.steel.hardening_", "bearing.material.steel.hardening"},
                           ScenePart{"bearing.material.steel.curve", "bearing.material.steel.hardening"},
                           ScenePart{"bearing.material.steel.tangent_modulus_MPa", "bearing.material.steel.hardening"},
                           ScenePart{"bearing.material.steel.", "bearing.material.steel.yield_MPa"},
                           ScenePart{"bearing.material.ertalyte.", "bearing.material.ertalyte.yield_MPa"},
                           ScenePart{"bearing.rim.connection.", "bearing.rim.connection.kind"},
                           ScenePart{"bearing.contact.rate_s_per_m", "bearing.contact.rim_slow"},
                           ScenePart{"bearing.contact.", "bearing.contact.pad_foot"},
                           ScenePart{"model.own_mesh.", "model.own_mesh.file"}};

const std::string base_steel = "bearing.material.steel.";

/// "bearing.material.rim." of a key of a part's steel; empty: it is of none.
std::string part_table(const std::string &path) {
  for (const auto &part : words<SteelPart>())
    if (std::string table = "bearing.material." + part + "."; path.starts_with(table)) return table;
  return {};
}

/// Of a part's steel as of the bearing's own: "bearing.material.rim.rate" as "bearing.material.steel.rate".
std::string of_the_bearings_steel(const std::string &path) {
  const std::string table = part_table(path);
  return table.empty() ? path : base_steel + path.substr(table.size());
}

const ScenePart *part_of(const std::string &key) {
  const std::string path = of_the_bearings_steel(key);
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const ScenePart &part) { return path.starts_with(part.prefix); });
  return found == parts.end() ? nullptr : &*found;
}

/// The choice that a key hangs on: of a part's steel that part's own.
std::string choice_of(const std::string &key) {
  const std::string choice = part_of(key)->choice, table = part_table(key);
  return table.empty() || !choice.starts_with(base_steel) ? choice : table + choice.substr(base_steel.size());
}

/// Of [isolator] what a dish may stand on, in a building whose steps are implicit.
bool is_of_springs(const std::string &path) {
  constexpr std::array keys{"isolator.points", "isolator.contact_stiffness_kN_per_m", "isolator.contact_restitution",
                            "isolator.step_tolerance"};
  return std::find(keys.begin(), keys.end(), path) != keys.end();
}

UnreadPart remark_of(const std::string &path, const Scene &scene) {
  if (scene.rigid_bodies() || !path.starts_with("isolator.")) return UnreadPart::scene;
  return is_of_springs(path) ? UnreadPart::springs : UnreadPart::isolator;
}

/// Keys that are written out with every scene, though by its other choices nothing reads them.
bool has_no_effect(const std::string &path, const Scene &scene) {
  const auto &r = scene.reduced;
  const auto faces = face_coefficients(scene);
  const bool one_coefficient =
      std::all_of(faces.begin(), faces.end(), [](const FaceCoefficients &face) { return face.slow == face.fast; });
  const bool by_table = path == "reduced.mu_fast" || path == "reduced.mu_slow" || path == "reduced.rate_s_per_m";
  return (by_table && r.measured.table) || (path == "reduced.contact_radius_mm" && !r.measured.any()) ||
         (path == "reduced.elastic_slip_mm" && r.friction == Friction::coulomb) ||
         (path == "reduced.rate_s_per_m" && one_coefficient) ||
         (path.starts_with("isolator.") && !scene.rigid_bodies());
}

/// Keys that are read before the settings are, and leave numbers in other keys.
bool is_read_before(const std::string &path) {
  constexpr std::array keys{"reduced.calibration", "isolator.inner.rims.calibration", "bearing.surface.file",
                            "bearing.material.steel.grade", "bearing.material.steel.hardness_HB"};
  return std::find(keys.begin(), keys.end(), of_the_bearings_steel(path)) != keys.end();
}

void visit_all(KeyVisitor &visitor, Scene &scene) {
  visitor.section("bearing", [&] { visit(visitor, scene.bearing); });
  visit_settings(visitor, scene);
}

/// The names alone of the keys that matter: values as text would cost a fleet's run a tenth of its time.
class NamesRead final : public PathVisitor {
public:
  std::set<std::string> names;

  void number(const Key &key, double &, Unit, Range) override { add(key); }
  void limit(const Key &key, std::optional<double> &, Unit, Range) override { add(key); }
  void integer(const Key &key, int &, int, int) override { add(key); }
  void flag(const Key &key, bool &) override { add(key); }
  void text(const Key &key, std::string &) override { add(key); }
  void word(const Key &key, std::string &, const std::vector<std::string> &) override { add(key); }
  void pair(const Key &key, Eigen::Vector2d &, Range) override { add(key); }
  void numbers(const Key &key, std::vector<double> &, Unit, Range) override { add(key); }
  void rows(const Key &key, Rows &, const std::array<Column, 2> &) override { add(key); }
  void switches(const Key &key, const std::vector<std::pair<std::string, bool *>> &) override { add(key); }

private:
  void add(const Key &key) { names.insert(path(key)); }
};

std::map<std::string, std::string> values_of(Scene scene) {
  KeyList list("", true);
  visit_all(list, scene);
  std::map<std::string, std::string> values;
  for (const auto &entry : list.entries) values[entry.path()] = entry.value;
  return values;
}

/// The choices by which the keys are not read: those of the settings, and what else they depend on.
std::string choices_in_words(const std::vector<std::string> &unread, const std::map<std::string, std::string> &values) {
  std::set<std::string> others;
  for (const auto &path : unread)
    if (!part_of(path)->always_named) others.insert(choice_of(path));
  if (others.count(own_rims_key) > 0) others.insert(inner_rims_section + ".impact_law");
  std::string text;
  const auto name = [&](const std::string &choice) {
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", choice, text.empty() ? "is " : "", values.at(choice));
  };
  for (const char *choice : {"excitation.kind", "reduced.model", "reduced.impact_law", "superstructure.kind"})
    name(choice);
  for (const auto &choice : others) name(choice);
  return text;
}

} // namespace

std::string unread_keys(const TomlFile &file, const Scene &scene, UnreadPart wanted) {
  NamesRead read;
  Scene copy = scene;
  visit_all(read, copy);
  static const auto presets = values_of({});
  std::vector<std::string> unread;
  for (const auto &[path, preset] : presets) {
    const ScenePart *part = part_of(path);
    if (!part || !file.find(path) || remark_of(path, scene) != wanted) continue;
    if (read.names.count(path) > 0 && !has_no_effect(path, scene)) continue;
    if (is_read_before(path)) continue;
    if (file.is_set(path) || !file.is_set(choice_of(path))) unread.push_back(path);
  }
  if (unread.empty()) return {};
  const auto values = values_of(scene);
  const auto at_default = [&](const std::string &path) { // a slope past no yield has been taken out of the scene
    if (path.ends_with("tangent_modulus_MPa")) return file.find(path)->value<double>().value_or(0) > huge;
    return values.at(path) == presets.at(path);
  };
  std::erase_if(unread, at_default);
  if (unread.empty()) return {};
  return fmt::format("{} {} not read by this scene: {}", fmt::join(unread, ", "), unread.size() > 1 ? "are" : "is",
                     choices_in_words(unread, values));
}

} // namespace rimpact::scene
