#include "scene/element_doubts.h"

#include "io/files/key_list.h"
#include "scene/bearing_catalogue.h"
#include "scene/calibrated_element.h"
#include "scene/keys.h"
#include "scene/rim_identity.h"
#include "scene/scene_keys.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

constexpr double same_mass = 0.01; // of the mass: k_i and e move by less than half of it

bool within(double a, double b) {
  return std::abs(a / b - 1) <= same_mass;
}

/// Keys of the element that the scene's law reads, without what is known of its fit.
std::vector<KeyEntry> element_of(const Scene &scene) {
  KeyList list;
  Scene copy = scene;
  visit_settings(list, copy);
  const auto &names = element_keys();
  const auto is_of_it = [&](const KeyEntry &entry) {
    const std::string name = entry.key.name;
    if (entry.section != "reduced" || !entry.is_number || name.starts_with("fitted_")) return false;
    if (name == "restitution" && !scene.reduced.impact_law->reads("e")) return false; // it yields by itself
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::erase_if(list.entries, [&](const KeyEntry &entry) { return !is_of_it(entry); });
  return list.entries;
}

/// To the law of a rim of [isolator].
std::string way_to_its_law(ModelKind model) {
  const std::string bearing = model == ModelKind::tfp ? "a bearing of its stop, such as tfp-kim-2023-inner,"
                                                      : "the same bearing in [bearing], surface.concave = \"double\",";
  return "give those of one of its rims, or calibrate " + bearing + " and pass --calibration DIR";
}

/// Of a law of two dishes' rims on the plates of a DCFP or LIR-DCFP, whatever moves it: cycles may reach its rims.
std::string doubt_of_plates(const Scene &scene) {
  if (!scene.rigid_bodies() || scene.triple()) return {};
  const std::string other = plate_differences(scene.reduced.fitted_plates, scene.isolator);
  return other.empty() ? ""
                       : "the impact element was fitted between other plates: " + other +
                             "; calibrate a bearing with the numbers of [isolator] and pass --calibration DIR";
}

} // namespace

bool published_pair_applies(const Scene &scene) {
  return !scene.rigid_bodies() && within(scene.load.mass, Load{}.mass) &&
         rim_identity(scene.bearing) == rim_identity(builtin_bearing("shfps-225"));
}

bool has_default_element(const Scene &scene) {
  Scene untouched = scene;
  untouched.reduced = {};
  untouched.reduced.impact_law = scene.reduced.impact_law;
  const auto own = element_of(scene), defaults = element_of(untouched);
  return std::equal(own.begin(), own.end(), defaults.begin(), defaults.end(),
                    [](const KeyEntry &a, const KeyEntry &b) { return a.path() == b.path() && a.value == b.value; });
}

std::string numbers_of_element(const Scene &scene) {
  std::string text = fmt::format("k_i = {:.6g} kN/m", scene.reduced.k_i / 1e3);
  for (const auto &entry : element_of(scene)) {
    const std::string name = entry.key.name;
    if (name == "k_i_kN_per_m") continue;
    text += fmt::format(", {} = {:.4g}", name == "restitution" ? "e" : name, std::stod(entry.value));
  }
  return text;
}

std::vector<std::string> doubts_of_element(const Scene &scene) {
  std::vector<std::string> found;
  const auto &r = scene.reduced;
  if (std::string plates = doubt_of_plates(scene); !plates.empty()) found.push_back(std::move(plates));
  if (r.k_i == 0 || r.impact_law->pushed || scene.excitation.stays_on_dish()) return found;
  const bool two_dishes = scene.rigid_bodies();
  if (has_default_element(scene) && r.calibration.empty() && !published_pair_applies(scene)) {
    const bool other_rim = two_dishes || rim_identity(scene.bearing) != rim_identity(builtin_bearing("shfps-225"));
    found.push_back(fmt::format(
        "{} are {} for shfps-225 and {:g} kg, not this {}'s: impact forces may be several "
        "times off; {}",
        numbers_of_element(scene), r.impact_law->of_mass ? "the thesis's" : "defaults of the law", Load{}.mass,
        two_dishes  ? "isolator"
        : other_rim ? "bearing"
                    : "mass",
        two_dishes ? way_to_its_law(scene.reduced.model) : "calibrate and pass --calibration DIR"));
  }
  if (!r.fitted_rim.empty() && two_dishes)
    found.push_back(fmt::format("the impact element was fitted to another rim, that of a bearing of one dish: "
                                "reduced.model \"{}\" has the rims of [isolator]",
                                word(r.model)));
  else if (!r.fitted_rim.empty() && r.fitted_rim != rim_identity(scene.bearing))
    found.push_back("the impact element was fitted to another rim: dish, slider, rim, plate and steel shape it; "
                    "calibrate this bearing and pass --calibration DIR");
  if (r.fitted_mass && !within(scene.load.mass, *r.fitted_mass))
    found.push_back(fmt::format("k_i and e of law {} hold for the {:g} kg they were fitted with, not for load.mass_kg "
                                "= {:g}: a dashpot stands for the rim's "
                                "yielding at one mass only; take a law of the rim (calibrate --law elastoplastic)",
                                r.impact_law->name, *r.fitted_mass, scene.load.mass));
  return found;
}

} // namespace rimpact::scene
