#include "calibration/studies/geometry_study.h"
#include "calibration/fit/halton.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace rimpact::calibration {

namespace {
using scene::Scene, scene::Material;

/// The bearing's steel and, where the rim has another one, the rim's.
void each_of_the_rim(Scene &scene, const std::function<void(Material &)> &change) {
  change(scene.bearing.steel);
  const auto own = scene.bearing.part_steels.find(scene::SteelPart::rim);
  if (own != scene.bearing.part_steels.end()) change(own->second);
}

/// Height of the slider's side that stands before the rim's wall at L_c.
double contact_band(const Scene &s) {
  return scene::rim_top(s.bearing) - scene::edge_at_touch(s.bearing);
}

struct Range {
  double low, high; ///< SI
};
Range range_of(const GeometryAxis &axis, const Scene &window, const GeometryOptions &options) {
  if (const auto given = options.ranges.find(axis.name); given != options.ranges.end())
    return {given->second.lower * axis.si, given->second.upper * axis.si};
  const double own = axis.absolute ? axis.si : axis.get(window);
  return {axis.low * own, axis.high * own};
}

bool can_be_built(const Scene &scene) {
  try {
    scene.validate();
    return contact_band(scene) > scene.bearing.slider.edge_radius;
  } catch (const InputError &) {
    return false;
  }
}

/// Index `i` of the sequence, evenly in the logarithms.
Scene sample(const Scene &window, const GeometryOptions &options, int i) {
  Scene scene = window;
  const auto &axes = geometry_axes();
  for (std::size_t j = 0; j < axes.size(); ++j) {
    const auto [low, high] = range_of(axes[j], window, options);
    axes[j].set(scene, low * std::pow(high / low, radical_inverse(i, halton_bases[j])));
  }
  return scene;
}

} // namespace

const std::vector<GeometryAxis> &geometry_axes() {
  static const std::vector<GeometryAxis> axes = {
      {"rim_height", "mm", 1e-3, 0.8, 1.3, false, [](const Scene &s) { return s.bearing.rim.height; },
       [](Scene &s, double v) { s.bearing.rim.height = v; }},
      {"rim_thickness", "mm", 1e-3, 0.6, 1.5, false, [](const Scene &s) { return s.bearing.rim.thickness; },
       [](Scene &s, double v) { s.bearing.rim.thickness = v; }},
      {"slider_diameter", "mm", 1e-3, 0.9, 1.1, false, [](const Scene &s) { return s.bearing.slider.diameter; },
       [](Scene &s, double v) { s.bearing.slider.diameter = v; }},
      {"contact_band", "mm", 1e-3, 0.8, 1.2, false, contact_band,
       [](Scene &s, double v) { s.bearing.slider.bottom += contact_band(s) - v; }},
      {"yield_stress", "MPa", 1e6, 0.7, 1.4, false,
       [](const Scene &s) { return s.bearing.rim_steel().yield.value_or(0); },
       [](Scene &s, double v) { each_of_the_rim(s, [v](Material &steel) { steel.yield = v; }); }},
      {"tangent_modulus", "MPa", 1e6, 0.4, 2.5, false,
       [](const Scene &s) { return s.bearing.rim_steel().tangent_modulus.value_or(0); },
       [](Scene &s, double v) { each_of_the_rim(s, [v](Material &steel) { steel.tangent_modulus = v; }); }},
      {"speed", "m/s", 1, 0.1, 0.8, true, [](const Scene &s) { return s.excitation.speed; },
       [](Scene &s, double v) { s.excitation.speed = v; }},
  };
  return axes;
}

void GeometryOptions::validate() const {
  constexpr int most = 10000; // a week of runs
  if (samples < 3 || samples > most) throw InputError(fmt::format("samples {} must be from 3 to {}", samples, most));
  if (!(strain_limit > 0)) throw InputError(fmt::format("strain-limit {:g} must be > 0", strain_limit));
  std::vector<std::string> known;
  for (const auto &axis : geometry_axes()) known.push_back(axis.name);
  for (const auto &[name, range] : ranges) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError("range " + unknown_word(name, known));
    if (!(range.lower > 0 && range.lower < range.upper))
      throw InputError(fmt::format("range of {}: {:g}:{:g} must be 0 < LOW < HIGH", name, range.lower, range.upper));
  }
}

std::vector<Scene> geometry_scenes(const Scene &window, const GeometryOptions &options) {
  options.validate();
  const Material &steel = window.bearing.rim_steel();
  if (!steel.yield || steel.tangent_modulus.value_or(0) <= 0)
    throw InputError(
        fmt::format("material.steel needs yield_MPa and tangent_modulus_MPa > 0 for a geometry study, which "
                    "varies two straight lines; its hardening is \"{}\"",
                    word(steel.hardening.law)));
  const auto speeds = range_of(geometry_axes().back(), window, options);
  std::vector<Scene> scenes;
  for (const double share : {0.0, 0.5, 1.0}) {
    scenes.push_back(window);
    scenes.back().excitation.speed = speeds.low * std::pow(speeds.high / speeds.low, share);
  }
  const auto n = static_cast<std::size_t>(options.samples);
  for (int i = 1; scenes.size() < n; ++i) {
    if (i > 20 * options.samples)
      throw InputError(
          fmt::format("only {} of {} sampled dimensions can be built: narrow the ranges", scenes.size() - 3, i));
    if (Scene scene = sample(window, options, i); can_be_built(scene)) scenes.push_back(scene);
  }
  for (std::size_t i = 0; i < n; ++i) scenes[i].name = fmt::format("g{:03}", i);
  return scenes;
}

GeometryRow geometry_row(const std::string &name, const StoredRun &run, double plastic_strain) {
  if (run.impacts.empty())
    throw DataError(fmt::format("{}: no impact to read{}", run.folder, run.notes.empty() ? "" : ": " + run.notes[0]));
  FitOptions options;
  options.law = "signed";
  const FitResult result = fit({&run}, options);
  GeometryRow row{.name = name,
                  .inputs = {},
                  .k_i = result.parameters.at("k_i").value,
                  .e = result.parameters.at("e").value,
                  .peak_force = run.peak_force(),
                  .plastic_strain = plastic_strain,
                  .mass = run.scene.load.mass,
                  .weight = run.scene.load.vertical};
  for (const auto &axis : geometry_axes()) row.inputs.push_back(axis.get(run.scene) / axis.si);
  return row;
}

} // namespace rimpact::calibration
