#include "responses/limits.h"

#include "responses/hit_limits.h"
#include "responses/steel_limits.h"
#include "scene/flow_curve.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

using nlohmann::json;

void warn(Summary &summary, const std::string &sentence) {
  summary.extra["warnings"].push_back(sentence);
}

/// Deepest the slider went into or past the rim, or each of two [m]; impacts that a model leaves out count by their
/// travel, of which a slider of two halves may have slipped a part.
double deepest(const scene::Scene &scene, const Summary &summary) {
  double depth = scene.bearing.has_interface() ? 0 : summary.peak_displacement - scene.bearing.lateral_capacity();
  for (const auto &impact : summary.impacts) depth = std::max(depth, impact.peak_penetration);
  return depth / scene.bearing.dishes();
}

json beyond_rim(const scene::Scene &scene, Summary &summary) {
  if (scene.rigid_bodies()) return nullptr;
  const double depth = deepest(scene, summary), thickness = scene.bearing.rim.thickness;
  const double travel = summary.peak_displacement, edge = scene.bearing.ridden_surface().planar_radius;
  if (travel > edge)
    warn(summary, fmt::format("the slider's centre came {:.0f} mm from the middle, past the dish's edge at {:.0f} mm: "
                              "no bearing does so, this is no result",
                              1e3 * travel, 1e3 * edge));
  if (!(depth > thickness)) return false;
  const bool felt = !summary.impacts.empty();
  warn(summary,
       felt ? fmt::format("pressed {:.0f} mm into a rim of {:.0f} mm: such a rim has failed, and forces and travel "
                          "from there on are no result",
                          1e3 * depth, 1e3 * thickness)
            : fmt::format("the slider went {:.0f} mm past the wall of a rim of {:.0f} mm that this run leaves out",
                          1e3 * depth, 1e3 * thickness));
  return true;
}

json beyond_fit(const scene::Scene &scene, Summary &summary) {
  const double mass = carried_mass(scene, summary);
  const auto range_of_fit = fitted_speeds(scene, mass);
  if (!range_of_fit.is_known()) return nullptr;
  const auto &[from, to] = range_of_fit;
  double slowest = 1e300, fastest = 0;
  int beyond = 0;
  for (const auto &impact : summary.impacts) {
    const double speed = impact.approach_speed;
    if (range_of_fit.holds(speed)) continue;
    ++beyond, slowest = std::min(slowest, speed), fastest = std::max(fastest, speed);
  }
  if (beyond > 0 && summary.rung == SolvedBy::reduced) {
    std::string range = from && to ? fmt::format("{:.4g} to {:.4g} m/s", *from, *to)
                        : from     ? fmt::format("{:.4g} m/s upwards", *from)
                                   : fmt::format("up to {:.4g} m/s", *to);
    if (const auto &at = scene.reduced.fitted_speeds_mass; at && std::abs(*at / mass - 1) > 1e-3)
      range += fmt::format(" at {:.6g} kg (fitted at {:.6g} kg)", mass, *at);
    const std::string speeds = beyond == 1
                                   ? fmt::format("an impact at {:.3g} m/s", fastest)
                                   : fmt::format("{} impacts at {:.3g} to {:.3g} m/s", beyond, slowest, fastest);
    warn(summary,
         fmt::format(
             "{} outside the speeds the impact element was fitted to, {}: its force and rebound there are extrapolated",
             speeds, range));
  }
  return beyond > 0;
}

void warn_of_slider(Summary &summary) {
  const auto edge = summary.steel.find(SteelPlace::slider_edge);
  if (edge == summary.steel.end() || !edge->second.limit || edge->second.averaged <= *edge->second.limit) return;
  warn(summary,
       fmt::format("the slider's edge is crushed: its plastic strain reaches {:.1f} %, above what its steel is "
                   "trusted to; whether the rim holds is another question",
                   100 * edge->second.averaged));
}

