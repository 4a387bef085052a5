#include "scene/stack_terms.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace rimpact::scene {

const std::vector<std::string> &stack_keys() {
  static const std::vector<std::string> keys{"finite_pad", "socket_friction", "normal_force", "friction",
                                             "elastic_slip_mm"};
  return keys;
}

double pad_elastic_slip(const Bearing &bearing, double normal_force, double mu) {
  if (!bearing.has_pad()) return 0;
  const Material &pad = bearing.ertalyte;
  return mu * normal_force * bearing.pad.thickness / (pad.E / (2 * (1 + pad.nu)) * bearing.pad_area());
}

double pad_stiffness(const Bearing &bearing) {
  if (!bearing.has_pad())
    return bearing.steel_of(SteelPart::slider).E * std::numbers::pi * std::pow(bearing.slider.diameter / 2, 2) /
           bearing.slider.height;
  return bearing.ertalyte.E * bearing.pad_area() / bearing.pad.thickness;
}

double pad_retardation(const Scene &scene) {
  if (!scene.bearing.has_pad()) return 0;
  return scene.bearing.pad.loss_factor * std::sqrt(scene.load.mass / pad_stiffness(scene.bearing));
}

TakenTerms adopt_stack_terms(TomlFile &file, const StackTerms &terms, bool calibration_is_typed,
                             std::vector<std::string> &remarks) {
  const auto *model = file.find("reduced.model");
  if (model && model->is_string() && model->as_string()->get() != word(ModelKind::physical)) return {};
  std::vector<std::string> replaced;
  TakenTerms taken;
  for (const auto &[name, value] : terms.values) {
    const std::string key = "reduced." + name;
    if (file.is_set(key) || (file.find(key) && !calibration_is_typed)) continue;
    if (file.find(key)) replaced.push_back(name);
    file.set(key + "=" + value, "the calibration");
    taken.keys.push_back(key);
    if (name == "elastic_slip_mm") taken.bearings_slip = terms.slip_from == SlipFrom::bearing;
  }
  if (!replaced.empty())
    remarks.push_back(fmt::format("pad and socket are those of the calibration, in place of the scene's own {}",
                                  fmt::join(replaced, ", ")));
  return taken;
}

void leave_out_what_does_not_fit(Scene &scene) {
  ReducedSettings &r = scene.reduced;
  if (r.normal_force == NormalForce::pad &&
      (r.friction != Friction::park_wen || scene.superstructure.any() || !scene.bearing.has_pad()))
    r.normal_force = NormalForce::inertia; // the pad's spring is for a rigid mass on friction with an elastic slip
  if (!r.finite_pad && !r.socket_friction) return;
  try {
    if (!scene.bearing.has_pad()) throw InputError("a slider between two dishes has neither");
    scene.bearing.validate();
  } catch (const InputError &error) {
    r.finite_pad = r.socket_friction = false;
    scene.remarks.push_back(
        fmt::format("the pad's finite size and the socket's friction are left out: {}", error.what()));
  }
}

void resolve_elastic_slip(Scene &scene) {
  constexpr double rounding = 1e-6; // of a number that a calibration wrote
  const double slip = pad_elastic_slip(scene.bearing, scene.load.vertical, scene.reduced.mu_fast);
  if (slip > 0 && std::abs(slip / scene.reduced.elastic_slip - 1) > rounding) scene.reduced.elastic_slip = slip;
}

} // namespace rimpact::scene
