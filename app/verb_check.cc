// rimpact check SCENE: geometry, scout and plan; solves nothing.
#include "app/mesh_check.h"
#include "app/verb.h"
#include "fe_contact/runner/plan.h"
#include "scene/error.h"
#include <fmt/format.h>

namespace rimpact::app {

void add_check(CLI::App &app, Console &console) {
  auto *verb = app.add_subcommand("check", "geometry, the scout's result and the plan; solves nothing");
  auto where = std::make_shared<std::string>();
  verb->add_option("SCENE", *where, "a TOML file or a built-in scene")->required();
  console.add_common(*verb);
  console.add_json(*verb);
  console.add_overrides(*verb);
  console.add_model(*verb);
  verb->callback([where, &console] {
    const scene::Scene scene = console.load(*where);
    if (const auto reason = fe::beyond_rungs(scene)) throw InputError(*reason);
    const fe::Plan plan = fe::make_plan(scene);
    const auto refusal = fe::refusal(scene);
    MeshCheck own;
    if (scene.model.own_mesh.any() && !refusal) own = check_own_mesh(scene, plan, console);
    const auto judge = [&refusal] {
      if (refusal) throw InputError("`run` would refuse: " + *refusal);
    };
    const auto assumed = scene::assumptions(scene.bearing);
    if (console.json) {
      nlohmann::json table = fe::to_json(plan);
      table["scene"] = scene.name;
      table["bearing"] = scene.bearing.name;
      table["lateral_capacity_m"] = scene.bearing.lateral_capacity();
      table["rung"] = scene.model.rung;
      for (const auto &item : assumed) table["assumptions"][item.key] = item.value;
      if (!own.table.is_null()) table["own_mesh"] = own.table;
      table["refusal"] = refusal ? nlohmann::json(*refusal) : nlohmann::json(nullptr);
      console.data(table.dump(2) + "\n");
      return judge();
    }
    std::string text = fmt::format(
        "{}: bearing {}, L_c = {:.1f} mm, lift there {:.2f} mm; geometry can be built and nothing collides\n",
        scene.name, scene.bearing.name, 1e3 * scene.bearing.lateral_capacity(),
        1e3 * scene::lift(scene.bearing, scene.bearing.lateral_capacity()));
    text += own.sentence + fe::describe(plan);
    text += "assumed, not measured:";
    for (const auto &item : assumed) text += fmt::format(" {} = {};", item.key, item.value);
    console.data(text + "\n");
    judge();
  });
}

} // namespace rimpact::app
