#include "calibration/answer/answer_choice.h"
#include "calibration/laws/law_words.h"
#include "calibration/laws/percent.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace rimpact::calibration {

namespace {

std::string range_of(const LawRow &row) {
  if (row.n_valid > 1)
    return fmt::format("meets runs left out from {:.3g} to {:.3g} m/s", *row.valid_from, *row.valid_to);
  return row.n_valid == 1 ? fmt::format("meets runs left out at {:.3g} m/s only", *row.valid_from)
                          : "meets no run left out";
}

std::string better(const LawRow &best, const LawRow &asked, double tolerance) {
  return fmt::format("The law {} is better: it leaves {} of the force unexplained and {} within {:.0f} %. The law {}, "
                     "which was asked for, leaves {} and {}.",
                     best.result.law, percent_of(best.unexplained), range_of(best), 100 * tolerance, asked.result.law,
                     percent_of(asked.unexplained), range_of(asked));
}

/// Whether the user fits just what the ranking fits of the law.
bool fits_all_of(const std::string &law, const FitOptions &fit) {
  std::set<std::string> asked;
  for (const auto &name : fit.parameters)
    if (of_a_law(name)) asked.insert(name);
  const auto own = options_for(law, fit).parameters;
  return asked == std::set<std::string>(own.begin(), own.end());
}

/// Of a fit that no ranking made: its law's exponents that were neither fitted nor given, in words.
std::string held_without_ranking(const FitResult &result, const scene::Scene &scene) {
  std::vector<std::string> held = laws::impact_law(result.law).exponents;
  std::erase_if(held, [&](const auto &name) { return result.parameters.count(name) + result.fixed.count(name) > 0; });
  return held_in_words(held, scene, result.law,
                       "for they are fitted only where laws are compared (--laws) or --fit names them");
}

} // namespace

const LawRow *best_valid(const LawRanking &ranking) {
  if (ranking.rows.empty()) return nullptr;
  const auto found =
      std::find_if(ranking.rows.begin(), ranking.rows.end(), [](const auto &row) { return row.n_valid > 1; });
  return found == ranking.rows.end() ? &ranking.rows.front() : &*found;
}

Choice choose(const Calibration &c, const CalibrationOptions &options, const std::vector<const StoredRun *> &fitted) {
  const LawRow *best = best_valid(c.laws);
  const std::string &law = options.fit.law;
  if (best && law.empty()) return {*best, c.laws.rows.size() > 1 ? ChosenBy::ranking : ChosenBy::only, {}};
  const auto ranked =
      std::find_if(c.laws.rows.begin(), c.laws.rows.end(), [&](const auto &row) { return row.result.law == law; });
  const bool as_ranked = ranked != c.laws.rows.end() && fits_all_of(law, options.fit);
  Choice choice{
      as_ranked ? *ranked : judged(fitted, options.fit, c.result), law.empty() ? ChosenBy::only : ChosenBy::user, {}};
  if (!as_ranked) choice.row.held = held_without_ranking(c.result, fitted.front()->scene);
  if (best && best->result.law != choice.row.result.law) choice.remark = better(*best, choice.row, c.laws.tolerance);
  return choice;
}

} // namespace rimpact::calibration
