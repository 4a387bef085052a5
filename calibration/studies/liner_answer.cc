#include "calibration/studies/liner_answer.h"
#include "io/files/error.h"
#include "io/files/json_text.h"
#include "responses/crossing.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

/// Height of the slider's side that stands before the wall after this travel [m].
double band_at(const scene::Bearing &bearing, double travel) {
  const double edge = bearing.slider.bottom + lift(bearing, travel);
  return std::min(rim_top(bearing) - edge, bearing.slider.top - bearing.slider.bottom);
}

/// What the wall and its foot do under the force, and whether they bear it.
std::pair<std::string, bool> wall_in_words(const std::optional<WallBehind> &behind, const VaryQuestion &question) {
  if (!behind) return {"the bare wall was not pushed to that force", false};
  std::string text = fmt::format("the bare wall under that force gives way by {:.2f} mm", 1e3 * behind->depth);
  bool bears = true;
  if (behind->strain) {
    text += fmt::format(" and is strained {:.3f}", *behind->strain);
    if (question.strain_limit)
      text += fmt::format(" (limit {:g})", *question.strain_limit), bears &= *behind->strain <= *question.strain_limit;
  }
  if (behind->foot_use)
    text += fmt::format(", its foot used to {:.2f}", *behind->foot_use), bears &= *behind->foot_use <= 1;
  return {text, bears};
}

} // namespace

std::optional<WallBehind> wall_behind(const VaryPoint &rim, double force) {
  const auto &table = rim.table;
  const auto passed = first_crossing(table.peak_force, force);
  if (!passed) return {};
  const auto at = [&](const std::vector<double> &values) -> std::optional<double> {
    return values.empty() ? std::nullopt : std::optional(passed->of(values));
  };
  return WallBehind{.depth = *at(table.depth), .strain = at(table.strain), .foot_use = at(table.foot_use)};
}

LinerAnswer liner_answer(const VaryQuestion &question, const VaryPoint &rim, const scene::Bearing &bearing,
                         double crush_share) {
  if (!(crush_share > 0 && crush_share <= 1))
    throw InputError(fmt::format("--crush {:g} must be > 0 and at most 1", crush_share));
  constexpr double kilo = 1e3;
  const double most = kilo * question.targets.at("peak_kN"),
               energy = question.mass / 2 * question.speed * question.speed;
  const std::string on = fmt::format("Or a sacrificial liner on the wall of {}", in_words(rim.at, question));
  LinerAnswer answer;
  if (bearing.double_concave()) {
    answer.sentence = fmt::format("{}: not sized, for between two dishes two rims share what it would take.", on);
    return answer;
  }
  if (rim.peak_force <= most) {
    answer.sentence = fmt::format("No liner is needed on the wall of {}, which bare stays at {:.0f} kN.",
                                  in_words(rim.at, question), rim.peak_force / kilo);
    return answer;
  }
  try {
    answer.liner = liner_for({.energy = energy,
                              .most_force = most,
                              .slider_radius = bearing.slider.diameter / 2,
                              .wall_radius = bearing.wall_radius(),
                              .crush_share = crush_share});
  } catch (const InputError &error) {
    answer.sentence = fmt::format("{}: {}.", on, error.what());
    return answer;
  }
  answer.travel = bearing.lateral_capacity() - answer.liner->thickness;
  answer.band = band_at(bearing, answer.travel);
  answer.crush_stress = answer.liner->crush_stress(most, answer.band);
  answer.behind = wall_behind(rim, most);
  const auto [wall, bears] = wall_in_words(answer.behind, question);
  const auto yield = bearing.rim_steel().yield;
  const bool softer = !yield || answer.crush_stress < *yield;
  answer.works = softer && bears;
  const std::string size =
      fmt::format("{:.1f} mm thick, crushing at {:.1f} MPa over the {:.1f} mm of the slider's side before it",
                  1e3 * answer.liner->thickness, answer.crush_stress / 1e6, 1e3 * answer.band);
  if (!softer)
    answer.sentence =
        fmt::format("{} would have to be {}, more than the wall's own yield of {:.0f} MPa: none is softer "
                    "than the rim.",
                    on, size, *yield / 1e6);
  else
    answer.sentence = fmt::format(
        "{}: {}, stays at or below {:.0f} kN over a stroke of {:.1f} mm ({:g} % of it) and leaves {:.1f} mm of travel; "
        "{}{}. Assumed: one stress at any speed, nothing springs back, the liner takes all of the energy, each place "
        "once.",
        on, size, most / kilo, 1e3 * answer.liner->stroke, 100 * crush_share, 1e3 * answer.travel, wall,
        bears ? "" : ": it does not do");
  return answer;
}

nlohmann::json to_json(const LinerAnswer &answer, double crush_share) {
  nlohmann::json said{{"works", answer.works}, {"crush_share", crush_share}, {"sentence", answer.sentence}};
  if (!answer.liner) return said;
  said.update({{"thickness_mm", 1e3 * answer.liner->thickness},
               {"stroke_mm", 1e3 * answer.liner->stroke},
               {"chord_mm", 1e3 * answer.liner->chord},
               {"crush_stress_MPa", answer.crush_stress / 1e6},
               {"band_mm", 1e3 * answer.band},
               {"travel_mm", 1e3 * answer.travel},
               {"wall", nullptr}});
  if (answer.behind)
    said["wall"] = {{"depth_mm", 1e3 * answer.behind->depth},
                    {"strain", or_null(answer.behind->strain)},
                    {"rim_foot_use", or_null(answer.behind->foot_use)}};
  return said;
}

} // namespace rimpact::calibration
