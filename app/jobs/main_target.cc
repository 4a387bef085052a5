#include "app/jobs/main_target.h"

#include "app/words/set_keys.h"
#include "fe_contact/planning/plan.h"
#include "fe_contact/planning/refusal.h"
#include "io/files/error.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

std::string not_of_main(const std::string &key) {
  if (is_in(key, "excitation"))
    return "the motions of main are its own: --speeds and --pulse-speeds choose them, `rimpact run` runs a scene's";
  if (is_of_a_fit(key)) return "a reference run is of no fitted law";
  if (is_in(key, "bounds")) return bounds_are_reduced;
  return key == "name" ? "main names its runs itself; --title stands on the report" : "";
}

} // namespace

const char *const bounds_are_reduced =
    "bounds of friction are run by the reduced model: `rimpact reduced` and `rimpact building` with --bounds";

bool is_of_a_fit(const std::string &key) {
  return key.starts_with("reduced.fitted_") || is_in(key, "reduced.taken_from");
}

void require_bearing_under_rigid_mass(const scene::Scene &scene, const std::string &verb) {
  require_bearing(scene, verb);
  if (scene.superstructure.any())
    throw InputError(fmt::format("superstructure.kind \"{}\": {} runs the bearing under a rigid mass; leave "
                                 "[superstructure] out, its mass is in load.mass_kg",
                                 word(scene.superstructure.kind), verb));
}

void require_slider_of_one_piece(const scene::Scene &scene, const std::string &verb) {
  if (!scene.bearing.has_interface()) return;
  throw InputError(
      fmt::format("bearing.slider.mu_interface {:g}: {} finds the law of a rim, which is that of a slider of "
                  "one piece; `rimpact run` runs this bearing by rungs `rigid-dish` and `full`",
                  *scene.bearing.slider.mu_interface, verb));
}

void take_rung(GivenCase &given, const std::vector<std::string> &overrides) {
  const auto keys = keys_set(overrides);
  const bool asked = std::find(keys.begin(), keys.end(), "model.rung") != keys.end();
  if (!asked && (given.built_in || !given.has_rung)) given.scene.model.rung = scene::FeSettings{}.rung;
}

MainTarget main_target(const std::string &where, const std::vector<std::string> &overrides) {
  MainTarget target{given_case(where, overrides), {}};
  refuse_unread(overrides, "main", not_of_main);
  require_bearing_under_rigid_mass(target.scene, "main");
  require_slider_of_one_piece(target.scene, "main");
  take_rung(target, overrides);
  if (const auto reason = planning::beyond_rungs(target.scene)) throw InputError(*reason);
  if (!target.built_in && target.has_motion)
    target.remarks.push_back(fmt::format(
        "the motion of {} ({}) is not run: main runs windows and Ricker pulses of its own; `rimpact run` runs it",
        target.origin, word(target.scene.excitation.kind)));
  return target;
}

} // namespace rimpact::app
