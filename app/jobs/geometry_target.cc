#include "app/jobs/geometry_target.h"

#include "app/jobs/main_target.h"
#include "app/words/set_keys.h"
#include "responses/steel_report.h"
#include "scene/doubts.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

std::string not_of_geometry(const std::string &key) {
  if (is_in(key, "excitation.kind")) return "every run is an isolated impact (impact-window)";
  if (is_in(key, "excitation.speed_m_per_s") || is_in(key, "excitation.scale"))
    return "the speed is one of its ranges: --range speed=LOW:HIGH";
  if (is_in(key, scene::inner_rims_section)) return "it presses a slider on dishes";
  if (is_in(key, "reduced.calibration") || is_of_a_fit(key)) return "each impact gets a k_i and e of its own";
  if (is_in(key, "bounds")) return bounds_are_reduced;
  return key == "name" ? "its runs are numbered" : "";
}

} // namespace

double strain_in(const nlohmann::json &summary, const std::string &folder) {
  const auto of_any_body = summary.value("max_plastic_strain", nlohmann::json());
  const auto judged = judged_strain(steel_report_in(summary, folder),
                                    of_any_body.is_number() ? std::optional(of_any_body.get<double>()) : std::nullopt);
  return judged ? judged->largest : 0.0;
}

scene::Scene window_of(const GivenCase &given, const std::vector<std::string> &overrides) {
  std::vector<std::string> motion;
  for (const auto &assignment : overrides) {
    const auto keys = keys_set({assignment});
    if (std::any_of(keys.begin(), keys.end(), [](const auto &key) { return is_in(key, "excitation"); }))
      motion.push_back(assignment);
  }
  scene::Scene window = scene::load_scene("impact-window", motion);
  window.bearing = given.scene.bearing, window.load = given.scene.load;
  window.load_remark = given.scene.load_remark;
  window.model = given.scene.model, window.reduced = given.scene.reduced;
  window.reduced.forget_fit();
  window.validate();
  return window;
}

GivenCase geometry_target(const std::string &where, Console &console) {
  if (!console.calibration.empty() || !console.inner_calibration.empty())
    throw InputError(
        "--calibration, --inner-calibration: geometry fits k_i and e to each impact by itself, it takes no element");
  GivenCase given = given_case(where, console.overrides);
  refuse_unread(console.overrides, "geometry", not_of_geometry);
  require_bearing_under_rigid_mass(given.scene, "geometry");
  require_slider_of_one_piece(given.scene, "geometry");
  take_rung(given, console.overrides);
  for (const auto &doubt : scene::doubts(given.scene)) given.warnings.push_back(doubt);
  for (const auto &warning : given.warnings) console.warn(warning);
  if (!given.built_in && given.has_motion)
    console.message(fmt::format("the motion of {} is not run: geometry runs isolated impacts (impact-window); --range "
                                "speed=LOW:HIGH gives their speeds",
                                given.origin));
  return given;
}

} // namespace rimpact::app
