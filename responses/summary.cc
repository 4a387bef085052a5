#include "responses/summary.h"
#include "io/files/json_text.h"
#include "responses/open_impact.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <sys/resource.h>

namespace rimpact {
namespace {

double largest_norm(const Response &r, const std::string &name) {
  const auto &x = r.series(name + "_x"), &y = r.series(name + "_y");
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::hypot(x[i], y[i]));
  return largest;
}

/// Outward radial speed; from the stored velocities, or one-sided differences of the radius where none are
/// stored
/// (`side` -1: before the sample, +1: after it).
double radial_speed(const Response &r, std::size_t i, int side) {
  const auto &ux = r.series("displacement_x"), &uy = r.series("displacement_y");
  const double radius = std::hypot(ux[i], uy[i]);
  if (r.has("velocity_x") && r.has("velocity_y")) {
    const double vx = r.series("velocity_x")[i], vy = r.series("velocity_y")[i];
    return radius > 0 ? (ux[i] * vx + uy[i] * vy) / radius : std::hypot(vx, vy);
  }
  const auto &time = r.series("time");
  if ((side < 0 && i == 0) || (side > 0 && i + 1 >= time.size())) return 0;
  const std::size_t j = side < 0 ? i - 1 : i + 1;
  const double dt = time[i] - time[j];
  return dt != 0 ? (radius - std::hypot(ux[j], uy[j])) / dt : 0;
}

/// From the last pressed sample to where its force, falling on as before it, is gone; in shares of the step to the next
/// sample. The dish and friction change the speed by up to 3 mm/s in a millisecond.
double release_after(const std::vector<double> &time, double before, double at, std::size_t last) {
  if (last + 1 >= time.size() || last == 0 || !(at < before)) return 0;
  return std::min(1.0, at / (before - at) * (time[last] - time[last - 1]) / (time[last + 1] - time[last]));
}

/// Of the rim that pushes the mass [m]. A triple pendulum's gap is counted to the last of its rims, which need not be
/// it.
double penetration(const Response &r, std::size_t i) {
  if (r.has("face_4_rim_penetration")) return r.series("face_4_rim_penetration")[i];
  return r.has("gap") ? -r.series("gap")[i] : 0.0;
}

Impact impact_of(const Response &r, std::size_t first, std::size_t last) {
  const auto &ux = r.series("displacement_x"), &uy = r.series("displacement_y");
  const auto &ix = r.series("impact_x"), &iy = r.series("impact_y"), &time = r.series("time");
  const auto force = [&](std::size_t i) { return std::hypot(ix[i], iy[i]); };
  const double after = last > first ? release_after(time, force(last - 1), force(last), last) : 0;
  Impact impact{};
  impact.touch_time = time[first];
  impact.release_time = after > 0 ? time[last] + after * (time[last + 1] - time[last]) : time[last];
  impact.direction_deg = std::atan2(uy[first], ux[first]) * 180 / std::numbers::pi;
  impact.approach_speed = radial_speed(r, first, -1);
  impact.rebound_speed = 0 - (1 - after) * radial_speed(r, last, +1); // never -0
  if (after > 0) impact.rebound_speed -= after * radial_speed(r, last + 1, -1);
  for (std::size_t i = first; i <= last; ++i) {
    impact.peak_force = std::max(impact.peak_force, force(i));
    impact.peak_penetration = std::max(impact.peak_penetration, penetration(r, i));
  }
  return impact;
}

std::vector<Impact> impacts_of(const Response &r) {
  const auto &ix = r.series("impact_x"), &iy = r.series("impact_y");
  const auto pressed = [&](std::size_t i) { return i < ix.size() && (ix[i] != 0 || iy[i] != 0); };
  std::vector<Impact> impacts;
  for (std::size_t i = 0; i < ix.size(); ++i) {
    if (!pressed(i)) continue;
    const std::size_t first = i;
    while (pressed(i + 1)) ++i;
    impacts.push_back(impact_of(r, first, i));
  }
  return impacts;
}

/// A run that stops while the rim is pressed has no release, and so no rebound: its release lies before its touch.
nlohmann::json to_json(const Impact &impact) {
  const bool released = impact.release_time >= impact.touch_time;
  const auto if_released = [&](double value) { return released ? nlohmann::json(value) : nlohmann::json(nullptr); };
  nlohmann::json json{{"touch_time_s", impact.touch_time},
                      {"release_time_s", if_released(impact.release_time)},
                      {"direction_deg", impact.direction_deg},
                      {"approach_speed_m_s", impact.approach_speed},
                      {"rebound_speed_m_s", if_released(impact.rebound_speed)},
                      {"restitution", if_released(impact.restitution())},
                      {"peak_force_N", impact.peak_force},
                      {"peak_penetration_m", impact.peak_penetration}};
  if (impact.impulse) json["impulse_N_s"] = *impact.impulse;
  return json;
}

nlohmann::json to_json(const EnergyLedger &e) {
  return {{"external_J", e.external},     {"gravity_J", e.gravity}, {"kinetic_J", e.kinetic},
          {"elastic_J", e.elastic},       {"plastic_J", e.plastic}, {"damping_J", e.damping},
          {"friction_J", e.friction},     {"impact_J", e.impact},   {"contact_J", e.contact},
          {"integrator_J", e.integrator}, {"initial_J", e.initial}, {"imbalance_relative", e.imbalance_relative()}};
}

double unaccounted(const EnergyLedger &e) { // [J]
  return e.initial + e.external -
         (e.gravity + e.kinetic + e.elastic + e.plastic + e.damping + e.friction + e.impact + e.contact + e.integrator);
}
/// What is put in, or what is exchanged where hardly anything is: a bearing that settles under its load. [J]
double largest_energy(const EnergyLedger &e) {
  double largest = std::max(e.largest_input, std::abs(e.external) + std::abs(e.initial));
  for (const double term : {e.gravity, e.kinetic, e.elastic, e.plastic, e.damping, e.friction, e.impact, e.contact})
    largest = std::max(largest, std::abs(term));
  return largest;
}

} // namespace

