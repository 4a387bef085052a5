#include "calibration/answer/answer_foot.h"

#include "calibration/answer/answer.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

FootOfRuns of_rows(std::vector<FootOfRuns::Row> rows) {
  FootOfRuns result{.rows = std::move(rows)};
  std::sort(result.rows.begin(), result.rows.end(), [](const auto &a, const auto &b) { return a.speed < b.speed; });
  BySpeed use;
  for (const auto &row : result.rows)
    if (row.foot.use) use.emplace_back(row.speed, *row.foot.use);
  result.gone = passing(use, 1.0);
  return result;
}

std::optional<double> least_force(const AnswerFoot &f) {
  std::optional<double> least;
  for (const FootOfRuns *steel : {&f.runs, &f.twins})
    for (const auto &row : steel->rows)
      if (const auto &force = row.foot.goes_at_force) least = std::min(least.value_or(*force), *force);
  return least;
}

/// "at 0.5 m/s each mm of it carries 3.10 kN of shear and 118 kN mm of moment".
std::string carried(const FootOfRuns::Row &row) {
  constexpr double kN = 1e3, kN_per_mm = 1e6;
  return fmt::format("at {:.3g} m/s each mm of it carries {:.2f} kN of shear and {:.0f} kN mm of moment", row.speed,
                     row.foot.worst.shear / kN_per_mm, row.foot.worst.moment / kN);
}

std::string used(const FootOfRuns &runs) {
  const auto &hardest = runs.hardest();
  return fmt::format("used to {:.2f} at {:.3g} m/s, 1 {}", *hardest.foot.use, hardest.speed, in_words(runs.gone));
}

std::string sentence(const AnswerFoot &f) {
  const auto &hardest = f.runs.hardest();
  const char *other = f.twins_are_fast ? "fast" : "static";
  const bool twins = !f.twins.rows.empty();
  if (!hardest.foot.use) {
    constexpr double mm = 1e3;
    std::string text = fmt::format(
        "the rim's foot: taken as one piece with the plate, an assumption (bearing.rim.connection); {}; two "
        "fillet welds would need a throat of {:.0f} mm (f_u {:g} MPa)",
        carried(hardest), mm * hardest.foot.needed_throat, f.connection.strength / 1e6);
    if (twins)
      text += fmt::format("; with {} steel {:.0f} mm at {:.3g} m/s", other, mm * f.twins.hardest().foot.needed_throat,
                          f.twins.hardest().speed);
    return text;
  }
  std::string text = fmt::format("the rim's foot, {}: {}", in_words(f.connection), used(f.runs));
  if (twins && f.twins.hardest().foot.use) text += fmt::format("; with {} steel {}", other, used(f.twins));
  return text + "; " + carried(hardest);
}

std::string doubt(const AnswerFoot &f) {
  if (!f.goes_at()) return {};
  const auto borne = f.borne_to();
  return fmt::format(
      "The joint at the rim's foot ({}) goes {}, at a rim force of {:.4g} kN: runs beyond are those of a "
      "rim in one piece with its plate, and the law ends at {}.",
      in_words(f.connection), f.goes_in_words(), *f.goes_at_force / 1e3,
      borne ? fmt::format("{:.3g} m/s", *borne) : "that force");
}

} // namespace

const FootOfRuns::Row &FootOfRuns::hardest() const {
  return *std::max_element(rows.begin(), rows.end(), [](const Row &a, const Row &b) {
    return a.foot.use.value_or(a.foot.weld) < b.foot.use.value_or(b.foot.weld);
  });
}

std::optional<double> AnswerFoot::goes_at() const {
  if (!runs.gone.beyond || !twins.gone.beyond) return runs.gone.beyond ? runs.gone.beyond : twins.gone.beyond;
  return std::min(*runs.gone.beyond, *twins.gone.beyond);
}

std::optional<double> AnswerFoot::borne_to() const {
  for (const FootOfRuns *steel : {&runs, &twins})
    if (steel->gone.beyond && !steel->gone.below) return {};
  std::optional<double> fastest;
  for (const auto &row : runs.rows) {
    const bool beyond = (runs.gone.beyond && row.speed >= *runs.gone.beyond) ||
                        (twins.gone.expected && row.speed > *twins.gone.expected);
    if (!beyond && goes_at()) fastest = row.speed;
  }
  return fastest;
}

std::string AnswerFoot::goes_in_words() const {
  const auto goes = goes_at(), borne = borne_to();
  if (!goes) return {};
  return borne ? fmt::format("between {:.3g} and {:.3g} m/s", *borne, *goes)
               : fmt::format("at {:.3g} m/s or below", *goes);
}

std::optional<AnswerFoot> answer_foot(const Calibration &c, const std::vector<const StoredRun *> &runs,
                                      const std::optional<SteelBand> &band) {
  std::vector<FootOfRuns::Row> rows, twins;
  for (const StoredRun *run : runs)
    if (const auto &foot = c.facts.at(run->folder).foot; foot && !run->impacts.empty())
      rows.push_back({run->approach_speed(), *foot});
  if (rows.empty()) return {};
  AnswerFoot result{.connection = c.scene.bearing.rim.connection,
                    .runs = of_rows(rows),
                    .twins = {},
                    .goes_at_force = {},
                    .sentence = {},
                    .doubt = {}};
  if (band) {
    result.twins_are_fast = band->runs_are_static;
    for (const SteelTwin &twin : band->twins)
      if (const auto &foot = band->runs_are_static ? twin.fast_foot : twin.static_foot)
        twins.push_back({twin.speed, *foot});
    result.twins = of_rows(twins);
  }
  result.goes_at_force = least_force(result);
  result.sentence = sentence(result), result.doubt = doubt(result);
  return result;
}

void end_at_foot(const AnswerFoot &foot, AnswerLaw &law) {
  const auto end = foot.borne_to();
  if (!end || *end < law.fitted_from || law.fitted_to <= *end) return;
  law.fitted_to = *end;
  if (law.valid_from && *law.valid_from > *end) law.valid_from.reset(), law.valid_to.reset();
  if (law.valid_to) law.valid_to = std::min(*law.valid_to, *end);
  law.end = fmt::format("It ends at {:.3g} m/s, the fastest run that the rim's foot bears.", *end);
  law.sentence += " " + law.end;
}

} // namespace rimpact::calibration
