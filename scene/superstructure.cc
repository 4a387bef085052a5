#include "scene/superstructure.h"
#include "io/files/error.h"
#include "scene/keys.h"
#include <fmt/format.h>
#include <numeric>

namespace rimpact::scene {

std::vector<double> Superstructure::floor_masses(double supported) const {
  if (inelastic()) return {mass_ratio * supported};
  if (!masses.empty()) return masses;
  return std::vector<double>(n_floors(), mass_ratio * supported / n_floors());
}

void Superstructure::validate(double supported) const {
  if (kind != StructureKind::shear_building) return;
  const auto check_count = [&](const char *key, std::size_t count) {
    if (count != 0 && count != static_cast<std::size_t>(storeys))
      throw InputError(
          fmt::format("superstructure.{} has {} numbers, superstructure.storeys is {}", key, count, storeys));
  };
  check_count("masses_kg", masses.size());
  check_count("stiffnesses_kN_per_m", stiffnesses.size());
  const double total = std::accumulate(masses.begin(), masses.end(), 0.0);
  if (!(total < supported))
    throw InputError(fmt::format("superstructure.masses_kg add up to {} kg, which leaves the base nothing of "
                                 "load.mass_kg {}",
                                 total, supported));
}

void visit(KeyVisitor &v, Superstructure &s) {
  constexpr Range share{0, 1}, seconds{0, 1e3, true};
  const bool any = v.wants(s.any()), building = v.wants(s.kind == StructureKind::shear_building);
  v.choice({.name = "kind", .meaning = "what the bearing carries"}, s.kind);
  if (any) {
    v.number({"mass_ratio", "gamma = m_s / (m_s + m_b); the base keeps the rest of load.mass_kg"}, s.mass_ratio, si,
             {0, 1, true, true});
    v.number({"period_s", "T_s: elastic, with the base held"}, s.period, si, seconds);
    v.number({"damping_ratio", "xi_s, at that period"}, s.damping_ratio, si, share);
  }
  if (v.wants(s.inelastic())) {
    v.number({"yield_mm", "u_y"}, s.yield, milli, {0, 1e5, true});
    v.number({"post_yield_ratio", "r_H > 0 hardens, r_S < 0 softens and may collapse"}, s.post_yield, si,
             {-1, 1, true, true});
    v.number({"exponent", "of Bouc-Wen: sharpness of the knee"}, s.exponent, si, {1, 50});
    v.number({"beta", "of Bouc-Wen; gamma = 1 - beta"}, s.beta, si, {0.5, 1});
  }
  if (building) {
    v.integer({"storeys", "number of floors above the base"}, s.storeys, 1, 12);
    v.numbers({"masses_kg", "of the floors above the base; empty: alike, by mass_ratio"}, s.masses, si, positive);
    v.numbers({"stiffnesses_kN_per_m", "of the storeys from the base up; empty: alike, by period_s"}, s.stiffnesses,
              kilo, positive);
  }
  if (any) {
    v.number({"vertical_period_s", "2 pi sqrt(m_s / k_v)"}, s.vertical_period, si, {1e-3, 1e3});
    v.number({"vertical_damping_ratio", "at that period"}, s.vertical_damping_ratio, si, share);
  }
}

} // namespace rimpact::scene
