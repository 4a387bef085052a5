/// The reduced model of an exported bearing: what the exported one is held against.
#pragma once
#include "calibration/export/bearing_flight.h"
#include "calibration/export/exported_rim.h"
#include <array>

namespace rimpact::calibration {

/// The model of the exported bearing: bearing, friction and stack terms of `scene`, load and law of `rim`.
scene::Scene model_of(const scene::Scene &scene, const ExportedRim &rim);

/// Pulses of the catalogue, and the scales of the main job.
inline constexpr std::array check_pulses{"ricker-0.78g-1.0s", "ricker-0.38g-1.5s"};
inline constexpr std::array check_scales{1.0, 1.05, 1.1};
scene::Scene under_pulse(const scene::Scene &model, const char *pulse);
/// A load that varies: what the ground does up and down beside a pulse, a sine [g], [Hz].
inline constexpr double check_vertical_g = 0.3, check_vertical_hz = 3;
/// The scene's pulse and that sine, as a record.
scene::Scene with_varying_load(scene::Scene scene);
/// What the scales are multiplied with: one, where the largest of them brings the model to its rim; else 1.05 times
/// the scale of the first touch. None: no scale does.
std::optional<double> unit_scale(scene::Scene scene);
/// Its run; none: it stopped.
std::optional<Arrival> fly_model(const scene::Scene &scene);
/// Fastest touch of the model under the pulses, at these scales [m/s]; 0: none.
double fastest_touch(const scene::Scene &scene, const ExportedRim &rim);
/// "0.164 m/s, 760 kN", or how far it went.
std::string words_of(const Arrival &arrival);

/// Terms of pad and socket of a calibration's answer, into a scene whose load is set; those that the bearing's pad and
/// foot do not fit are left out, with a remark of the scene.
void take_stack(scene::Scene &scene, const scene::StoredAnswer &answer);
/// What these terms do: the model with and without them, under a pulse that brings it to the rim. Empty: it has none.
std::vector<std::string> stack_effect(const scene::Scene &scene, const ExportedRim &rim);

} // namespace rimpact::calibration
