#include "calibration/data/consistency.h"

#include "calibration/data/force_factor.h"
#include "io/files/error.h"
#include "responses/response_csv.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

/// Measured figures that should agree may differ by this factor before units are suspected.
constexpr double suspicious = 3;

bool disagree(double a, double b) {
  return a > suspicious * b || b > suspicious * a;
}

/// Root mean square about the mean.
double spread(const std::vector<double> &values) {
  const double n = static_cast<double>(values.size());
  double mean = 0, sum = 0;
  for (const double v : values) mean += v / n;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return std::sqrt(sum / n);
}

std::vector<double> integrate(const std::vector<double> &times, const std::vector<double> &rates) {
  std::vector<double> values(times.size(), 0.0);
  for (std::size_t i = 1; i < times.size(); ++i)
    values[i] = values[i - 1] + 0.5 * (times[i] - times[i - 1]) * (rates[i] + rates[i - 1]);
  return values;
}

void check_travel(const StoredRun &run) {
  const double travel = run.summary.peak_displacement, L_c = run.scene.bearing.lateral_capacity();
  if (travel > suspicious * L_c)
    throw DataError(fmt::format("{}: the slider travels {:.4g} m where the rim stands at {:.4g} m; is the "
                                "displacement's unit right?",
                                run.folder, travel, L_c));
}

/// By the travel, which noise moves least: differences of noisy samples exceed any speed.
void check_velocity(const StoredRun &run) {
  const auto &r = run.response;
  const double stated = spread(integrate(r.series("time"), r.series("velocity_x"))),
               found = spread(r.series("displacement_x"));
  if (disagree(stated, found))
    throw DataError(fmt::format("{}: velocity_x and the slope of displacement_x differ by a factor of {:.3g}; are "
                                "the units of time, displacement and velocity right?",
                                run.folder, stated / found));
}

/// Longest time the force stays above half its peak [s].
double pressed_time(const std::vector<double> &times, const std::vector<double> &force, double peak) {
  double longest = 0;
  for (std::size_t i = 0, first = 0; i < times.size(); ++i) {
    if (force[i] < peak / 2) first = i + 1;
    if (first <= i) longest = std::max(longest, times[i] - times[first]);
  }
  return longest;
}

/// Of a known unit of force the name, where a column in it that is declared as `unit` gives this factor; or nothing.
std::string unit_slip(double factor, const std::string &unit) {
  constexpr double alike = 0.1;
  const auto declared = csv_unit(unit);
  if (!declared || std::string(declared->base) != "N") return {};
  for (const char *name : {"N", "kN", "MN", "kgf", "tf", "lbf", "kip"})
    if (const auto other = csv_unit(name); other && std::string(name) != unit)
      if (std::abs(factor * other->factor / declared->factor - 1) < alike)
        return fmt::format(" A column in {} declared as {} gives {:.3g}", name, unit, declared->factor / other->factor);
  return {};
}

/// A factor by which units are suspected: of an isolated impact, where nothing else moves the mass, a smaller one.
double suspicious_impulse(const scene::Excitation &x) {
  const bool isolated = x.kind == scene::ExcitationKind::window && !x.with_weight && !x.with_friction && !x.with_ground;
  return isolated ? 2 : suspicious;
}

/// The force against the motion that it causes. The change of momentum would do where a flight after the release tells
/// the rebound; where none does, the rebound is made from the impulse itself, which then agrees in any unit.
void check_impulse(const StoredRun &run, const ImpactWindow &w, const std::string &force_unit) {
  constexpr double sure = 5; // standard errors
  const double limit = suspicious_impulse(run.scene.excitation), mass = run.scene.load.mass;
  const auto found = force_factor(w, mass);
  if (!found) return;
  const double share = 1 / found->value; // of the measured impulse in the change of momentum
  const auto surely = [&](bool says) { return says && std::abs(found->value - 1) > sure * found->error; };
  if (surely(found->value <= 0))
    throw DataError(
        fmt::format("{}: at {:.4f} s the rim's force points outwards: it is {:.3g} times the one that turns "
                    "the slider back; is its sign right?",
                    run.folder, w.impact.touch_time, share));
  if (surely(share > limit || share < 1 / limit))
    throw DataError(fmt::format("{}: at {:.4f} s the impulse of the rim's force is {:.3g} times the change of "
                                "momentum; are the units of force and displacement and the mass ({:g} kg) right?{}",
                                run.folder, w.impact.touch_time, share, mass, unit_slip(share, force_unit)));
}

} // namespace

void require_clock(const Response &r, const scene::Scene &scene, const std::string &table) {
  std::vector<double> force;
  for (std::size_t i = 0; i < r.size(); ++i)
    force.push_back(std::hypot(r.series("impact_x")[i], r.series("impact_y")[i]));
  const double peak = *std::max_element(force.begin(), force.end()),
               lasts = pressed_time(r.series("time"), force, peak), pushed = peak * lasts * lasts / scene.load.mass,
               L_c = scene.bearing.lateral_capacity();
  if (pushed > suspicious * L_c)
    throw DataError(
        fmt::format("{}: {:.4g} kN at the rim for {:.3g} s would push the mass ({:g} kg) by {:.3g} m, where "
                    "its whole travel is {:.3g} m; are the units of time and force right?",
                    table, peak / 1e3, lasts, scene.load.mass, pushed, L_c));
}

void require_consistent(const StoredRun &run, const std::string &force_unit) {
  check_travel(run);
  check_velocity(run);
  for (const auto &w : run.impacts)
    if (!w.grazing) check_impulse(run, w, force_unit); // of a grazing one other forces change the momentum as much
}

} // namespace rimpact::calibration
