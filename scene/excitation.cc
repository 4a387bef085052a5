#include "scene/excitation.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact::scene {
namespace {

constexpr double pi = std::numbers::pi;

Eigen::Vector2d unit_vector(double direction_deg) {
  // Exact along the axes, so that a pulse along x leaves y at zero and not at 1e-17.
  const double quarter = direction_deg / 90;
  if (quarter == std::floor(quarter)) {
    const int turns = static_cast<int>(std::fmod(std::fmod(quarter, 4) + 4, 4));
    const double cosines[] = {1, 0, -1, 0}, sines[] = {0, 1, 0, -1};
    return {cosines[turns], sines[turns]};
  }
  return {std::cos(direction_deg * pi / 180), std::sin(direction_deg * pi / 180)};
}

bool has_ricker(const Excitation &e) {
  return e.kind == ExcitationKind::ricker || (e.kind == ExcitationKind::window && e.with_ground);
}

/// Share of a push's load parameter spent until touch, and until the end of pressing.
struct PushPhases {
  double touch, pressed;
};
PushPhases push_phases(const Excitation &e) {
  return e.unload ? PushPhases{0.2, 0.6} : PushPhases{0.3, 1.0};
}

} // namespace

bool Excitation::is_dynamic() const {
  return kind == ExcitationKind::ricker || kind == ExcitationKind::record || kind == ExcitationKind::free ||
         kind == ExcitationKind::window;
}

bool Excitation::stays_on_dish() const {
  return kind == ExcitationKind::cyclic || kind == ExcitationKind::figure_eight || kind == ExcitationKind::path;
}

double Excitation::largest_amplitude() const {
  if (kind != ExcitationKind::cyclic || amplitudes.empty()) return amplitude;
  return *std::max_element(amplitudes.begin(), amplitudes.end());
}

double Excitation::rounds() const {
  if (kind == ExcitationKind::path) return path.at.empty() ? 1.0 : path.length() / (4 * path.reach());
  return kind == ExcitationKind::cyclic && !amplitudes.empty() ? cycles * static_cast<double>(amplitudes.size())
                                                               : cycles;
}

double Excitation::whole_rounds() const {
  return std::max(1.0, std::ceil(rounds()));
}

Eigen::Vector2d Excitation::direction() const {
  return unit_vector(direction_deg);
}

double ricker_shape(double t, double centre, double period) {
  const double p = pi * (t - centre) / period, p2 = p * p;
  return (1 - 2 * p2) * std::exp(-p2);
}

GroundMotion::GroundMotion(const Excitation &excitation, double gravity)
    : excitation_(excitation), direction_(excitation.direction()) {
  if (has_ricker(excitation)) amplitude_ = excitation.scale * excitation.amplitude_g * gravity;
  if (excitation.kind != ExcitationKind::record) return;
  for (const auto *signal : {&excitation.x, &excitation.y, &excitation.z})
    for (std::size_t i = 0; i < signal->values.size(); ++i) breakpoints_.push_back(signal->instant(i));
  std::sort(breakpoints_.begin(), breakpoints_.end());
  // Components sampled alike agree to rounding: keep one instant of each.
  const auto same = [](double a, double b) { return b - a < 1e-9; };
  breakpoints_.erase(std::unique(breakpoints_.begin(), breakpoints_.end(), same), breakpoints_.end());
}

Eigen::Vector3d GroundMotion::acceleration(double t) const {
  if (amplitude_ != 0) {
    const double a = amplitude_ * ricker_shape(t, excitation_.centre, excitation_.period);
    return {a * direction_.x(), a * direction_.y(), 0};
  }
  if (excitation_.kind == ExcitationKind::record)
    return excitation_.scale * Eigen::Vector3d(excitation_.x.at(t), excitation_.y.at(t), excitation_.z.at(t));
  return Eigen::Vector3d::Zero();
}

namespace {

/// Of a cyclic path at s: each amplitude has an equal part of s.
struct Swing {
  double amplitude, angle;
};
Swing swing_at(const Excitation &e, double s) {
  if (e.amplitudes.empty()) return {e.amplitude, 2 * pi * e.cycles * s};
  const auto n = static_cast<double>(e.amplitudes.size());
  const double part = std::min(std::floor(n * s), n - 1);
  return {e.amplitudes[static_cast<std::size_t>(part)], 2 * pi * e.cycles * (n * s - part)};
}

} // namespace

Eigen::Vector2d prescribed_displacement(const Excitation &e, double lateral_capacity, double parameter) {
  const double s = std::clamp(parameter, 0.0, 1.0), angle = 2 * pi * e.cycles * s;
  switch (e.kind) {
  case ExcitationKind::cyclic: {
    const Swing swing = swing_at(e, s);
    return e.scale * swing.amplitude * std::sin(swing.angle) * e.direction();
  }
  case ExcitationKind::path:
    return e.scale * e.path.displacement(s);
  case ExcitationKind::figure_eight:
    return e.scale * e.amplitude * Eigen::Vector2d(std::sin(angle), std::sin(2 * angle));
  case ExcitationKind::push: {
    const auto [touch, pressed] = push_phases(e);
    const double travel = e.scale * e.travel, ease = travel * push_clearance;
    double u = 0;
    if (s <= touch)
      u = lateral_capacity * s / touch;
    else if (s <= pressed)
      u = lateral_capacity + travel * (s - touch) / (pressed - touch);
    else
      u = lateral_capacity + travel - (travel + ease) * (s - pressed) / (1 - pressed);
    return u * e.direction();
  }
  default:
    return Eigen::Vector2d::Zero();
  }
}

std::optional<double> prescribed_instant(const Excitation &e, double parameter) {
  if (e.kind != ExcitationKind::path || e.path.time.empty()) return std::nullopt;
  return e.path.instant(std::clamp(parameter, 0.0, 1.0));
}

std::vector<double> prescribed_breakpoints(const Excitation &e) {
  if (e.kind == ExcitationKind::path) return e.path.turns();
  if (e.kind != ExcitationKind::push) return {};
  const auto [touch, pressed] = push_phases(e);
  return e.unload ? std::vector<double>{touch, pressed} : std::vector<double>{touch};
}

} // namespace rimpact::scene
