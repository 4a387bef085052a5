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

/// Keys of a section's element that its law reads, without what is known of its fit.
std::vector<KeyEntry> element_of(const Scene &scene, const laws::ImpactLaw &law, const std::string &section) {
  KeyList list;
  Scene copy = scene;
  visit_settings(list, copy);
  const auto &names = element_keys();
  const auto is_of_it = [&](const KeyEntry &entry) {
    const std::string name = entry.key.name;
    if (entry.section != section || !entry.is_number || name.starts_with("fitted_")) return false;
    if (name == "restitution" && !law.reads("e")) return false; // it yields by itself
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::erase_if(list.entries, [&](const KeyEntry &entry) { return !is_of_it(entry); });
  return list.entries;
}

std::string numbers_of(const Scene &scene, const ImpactElement &element, const std::string &section) {
  std::string text = fmt::format("k_i = {:.6g} kN/m", element.k_i / 1e3);
  for (const auto &entry : element_of(scene, *element.impact_law, section)) {
    const std::string name = entry.key.name;
    if (name == "k_i_kN_per_m") continue;
    text += fmt::format(", {} = {:.4g}", name == "restitution" ? "e" : name, std::stod(entry.value));
  }
  return text;
}

std::string doubt_of_mass(const ImpactElement &element, double mass) {
  if (!element.fitted_mass || element.k_i == 0 || element.impact_law->pushed || within(mass, *element.fitted_mass))
    return {};
  return fmt::format("k_i and e of law {} hold for the {:g} kg they were fitted with, not for load.mass_kg = {:g}: a "
                     "dashpot stands for the rim's yielding at one mass only; take a law of the rim (calibrate --law "
                     "elastoplastic)",
                     element.impact_law->name, *element.fitted_mass, mass);
}

/// To the law of a rim of [isolator].
std::string way_to_its_law(ModelKind model) {
  if (model == ModelKind::tfp)
    return "give those of its rims, or calibrate a bearing of each stop, such as tfp-kim-2023-outer and "
           "tfp-kim-2023-inner, and pass --calibration DIR --inner-calibration DIR";
  return "give those of one of its rims, or calibrate the same bearing in [bearing], surface.concave = \"double\", and "
         "pass --calibration DIR";
}

/// Of a law of two dishes' rims on the plates of a DCFP or LIR-DCFP, whatever moves it: cycles may reach its rims.
std::string doubt_of_plates(const Scene &scene) {
  if (!scene.rigid_bodies() || scene.triple()) return {};
  const std::string other = plate_differences(scene.reduced.fitted_plates, scene.isolator);
  return other.empty() ? ""
                       : "the impact element was fitted between other plates: " + other +
                             "; calibrate a bearing with the numbers of [isolator] and pass --calibration DIR";
}

/// Numbers that nobody gave, of another bearing or mass.
std::string doubt_of_defaults(const Scene &scene) {
  const auto &r = scene.reduced;
  if (r.k_i == 0 || r.impact_law->pushed || !r.calibration.empty() || !has_default_element(scene) ||
      published_pair_applies(scene))
    return {};
  const bool two_dishes = scene.rigid_bodies();
  const bool other_rim = two_dishes || rim_identity(scene.bearing) != rim_identity(builtin_bearing("shfps-225"));
  return fmt::format("{} are {} for shfps-225 and {:g} kg, not this {}'s: impact forces may be several times off; {}",
                     numbers_of_element(scene), r.impact_law->of_mass ? "the thesis's" : "defaults of the law",
                     Load{}.mass,
                     two_dishes  ? "isolator"
                     : other_rim ? "bearing"
                                 : "mass",
                     two_dishes ? way_to_its_law(r.model) : "calibrate and pass --calibration DIR");
}

std::string doubt_of_rim(const Scene &scene) {
  const auto &r = scene.reduced;
  if (r.k_i == 0 || r.impact_law->pushed || r.fitted_rim.empty()) return {};
  if (scene.rigid_bodies())
    return fmt::format("the impact element was fitted to another rim, that of a bearing of one dish: reduced.model "
                       "\"{}\" has the rims of [isolator]",
                       word(r.model));
  if (r.fitted_rim == rim_identity(scene.bearing)) return {};
  return "the impact element was fitted to another rim: dish, slider, rim, plate and steel shape it; calibrate this "
         "bearing and pass --calibration DIR";
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
  const laws::ImpactLaw &law = *scene.reduced.impact_law;
  const auto own = element_of(scene, law, reduced_section), defaults = element_of(untouched, law, reduced_section);
  return std::equal(own.begin(), own.end(), defaults.begin(), defaults.end(),
                    [](const KeyEntry &a, const KeyEntry &b) { return a.path() == b.path() && a.value == b.value; });
}

std::string numbers_of_element(const Scene &scene) {
  return numbers_of(scene, scene.reduced, reduced_section);
}

std::string numbers_of_inner_element(const Scene &scene) {
  return numbers_of(scene, scene.isolator.inner.rims, inner_rims_section);
}

std::vector<std::string> doubts_of_element(const Scene &scene) {
  std::vector<std::string> found;
  if (std::string plates = doubt_of_plates(scene); !plates.empty()) found.push_back(std::move(plates));
  if (scene.excitation.stays_on_dish()) return found;
  for (auto *of : {&doubt_of_defaults, &doubt_of_rim})
    if (std::string doubt = of(scene); !doubt.empty()) found.push_back(std::move(doubt));
  for (const auto *element : {static_cast<const ImpactElement *>(&scene.reduced), &scene.inner_element()}) {
    std::string doubt = doubt_of_mass(*element, scene.load.mass);
    if (!doubt.empty() && std::find(found.begin(), found.end(), doubt) == found.end())
      found.push_back(std::move(doubt));
  }
  return found;
}

} // namespace rimpact::scene
