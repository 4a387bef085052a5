#include "laws/friction/sliding_heat.h"
#include <cmath>
#include <numbers>

namespace rimpact::friction {

/// Modes 1.. decay with e^(first + i spacing); the first one stands for all slower ones, which do not decay, and the
/// last one for all faster ones, which follow the flux at once.
SlidingHeat::SlidingHeat(const HeatSink &sink) : at_start_(sink.at_start) {
  constexpr double spacing = 1.2, first = -8.4;
  const double scale = std::sqrt(sink.diffusivity / std::numbers::pi) / sink.conductivity / std::sqrt(std::numbers::pi);
  const double ratio = std::exp(-spacing / 2); // of two neighbours' weights
  for (int i = 1; i < n_heat_modes; ++i) {
    const double x = first + spacing * (i - 1);
    decay_[i] = std::exp(x), gain_[i] = scale * spacing * std::exp(x / 2);
  }
  decay_[0] = 0, gain_[0] = gain_[1] * ratio / (1 - ratio);
  gain_[n_heat_modes - 1] /= 1 - ratio; // gain / decay, what a mode rises to, falls by the same ratio
}

void SlidingHeat::rates(const double *modes, double flux, double *rate) const {
  for (int i = 0; i < n_heat_modes; ++i) rate[i] = gain_[i] * flux - decay_[i] * modes[i];
}

HeatModes SlidingHeat::after(const HeatModes &modes, double flux, double time) const {
  HeatModes next;
  for (int i = 0; i < n_heat_modes; ++i) {
    const double gone = -std::expm1(-decay_[i] * time);
    next[i] = modes[i] - modes[i] * gone + gain_[i] * flux * (decay_[i] > 0 ? gone / decay_[i] : time);
  }
  return next;
}

double SlidingHeat::temperature(const double *modes) const {
  double rise = 0;
  for (int i = 0; i < n_heat_modes; ++i) rise += modes[i];
  return at_start_ + rise;
}

bool passes_over(double distance, double contact_radius) {
  return distance < contact_radius * std::sqrt(std::numbers::pi) / 2;
}

} // namespace rimpact::friction
