#include "scene/doubts.h"
#include "scene/isolator_doubts.h"
#include "scene/record_doubts.h"
#include "scene/steel_doubts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace rimpact::scene {
namespace {

/// Largest acceleration of the ground along one axis [g], scale included.
double largest_acceleration(const Scene &scene) {
  const Excitation &e = scene.excitation;
  if (e.kind == ExcitationKind::ricker) return std::abs(e.scale * e.amplitude_g);
  double largest = 0;
  if (e.kind == ExcitationKind::record)
    for (const auto *component : {&e.x, &e.y, &e.z})
      for (const double a : component->values) largest = std::max(largest, std::abs(e.scale * a) / scene.load.gravity);
  return largest;
}

/// A value and where it belongs, both in the file's unit.
struct Usual {
  std::string key;
  const char *unit;
  double value, low, high;
};

void doubt_materials(const Bearing &b, std::vector<std::string> &found) {
  std::vector<Usual> values{{"ertalyte.E_MPa", "MPa", b.ertalyte.E / 1e6, 1e2, 4e5},
                            {"ertalyte.density_kg_per_m3", "kg/m3", b.ertalyte.density, 5e2, 2e4}};
  for (const auto &[table, steel] : steels_of(b)) {
    values.push_back({table + ".E_MPa", "MPa", steel->E / 1e6, 5e4, 4e5});
    values.push_back({table + ".density_kg_per_m3", "kg/m3", steel->density, 2e3, 2e4});
    if (steel->yield) values.push_back({table + ".yield_MPa", "MPa", *steel->yield / 1e6, 100, 2000});
  }
  for (const auto &v : values)
    if (v.value < v.low || v.value > v.high)
      found.push_back(fmt::format("bearing.material.{} = {:g}, where {:g} to {:g} {} is usual: is its unit {}?", v.key,
                                  v.value, v.low, v.high, v.unit, v.unit));
}

/// One dimension beside another of the same bearing: no bearing is of the thesis's size by rights.
struct Beside {
  const char *key, *unit;
  double value;
  const char *other;
  double own, low, high; ///< of value / own
};

/// Dimensions in the metres or inches of a drawing are not those of the rest of the bearing.
void doubt_sizes(const Bearing &b, std::vector<std::string> &found) {
  const double planar = 1e3 * b.surface.planar_radius;
  const char *edge = "surface.planar_radius_mm";
  for (const auto &[key, unit, value, other, own, low, high] :
       {Beside{"rim.thickness_mm", "mm", 1e3 * b.rim.thickness, "rim.height_mm", 1e3 * b.rim.height, 0.05, 10},
        Beside{"slider.diameter_mm", "mm", 1e3 * b.slider.diameter, edge, planar, 0.1, 2},
        Beside{"plate.base_mm", "mm", 1e3 * b.plate.base, edge, planar, 0.01, 2}})
    if (value < low * own || value > high * own)
      found.push_back(
          fmt::format("bearing.{} = {:.6g} is {:.2g} times bearing.{} = {:.6g}, where {:g} to {:g} times is "
                      "usual: is its unit {}?",
                      key, value, value / own, other, own, low, high, unit));
}

/// The slider's disc under the dead load.
void doubt_pressure(const Scene &scene, std::vector<std::string> &found) {
  constexpr double least = 0.5e6, most = 200e6; // [Pa]; the thesis's bearing has 19 MPa
  const double across = scene.bearing.slider.diameter, area = std::numbers::pi * across * across / 4,
               pressure = scene.load.vertical / area;
  if (scene.rigid_bodies() || scene.load.vertical == 0 || (pressure >= least && pressure <= most)) return;
  found.push_back(fmt::format("load.vertical_kN = {:.6g} presses a slider of {:.6g} mm with {:.2g} MPa, where {:g} to "
                              "{:g} MPa is usual: is its unit kN?",
                              scene.load.vertical / 1e3, 1e3 * across, pressure / 1e6, least / 1e6, most / 1e6));
}

/// A pad that slides on a sphere is shaped to it, or bears on its rim or its middle only.
void doubt_pad(const Bearing &b, std::vector<std::string> &found) {
  constexpr double alike = 0.01;
  if (b.surface.kind == SurfaceKind::sphere && std::abs(b.pad.shape_radius / b.surface.R0 - 1) > alike)
    found.push_back(
        fmt::format("bearing.pad.shape_radius_mm = {:g} on a sphere of R0_m = {:g}: a pad shaped to its dish has {:g}",
                    1e3 * b.pad.shape_radius, b.surface.R0, 1e3 * b.surface.R0));
}

void doubt_gravity(const Scene &scene, std::vector<std::string> &found) {
  constexpr double least = 9.7, most = 9.9; // on Earth
  if (const double g = scene.load.gravity; g < least || g > most)
    found.push_back(
        fmt::format("load.gravity_m_per_s2 = {:g}, where it is {} to {} on Earth: is its unit m/s2?", g, least, most));
}

/// Weight and mass hold each other to account.
void doubt_load(const Scene &scene, std::vector<std::string> &found) {
  constexpr double odd_weight = 2, slip = 20; // weight over mass times gravity, or its inverse
  const double inertial = scene.load.mass * scene.load.gravity, ratio = scene.load.vertical / inertial;
  if (scene.load.vertical > 0 && (ratio > odd_weight || ratio < 1 / odd_weight))
    found.push_back(fmt::format(
        "load.vertical_kN = {:g} is {:.2g} times load.mass_kg = {:g} times gravity ({:.4g} kN): {}",
        scene.load.vertical / 1e3, ratio, scene.load.mass, inertial / 1e3,
        ratio > slip || ratio < 1 / slip ? "are the units right?"
                                         : "was one of the two forgotten? Left out, it follows from the other"));
}

} // namespace

std::vector<std::string> doubts(const Scene &scene, bool load_is_read) {
  constexpr double strongest = 5; // no ground has been recorded near it [g]
  constexpr double fastest = 10;  // an impact's speed [m/s]
  std::vector<std::string> found;
  if (load_is_read) doubt_gravity(scene, found), doubt_load(scene, found), doubt_pressure(scene, found);
  if (const double a = largest_acceleration(scene); a > strongest)
    found.push_back(fmt::format(
        "the ground's acceleration reaches {:.3g} g, beyond any recorded: are its unit and scale right?", a));
  if (scene.excitation.kind == ExcitationKind::window && scene.excitation.impact_speed() > fastest)
    found.push_back(fmt::format("excitation.speed_m_per_s times scale is {:g}: no bearing meets its rim so fast",
                                scene.excitation.impact_speed()));
  doubt_records(scene, found);
  doubt_materials(scene.bearing, found);
  if (scene.rigid_bodies())
    for (auto &doubt : doubts_of_isolator(scene.isolator, scene.reduced.model)) found.push_back(std::move(doubt));
  else {
    for (auto &doubt : doubts_of_grade(scene.bearing)) found.push_back(std::move(doubt));
    doubt_sizes(scene.bearing, found);
  }
  if (scene.needs_stack() && scene.bearing.has_pad()) doubt_pad(scene.bearing, found);
  return found;
}

} // namespace rimpact::scene