json strain_limit(const scene::Scene &scene, Summary &summary) {
  if (!summary.max_plastic_strain) return nullptr;
  const auto [largest, place, own] = *judged_strain(summary.steel, summary.max_plastic_strain);
  const SteelPlace of = place.value_or(weakest_of_the_rim(scene.bearing));
  const auto limit = place ? own : limit_at(scene.bearing, of);
  if (!limit) return nullptr;
  const bool exceeded = largest > *limit, assumption = limit_is_assumed(scene.bearing, of);
  const std::string beyond = fmt::format("above the {:g} % that the steel is trusted to ({}{})", 100 * *limit,
                                         limit_key(scene.bearing, of), assumption ? ", an assumption" : "");
  if (exceeded)
    warn(summary,
         fmt::format("plastic strain {} reaches {:.1f} %, {}: cracks, which no law here has, would change the force",
                     place ? "of " + description(*place) : "of some body", 100 * largest, beyond));
  return {{"limit", *limit},
          {"largest", largest},
          {"place", place ? json(word(*place)) : json(nullptr)},
          {"exceeded", exceeded},
          {"assumption", assumption}};
}

/// Two rims press a slider between them at different heights: a couple, which its faces hold by moving their pressure
/// as far as their edges.
void warn_of_tipping(const scene::Scene &scene, Summary &summary) {
  const scene::Bearing &b = scene.bearing;
  if (scene.rigid_bodies() || !b.double_concave() || !summary.peak_impact_force) return;
  const double tilt = scene::tilt(b, b.lateral_capacity()),
               middle = b.surface.R0 - (b.surface.R0 - b.slider.height / 2) * std::cos(tilt),
               arm = 2 * (middle - scene::edge_at_touch(b) - b.slider.edge_radius),
               couple = *summary.peak_impact_force * arm, held = scene.load.vertical * b.slider.diameter;
  const auto rung = rung_of(summary.rung);
  const bool turns = rung && has_dish(*rung);
  if (couple > held)
    warn(summary,
         fmt::format("the rims' forces of {:.0f} kN turn the slider with {:.0f} kN m, more than the {:.0f} kN m "
                     "that its faces hold under the dead load: it tips and may climb a rim{}",
                     *summary.peak_impact_force / 1e3, couple / 1e3, held / 1e3,
                     turns                     ? ""
                     : scene.load.vertical > 0 ? ", which this model does not have (rungs `rigid-dish` and `full` do)"
                                               : ", which this model does not have"));
}

json rim_foot(const scene::Scene &scene, Summary &summary) {
  if (!summary.foot) return nullptr;
  const auto &connection = scene.bearing.rim.connection;
  if (summary.foot->exceeded())
    warn(summary,
         fmt::format("the joint at the rim's foot, {}, is used to {:.2f} of what it bears (bearing.rim.connection): "
                     "the wall breaks off there, and forces and travel beyond a use of 1, which are those of "
                     "a rim in one piece with its plate, are no result",
                     in_words(connection), *summary.foot->use));
  return to_json(*summary.foot, connection);
}

/// Steel that was strained beyond the last row of its curve, where the stress is held.
void warn_beyond_curve(const scene::Scene &scene, Summary &summary) {
  if (!summary.max_plastic_strain) return;
  for (const auto &[table, steel] : scene::steels_of(scene.bearing)) {
    if (!steel->yield || steel->hardening.law != scene::HardeningLaw::table) continue;
    const auto last = scene::flow_curve(*steel).rows.back();
    if (*summary.max_plastic_strain > last[0])
      warn(summary, fmt::format("plastic strain reaches {:.3g}, beyond the last row of bearing.material.{}.curve at "
                                "{:.3g}: the stress was held at {:.4g} MPa there, which no test shows",
                                *summary.max_plastic_strain, table, last[0], last[1] / 1e6));
  }
}

} // namespace

void judge(const scene::Scene &scene, Summary &summary) {
  for (auto &[place, at] : summary.steel) at.limit = limit_at(scene.bearing, place);
  summary.extra["beyond_rim"] = beyond_rim(scene, summary);
  summary.extra["beyond_fit"] = beyond_fit(scene, summary);
  summary.extra["strain_limit"] = strain_limit(scene, summary);
  warn_of_slider(summary);
  summary.extra["rim_foot"] = rim_foot(scene, summary);
  warn_beyond_curve(scene, summary);
  warn_of_tipping(scene, summary);
  summary.extra["hit_limits"] = hit_limits(scene, summary);
}

} // namespace rimpact
