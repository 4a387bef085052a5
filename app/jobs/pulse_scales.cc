#include "app/jobs/pulse_scales.h"

#include "reduced_models/bearings/foot_limit.h"
#include "reduced_models/bearings/pad_on_dish.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

constexpr double smallest_scale = 1e-3, largest_scale = 3;

/// What the reduced model does at a scale.
struct Scouted {
  double speed = 0;         ///< fastest approach [m/s]
  bool leaves_dish = false; ///< stopped there
};

Scouted scout(scene::Scene &scene, double scale) {
  scene.excitation.scale = scale;
  const auto summary = reduced::simulate_summary(scene);
  Scouted result{.leaves_dish = summary.status != RunStatus::done};
  for (const auto &impact : summary.impacts) result.speed = std::max(result.speed, impact.approach_speed);
  return result;
}

double rounded(double scale) {
  return std::ceil(1e4 * scale) / 1e4;
} // up: never back below first touch

/// The scale at which the fastest approach reaches `speed`, or why there is none.
std::optional<double> scale_for(scene::Scene &scene, double first_touch, double speed, std::string &why) {
  constexpr double first_step = 0.005, enough = 1e-5;
  double low = first_touch, high = first_touch;
  for (double step = first_step; high == low || scout(scene, high).speed < speed; step *= 2) {
    if (high >= largest_scale) {
      why = fmt::format("no scale up to {:g} brings {:g} m/s to the rim", largest_scale, speed);
      return {};
    }
    low = high;
    high = std::min(largest_scale, high + step);
  }
  while (high - low > enough) {
    const double middle = (low + high) / 2;
    (scout(scene, middle).speed < speed ? low : high) = middle;
  }
  if (scout(scene, rounded(high)).leaves_dish) {
    why = fmt::format("at scale {:.4f}, where it meets the rim at {:g} m/s, the slider leaves the dish", high, speed);
    return {};
  }
  return high;
}

} // namespace

PulseScales pulse_scales(scene::Scene pulse, const SpeedRange &range) {
  PulseScales result;
  pulse = reduced::in_one_piece(std::move(pulse)); // finite elements go on where its foot goes
  if (pulse.reduced.k_i == 0) pulse.reduced.k_i = scene::ReducedSettings{}.k_i; // a scout must feel the rim
  if (has_dish(pulse.model.rung)) reduced::add_stack_terms(pulse);
  result.first_touch = reduced::critical_scale(pulse, smallest_scale, largest_scale);
  if (!result.first_touch) {
    result.left_out.push_back(
        fmt::format("{} is left out: no scale up to {:g} takes the slider to the rim", pulse.name, largest_scale));
    return result;
  }
  const double middle = (range.low + range.high) / 2;
  const std::pair<double, bool> asked[] = {
      {range.high, true}, {middle, true}, {std::min(2 * range.low, (range.low + middle) / 2), false}};
  for (const auto &[speed, fitted] : asked) {
    std::string why;
    const auto scale = scale_for(pulse, *result.first_touch, speed, why);
    if (!scale) {
      result.left_out.push_back(
          fmt::format("{} to {} at {:g} m/s is left out: {}", pulse.name, fitted ? "fit" : "predict", speed, why));
      continue;
    }
    const double used = rounded(*scale);
    const bool known =
        std::any_of(result.pulses.begin(), result.pulses.end(), [&](const auto &each) { return each.scale == used; });
    if (!known) result.pulses.push_back({used, scout(pulse, used).speed, fitted});
  }
  return result;
}

std::string in_a_name(double value) {
  std::string text = fmt::format("{:.4f}", value);
  while (text.ends_with('0') && text[text.size() - 3] != '.') text.pop_back();
  return text;
}

} // namespace rimpact::app