double EnergyLedger::imbalance_relative() const {
  const double input = largest_energy(*this);
  return input > 0 ? unaccounted(*this) / input : 0;
}

nlohmann::json to_json(const Summary &s) {
  nlohmann::json json{{"peak_displacement_m", s.peak_displacement},
                      {"peak_lateral_force_N", s.peak_lateral_force},
                      {"peak_impact_force_N", or_null(s.peak_impact_force)},
                      {"n_impacts", s.impacts.size()},
                      {"impacts", nlohmann::json::array()},
                      {"residual_displacement_m", s.residual_displacement},
                      {"final_speed_m_s", or_null(s.final_speed)},
                      {"peak_vertical_displacement_m", s.peak_vertical_displacement},
                      {"min_normal_force_N", or_null(s.min_normal_force)},
                      {"max_plastic_strain", or_null(s.max_plastic_strain)},
                      {"energy", s.energy ? to_json(*s.energy) : nlohmann::json(nullptr)},
                      {"rung", word(s.rung)},
                      {"mesh", or_null(s.mesh)},
                      {"n_dofs", s.n_dofs},
                      {"n_steps", s.n_steps},
                      {"n_newton_iterations", s.n_newton_iterations},
                      {"wall_time_s", s.wall_time},
                      {"processor_time_s", or_null(s.processor_time)},
                      {"peak_memory_bytes", s.peak_memory_bytes},
                      {"status", word(s.status)}};
  for (const auto &impact : s.impacts) json["impacts"].push_back(to_json(impact));
  for (const char *part : {"search", "assembly", "factor", "solve", "output"}) {
    const auto found = s.time_split.find(part);
    json["time_split_s"][part] = found == s.time_split.end() ? 0.0 : found->second;
  }
  if (s.status != RunStatus::done) json["reason"] = s.reason;
  if (!s.steel.empty()) json["steel"] = to_json(s.steel);
  if (s.extra.is_object()) json.update(s.extra);
  return json;
}

void summarise_response(const Response &r, Summary &s) {
  if (r.size() == 0) return;
  s.peak_displacement = largest_norm(r, "displacement");
  s.peak_lateral_force = largest_norm(r, "force");
  s.residual_displacement = std::hypot(r.series("displacement_x").back(), r.series("displacement_y").back());
  if (r.has("velocity_x") && r.has("velocity_y"))
    s.final_speed = std::hypot(r.series("velocity_x").back(), r.series("velocity_y").back());
  const auto largest = [&](const char *name) {
    const auto &values = r.series(name);
    return *std::max_element(values.begin(), values.end());
  };
  if (r.has("displacement_z")) s.peak_vertical_displacement = largest("displacement_z");
  if (r.has("plastic_strain_max")) s.max_plastic_strain = largest("plastic_strain_max");
  if (r.has("normal_force"))
    s.min_normal_force = *std::min_element(r.series("normal_force").begin(), r.series("normal_force").end());
  if (!r.has("impact_x") || !r.has("impact_y")) return;
  s.peak_impact_force = largest_norm(r, "impact");
  s.impacts = impacts_of(r);
}

