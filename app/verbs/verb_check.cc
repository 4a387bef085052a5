// rimpact check SCENE: geometry, scout and plan; solves nothing.
#include "app/jobs/mesh_check.h"
#include "app/verbs/catalogue.h"
#include "fe_contact/planning/plan.h"
#include "fe_contact/planning/refusal.h"
#include "io/files/error.h"
#include "io/files/json_text.h"
#include "responses/identity.h"
#include "scene/case_description.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include "scene/rim_identity.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

/// Doubts that need the scout: the element, where the rim is touched, and speeds that no bearing reaches.
void warn_of_impacts(const scene::Scene &scene, const planning::Plan &plan, Console &console) {
  if (!plan.rim_takes_part) return;
  for (const auto &doubt : scene::doubts_of_element(scene)) console.warn(doubt);
  constexpr double fastest = 10; // [m/s]
  const auto faster = [](const auto &a, const auto &b) { return a.approach_speed < b.approach_speed; };
  const auto worst = std::max_element(plan.impacts.begin(), plan.impacts.end(), faster);
  if (worst != plan.impacts.end() && worst->approach_speed > fastest &&
      scene.excitation.kind != scene::ExcitationKind::window)
    console.warn(fmt::format("the scout sees the rim met at {:.3g} m/s: no bearing meets its rim faster than {:g} m/s; "
                             "is the motion's unit right (amplitude_g is "
                             "in g, not in m/s2)?",
                             worst->approach_speed, fastest));
}

std::string sentence_of(const std::vector<scene::Assumption> &assumed) {
  if (assumed.empty()) return "assumed, not measured: nothing, every number is given\n";
  std::string text = "assumed, not measured:";
  for (const auto &item : assumed) text += fmt::format(" {} = {};", item.key, item.value);
  return text + "\n";
}

nlohmann::json table_of(const scene::Scene &scene, const planning::Plan &plan, const MeshCheck &own,
                        const std::optional<std::string> &refusal, const Console &console) {
  nlohmann::json table = planning::to_json(plan);
  table["scene"] = scene.name;
  table["bearing"] = scene.bearing.name;
  table["rim_identity"] = scene::rim_identity(scene.bearing);
  table["lateral_capacity_m"] = scene.bearing.lateral_capacity();
  table["rung"] = word(scene.model.rung);
  table["identity"] = to_json(identity_of(scene));
  table.update(scene::case_json(scene));
  table["assumptions"] = nlohmann::json::object();
  for (const auto &item : scene::assumptions(scene.bearing)) table["assumptions"][item.key] = item.value;
  if (const auto &foot = scene.bearing.rim.connection; !scene.rigid_bodies())
    table["rim_foot"] = {{"connection", word(foot.kind)}, {"in_words", in_words(foot)}};
  table["warnings"] = console.warnings();
  if (!own.table.is_null()) table["own_mesh"] = own.table;
  table["refusal"] = refusal ? nlohmann::json(*refusal) : nlohmann::json(nullptr);
  return table;
}

std::string text_of(const scene::Scene &scene, const planning::Plan &plan, const MeshCheck &own) {
  return fmt::format("{}: lift at L_c {:.2f} mm; geometry can be built and nothing collides\n", scene.name,
                     1e3 * scene::lift(scene.bearing, scene.bearing.lateral_capacity())) +
         scene::describe_case(scene) + own.sentence + planning::describe(plan) +
         (scene.rigid_bodies() ? "" : scene::foot_sentence(scene.bearing)) +
         sentence_of(scene::assumptions(scene.bearing));
}

void add_check(CLI::App &verb, Console &console) {
  auto where = std::make_shared<std::string>();
  verb.add_option("SCENE", *where, "a TOML file or a built-in scene")->required();
  console.add_common(verb);
  console.add_json(verb);
  console.add_overrides(verb);
  console.add_model(verb);
  verb.callback([where, &console] {
    const scene::Scene scene = console.load(*where);
    if (const auto reason = planning::beyond_rungs(scene)) throw InputError(*reason);
    const planning::Plan plan = planning::make_plan(scene);
    const auto refusal = planning::refusal(scene);
    MeshCheck own;
    if (scene.model.own_mesh.any() && !refusal) own = check_own_mesh(scene, plan, console);
    warn_of_impacts(scene, plan, console); // here, as the light program hands own meshes over and is run again
    console.data(console.json ? json_text(table_of(scene, plan, own, refusal, console)) : text_of(scene, plan, own));
    if (refusal) throw InputError("`run` would refuse: " + *refusal);
  });
}

} // namespace

const Verb check_verb{
    {.name = "check",
     .help = "geometry, the scout's result and the plan; solves nothing",
     .examples = "rimpact check my-case/scene.toml\nrimpact check ricker-0.78g-1.0s --rung rigid-dish --json",
     .next = "rimpact reduced SCENE (milliseconds), then rimpact run SCENE"},
    add_check};

} // namespace rimpact::app
