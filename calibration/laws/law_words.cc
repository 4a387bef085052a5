#include "calibration/laws/law_words.h"
#include "calibration/fit/parameter.h"
#include "laws/impact/catalogue.h"
#include <fmt/format.h>

namespace rimpact::calibration {

bool belongs_to_mass(const scene::ReducedSettings &settings) {
  constexpr laws::RimMotion approaching{.d = 1e-3, .rate = 0.1, .speed = 0.1, .deepest = 0};
  constexpr double light = 1e4, heavy = 1e6; // [kg]
  return settings.element(light).at(approaching).force != settings.element(heavy).at(approaching).force;
}

std::string numbers_in_words(const scene::Scene &scene) {
  std::string text;
  const laws::ImpactLaw &law = *scene.reduced.impact_law;
  for (const auto *names : {&law.parameters, &law.exponents})
    for (const auto &name : *names) {
      const auto &p = parameter(name);
      text += fmt::format("{}{} = {:.5g}{}", text.empty() ? "" : ", ", name, p.get(scene) / p.si, unit_behind(p.unit));
    }
  return text;
}

std::string law_in_words(const scene::Scene &scene) {
  const auto &r = scene.reduced;
  if (belongs_to_mass(r))
    return fmt::format("the constant pair {} of law {}, for a supported mass of {:.6g} kg,", numbers_in_words(scene),
                       r.impact_law->name, scene.load.mass);
  return fmt::format("the law {} ({})", r.impact_law->name, numbers_in_words(scene));
}

std::string held_in_words(const std::vector<std::string> &exponents, const scene::Scene &scene, const std::string &law,
                          const std::string &why) {
  if (exponents.empty()) return {};
  std::string text;
  for (const auto &name : exponents) {
    const auto &p = parameter(name);
    text += fmt::format("{}{} at {:g}", text.empty() ? "" : " and ", name, p.get(scene) / p.si);
  }
  return fmt::format("{}: held {}, {}.", law, text, why);
}

} // namespace rimpact::calibration
