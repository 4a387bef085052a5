// rimpact list: what there is to choose from.
#include "app/verb.h"
#include "files/json_text.h"
#include "reduced_models/catalogue.h"
#include "reduced_models/impact_law.h"
#include "scene/scene.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace rimpact::app {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

Entries bearings() {
  Entries result;
  for (const auto &name : scene::builtin_bearing_names()) {
    const auto b = scene::builtin_bearing(name);
    const double curvature = scene::make_surface(b.surface)->curvatures(0).meridional;
    result.emplace_back(name, fmt::format("{} surface, R0 {:.3g} m, L_c {:.0f} mm", b.surface.kind, 1 / curvature,
                                          1e3 * b.lateral_capacity()));
  }
  return result;
}
/// First sentence of the comment a scene's text begins with ("Fig. 2-7" does not end it).
std::string first_sentence(const std::string &text) {
  std::string sentence, line;
  for (std::istringstream lines(text); std::getline(lines, line) && line.rfind("# ", 0) == 0;) {
    if (!sentence.empty()) sentence += ' ';
    sentence.append(line, 2);
  }
  for (std::size_t end = 0; (end = sentence.find(". ", end)) != std::string::npos; ++end)
    if (!std::isdigit(static_cast<unsigned char>(sentence[end + 2]))) return sentence.substr(0, end + 1);
  return sentence;
}
Entries scenes() {
  Entries result;
  for (const auto &name : scene::builtin_scene_names())
    result.emplace_back(name, first_sentence(scene::builtin_scene_text(name)));
  return result;
}
Entries models() {
  Entries result;
  for (const auto &model : reduced::reduced_models()) result.emplace_back(model.name, model.description);
  return result;
}
Entries laws() {
  Entries result;
  for (const auto &law : reduced::impact_laws()) result.emplace_back(law.name, law.description);
  return result;
}
Entries materials() {
  Entries result;
  const scene::Bearing b;
  for (const auto &[name, m] : {std::pair{"steel", b.steel}, {"ertalyte", b.ertalyte}})
    result.emplace_back(name, fmt::format("E {:.0f} MPa, nu {:.2f}, {}, {:.0f} kg/m3", 1e-6 * m.E, m.nu,
                                          m.yield ? fmt::format("yield {:.0f} MPa, tangent {:.0f} MPa", 1e-6 * *m.yield,
                                                                1e-6 * m.tangent_modulus.value_or(0))
                                                  : std::string("elastic"),
                                          m.density));
  return result;
}

} // namespace

void add_list(CLI::App &app, Console &console) {
  auto *verb = app.add_subcommand("list", "bearings, scenes, models, laws, materials");
  auto what = std::make_shared<std::string>();
  verb->add_option("WHAT", *what, "one of them; all without")
      ->check(CLI::IsMember({"bearings", "scenes", "models", "laws", "materials"}));
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([what, &console] {
    const std::pair<const char *, Entries (*)()> kinds[] = {
        {"bearings", bearings}, {"scenes", scenes}, {"models", models}, {"laws", laws}, {"materials", materials}};
    nlohmann::ordered_json all;
    for (const auto &[kind, entries] : kinds) {
      if (!what->empty() && *what != kind) continue;
      if (!console.json) console.data(fmt::format("{}\n", kind));
      for (const auto &[name, text] : entries()) {
        all[kind][name] = text;
        if (!console.json) console.data(fmt::format("  {:24s} {}\n", name, text));
      }
    }
    if (console.json) console.data(json_text(all));
  });
}

} // namespace rimpact::app