void add_impulses(const Response &r, std::vector<Impact> &impacts) {
  const auto &time = r.series("time"), &x = r.series("impact_x"), &y = r.series("impact_y");
  constexpr double same = 1e-12; // instant [s]
  for (auto &impact : impacts) {
    impact.impulse = 0;
    const auto first = std::upper_bound(time.begin(), time.end(), impact.touch_time - same);
    for (auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(first - time.begin(), 1));
         i < time.size() && (is_open(impact) || time[i - 1] < impact.release_time + same); ++i)
      *impact.impulse += (time[i] - time[i - 1]) / 2 * (std::hypot(x[i - 1], y[i - 1]) + std::hypot(x[i], y[i]));
  }
}

std::optional<std::string> doubt_of_rebound(const Response &response, const std::vector<Impact> &impacts) {
  if (impacts.empty() || response.size() == 0 || !response.has("impact_x")) return {};
  const double force = std::hypot(response.series("impact_x").back(), response.series("impact_y").back());
  const double peak = impacts.back().peak_force;
  if (!still_bears(force, peak)) return {};
  return fmt::format("the scene ends while the rim still bears {:.0f} kN ({:.0f} % of the impact's peak): rebound "
                     "speed and restitution of this impact are not known; set a longer excitation.duration_s",
                     1e-3 * force, 100 * force / peak);
}

std::optional<std::string> doubt_of_bounce(const Response &response) {
  constexpr double off = 1e-3, until_back = 0.1; // of the normal force at first; [s]
  if (response.size() == 0 || !response.has("normal_force") || !response.has("pad_pressure_max")) return {};
  if (response.has("energy_damping") && response.series("energy_damping").back() > 0) return {};
  const auto &normal = response.series("normal_force"), &t = response.series("time");
  const auto first = std::find_if(normal.begin(), normal.end(), [&](double N) { return N < off * normal.front(); });
  if (first == normal.end() || t.back() - t[first - normal.begin()] < until_back) return {};
  return fmt::format("the slider leaves the dish at t = {:.3f} s and lands again, and nothing damps the bounces that "
                     "follow: later impacts, and where it comes to rest, depend on what a pad loses "
                     "(bearing.pad.loss_factor, of one dish)",
                     t[first - normal.begin()]);
}

std::optional<std::string> doubt_of_ledger(const EnergyLedger &ledger) {
  constexpr double usual = 1e-3; // what every dynamic scene is to keep
  const double left = ledger.imbalance_relative();
  constexpr double nothing = 1e-6; // [J]: the rounding of a bearing at rest, where a share has no meaning
  if (std::abs(left) <= usual || std::abs(unaccounted(ledger)) <= nothing) return {};
  return fmt::format("{:.2f} % of the energy put in is unaccounted for, where 0.1 % is usual: doubt the forces; "
                     "smaller steps or a finer mesh (model.step_ms, "
                     "model.mesh) may mend a finite-element run, a smaller reduced.tolerance a reduced one",
                     100 * left);
}

std::optional<std::string> doubt_of_contact(const EnergyLedger &ledger, const std::vector<Impact> &impacts,
                                            double mass) {
  constexpr double usual = 3e-3; // of the energy put in
  const double created = -ledger.contact,
               input = std::max(ledger.largest_input, std::abs(ledger.external) + std::abs(ledger.initial));
  if (!(created > usual * input)) return {};
  double rebound = 0;
  for (const auto &impact : impacts) rebound += 0.5 * mass * impact.rebound_speed * impact.rebound_speed;
  std::string text =
      fmt::format("contact has given back {:.2f} % more energy than it took, where up to {:.1f} % is usual",
                  100 * created / input, 100 * usual);
  if (rebound > created)
    text += fmt::format(": rebound speeds are overstated by about {:.1f} %", 50 * created / rebound);
  return text + "; a smaller model.step_ms lowers it";
}

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval &time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

long peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024L; // Linux counts in KiB
}

} // namespace rimpact
