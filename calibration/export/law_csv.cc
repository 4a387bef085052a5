#include "calibration/export/law_csv.h"

#include "calibration/export/comment.h"
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

constexpr int n_points = 40;

/// A law without rate: first loading to 1.2 times the largest penetration, and unloading from the depths of five
/// speeds.
std::string curves(const ExportedRim &rim) {
  const auto element = rim.element();
  std::string text = "branch,from_speed_m_s,penetration_mm,force_kN\n";
  std::vector<double> speeds = speeds_between(rim.from, rim.to, 5), depths;
  for (const double v : speeds) {
    LawContact law(element);
    depths.push_back(fly(law, rim.mass, v, rim.settings.k_i).penetration);
  }
  for (int i = 0; i <= 2 * n_points; ++i) {
    const double d = 1.2 * depths.back() * i / (2 * n_points);
    text += fmt::format("loading,,{:.6g},{:.6g}\n", 1e3 * d, element.at({.d = d, .rate = 0, .deepest = 0}).force / 1e3);
  }
  for (std::size_t s = 0; s < speeds.size(); ++s)
    for (int i = 0; i <= n_points; ++i) {
      const double open = element.law->yields ? laws::residual_indentation(element, depths[s]) : 0;
      const double d = depths[s] - (depths[s] - open) * i / n_points;
      text += fmt::format("unloading,{:.6g},{:.6g},{:.6g}\n", speeds[s], 1e3 * d,
                          element.at({.d = d, .rate = 0, .deepest = depths[s]}).force / 1e3);
    }
  return text;
}

/// A law with a dashpot has no curve but an impact's: five of them.
std::string impacts(const ExportedRim &rim) {
  const auto element = rim.element();
  std::string text = "branch,from_speed_m_s,time_ms,penetration_mm,force_kN\n";
  for (const double speed : speeds_between(rim.from, rim.to, 5)) {
    LawContact law(element);
    const double duration = fly(law, rim.mass, speed, rim.settings.k_i).duration;
    constexpr int steps = 50; // of the integrator a row
    const double h = duration / (2 * n_points * steps);
    double d = 0, v = speed, t = 0;
    for (int i = 0; i <= 2 * n_points; ++i) {
      text += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g}\n", v >= 0 ? "loading" : "unloading", speed, 1e3 * t, 1e3 * d,
                          law.force(d, v) / 1e3);
      for (int step = 0; step < steps; ++step, t += h) { // midpoint rule
        const double a = -law.force(d, v) / rim.mass, dm = d + h / 2 * v, vm = v + h / 2 * a;
        d += h * vm, v -= h * law.force(dm, vm) / rim.mass;
      }
    }
  }
  return text;
}

} // namespace

std::string law_csv(const ExportedRim &rim, const std::vector<std::string> &header) {
  const bool rate = !rim.element().law->yields;
  std::string text = comment_lines("#", header) + comment_lines("#", rim.statement);
  text += comment_line(
      "#", fmt::format("Force of the rim over penetration beyond the travel {:.6g} m at which it begins. {}",
                       rim.lateral_capacity,
                       rate ? "The law has a dashpot: its curves are those of impacts of the mass at five speeds."
                            : "First loading; unloading from the depths that the mass reaches at five speeds. The "
                              "force does not depend on the rate."));
  return text + (rate ? impacts(rim) : curves(rim));
}

} // namespace rimpact::calibration
