// Whether the rim's steel bears the impacts of the runs, and what became of the slider's edge.
#include "calibration/answer/answer_strain.h"
#include "calibration/laws/percent.h"
#include "responses/steel_limits.h"
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>

namespace rimpact::calibration {
namespace {

constexpr const char *by_johnson_and_cook = "Johnson and Cook", *by_bao_and_wierzbicki = "Bao and Wierzbicki";

/// What of the rim a strain is of.
std::string subject(const JudgedStrain &strain) {
  if (!strain.place) return "The plastic strain of some body, the slider perhaps,";
  return fmt::format("The plastic strain of {}, a mean over {:g} mm around it,", description(*strain.place),
                     1e3 * averaging_radius);
}

/// Where the joint at the foot goes in a run, which no strain of the steel shows; empty: it bears all.
std::string breaking_off(const std::optional<AnswerFoot> &foot) {
  const std::string goes = foot ? foot->goes_in_words() : "";
  return goes.empty() ? "" : fmt::format("The rim breaks off its plate {}, where the joint at its foot goes.", goes);
}

std::string sentence(const AnswerStrain &s, const std::optional<AnswerFoot> &foot) {
  const std::string broken = breaking_off(foot), steel = broken + " In one piece with the plate its steel ";
  const auto limit = fmt::format("its limit of {:.3g} %{}", 100 * s.limit,
                                 s.limit_is_assumption ? " (an assumption: take your steel's)" : "");
  if (!s.exceeded())
    return fmt::format("{} it, up to {:.3g} m/s. {} reaches {}, below {}.",
                       broken.empty() ? "The rim bears" : steel + "would bear", s.rows.back().speed, subject(s.largest),
                       percent_up(s.largest.largest), limit);
  return fmt::format(
      "{} shown to bear it. {} reaches {}, beyond {}. {} The model knows no tearing.",
      broken.empty() ? "The rim is not" : steel + "is not", subject(s.largest), percent_up(s.largest.largest), limit,
      s.largest_speed_below_limit ? fmt::format("Up to {:.3g} m/s it stays below.", *s.largest_speed_below_limit)
                                  : fmt::format("It is beyond already at {:.3g} m/s.", s.rows.front().speed));
}

/// The worst of a number of the runs' steel, with the run's speed and the place.
struct Worst {
  double value = 0, speed = 0;
  std::optional<SteelPlace> place;
  void take(double found, double at_speed, SteelPlace at) {
    if (found > value) value = found, speed = at_speed, place = at;
  }
};

/// Means over averaging_radius of a place in a run.
struct MeansOfRun {
  double speed, damage, strain;
  std::optional<double> locus_damage; ///< none: a run of an earlier version
  double worse_damage() const { return std::max(damage, locus_damage.value_or(0)); }
};

template <class Value> BySpeed by_speed(const std::vector<MeansOfRun> &runs, const Value &value) {
  BySpeed result;
  for (const MeansOfRun &run : runs) result.emplace_back(run.speed, std::invoke(value, run));
  return result;
}

template <class Value> const MeansOfRun &largest(const std::vector<MeansOfRun> &runs, const Value &value) {
  return *std::ranges::max_element(runs, {}, value);
}

/// Both loci cut off at the same triaxiality: a damage by one alone is of a run that does not know the other.
std::optional<double> locus_damage(const SteelAtPlace &at) {
  if (at.averaged_locus_damage == 0 && at.averaged_damage > 0) return {};
  return at.averaged_locus_damage;
}

/// "damage 0.14 at 0.5 m/s (by Bao and Wierzbicki; 0.07 by Johnson and Cook)", of one run.
std::string damage_in_words(const MeansOfRun &run) {
  const bool by_locus = run.worse_damage() > run.damage;
  std::string other;
  if (run.locus_damage)
    other = fmt::format("; {:.2f} by {}", by_locus ? run.damage : *run.locus_damage,
                        by_locus ? by_johnson_and_cook : by_bao_and_wierzbicki);
  return fmt::format("damage {:.2f} at {:.3g} m/s (by {}{})", run.worse_damage(), run.speed,
                     by_locus ? by_bao_and_wierzbicki : by_johnson_and_cook, other);
}

PlaceStrain place_strain(SteelPlace place, const std::vector<MeansOfRun> &runs, double limit) {
  const bool locus_known = std::ranges::all_of(runs, [](const auto &run) { return run.locus_damage.has_value(); });
  PlaceStrain at{.place = place,
                 .crack = passing(by_speed(runs, &MeansOfRun::worse_damage), 1.0),
                 .limit = passing(by_speed(runs, &MeansOfRun::strain), limit),
                 .sentence = {}};
  const MeansOfRun &damaged = largest(runs, &MeansOfRun::damage), &strained = largest(runs, &MeansOfRun::strain);
  at.damage = damaged.damage, at.damage_speed = damaged.speed;
  at.strain = strained.strain, at.strain_speed = strained.speed;
  if (locus_known) {
    const MeansOfRun &by_locus = largest(runs, &MeansOfRun::locus_damage);
    at.locus_damage = by_locus.locus_damage, at.locus_speed = by_locus.speed;
  }
  at.sentence = fmt::format("{}: {}, 1 {}; strain {} at {:.3g} m/s, its limit of {:.3g} % {}", description(place),
                            damage_in_words(largest(runs, &MeansOfRun::worse_damage)), in_words(at.crack),
                            percent_up(at.strain), at.strain_speed, 100 * limit, in_words(at.limit));
  return at;
}

std::vector<PlaceStrain> by_places(const Calibration &c, const std::vector<const StoredRun *> &runs, double limit) {
  std::map<SteelPlace, std::vector<MeansOfRun>> values;
  for (const StoredRun *run : runs) {
    if (run->impacts.empty()) continue;
    for (const auto &[place, at] : c.facts.at(run->folder).steel)
      values[place].push_back({run->approach_speed(), at.averaged_damage, at.averaged, locus_damage(at)});
  }
  std::vector<PlaceStrain> result;
  for (auto &[place, means] : values) {
    std::ranges::sort(means, {}, &MeansOfRun::speed);
    result.push_back(place_strain(place, means, limit_at(c.scene.bearing, place).value_or(limit)));
  }
  return result;
}

/// Whose constants the damage has.
const char *constants_of(const scene::Material &steel) {
  if (steel.fracture == scene::Fracture{}) return "constants of Weldox 460 E, an assumption";
  return steel.has_grade() ? "constants of its grade" : "constants of the bearing's file";
}

/// Of a damage, where the meshes are those it was measured on.
std::string error_of_mesh(const Calibration &c, const std::vector<const StoredRun *> &runs, double damage) {
  constexpr double measured_from = 0.05;
  const bool on_mesh_1 =
      std::ranges::all_of(runs, [&](const StoredRun *run) { return c.facts.at(run->folder).mesh.value_or(0) >= 1; });
  if (damage < measured_from || !on_mesh_1) return "";
  return fmt::format(", which on the reference bearing a finer mesh moves by up to {:.0f} %", 100 * damage_mesh_change);
}

/// The rows, by speed, against the limits of their places; `lowest`: of the rim's side, where a place is not known.
void judge_rows(AnswerStrain &s, const scene::Bearing &bearing, double lowest) {
  const auto share = [&](const JudgedStrain &strain) { return strain.largest / strain.limit.value_or(lowest); };
  for (const auto &row : s.rows)
    if (share(row.strain) > share(s.largest)) s.largest = row.strain;
  for (const auto &row : s.rows) {
    if (share(row.strain) > 1) break;
    s.largest_speed_below_limit = row.speed;
  }
  s.limit = s.largest.limit.value_or(lowest);
  s.limit_is_assumption =
      bearing.assumed.keys.empty() || limit_is_assumed(bearing, s.largest.place.value_or(weakest_of_the_rim(bearing)));
}

} // namespace

std::optional<AnswerStrain> answer_strain(const Calibration &c, const std::vector<const StoredRun *> &runs,
                                          const std::optional<AnswerFoot> &foot) {
  AnswerStrain s;
  Worst crack, slider;
  for (const StoredRun *run : runs) {
    const RunFacts &facts = c.facts.at(run->folder);
    if (!facts.strain || run->impacts.empty()) continue;
    double depth = 0;
    for (const auto &w : run->impacts) depth = std::max(depth, w.impact.peak_penetration);
    s.rows.push_back({run->approach_speed(), depth, *facts.strain});
    for (const auto &[place, at] : facts.steel)
      if (is_of_the_rim(place))
        crack.take(std::max(at.averaged_damage, at.averaged_locus_damage), run->approach_speed(), place);
      else
        slider.take(at.averaged, run->approach_speed(), place);
  }
  const auto &bearing = c.scene.bearing;
  const auto limit = scene::strain_limit(bearing);
  if (s.rows.empty() || !limit) return {};
  std::sort(s.rows.begin(), s.rows.end(), [](const auto &a, const auto &b) { return a.speed < b.speed; });
  judge_rows(s, bearing, *limit);
  const double limit_of_slider = limit_at(bearing, SteelPlace::slider_edge).value_or(*limit);
  s.places = by_places(c, runs, *limit);
  s.sentence = sentence(s, foot);
  if (crack.place)
    s.crack_sentence = fmt::format(
        "A crack begins at a damage of 1; the runs reach {:.2f}, in {} at {:.3g} m/s ({}; a mean over {:g} "
        "mm{}). No crack is in the model: beyond 1 its forces are no result.",
        crack.value, description(*crack.place), crack.speed, constants_of(bearing.steel_of(part_of(*crack.place))),
        1e3 * averaging_radius, error_of_mesh(c, runs, crack.value));
  if (slider.value > limit_of_slider)
    s.slider_sentence = fmt::format("The slider's edge is crushed, by {} at {:.3g} m/s: plan to replace the slider.",
                                    percent_up(slider.value), slider.speed);
  return s;
}

} // namespace rimpact::calibration
