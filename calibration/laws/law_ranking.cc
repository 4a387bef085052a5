#include "calibration/laws/law_ranking.h"
#include "calibration/fit/parallel.h"
#include "calibration/laws/law_errors.h"
#include "calibration/laws/law_words.h"
#include "calibration/laws/percent.h"
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

using Runs = std::vector<const StoredRun *>;

/// Searches for each law: the hardest impact's reading and points spread over the bounds.
constexpr int starts_a_law = 3;

/// `errors` by speed, not empty. Bounds are those measured.
std::string range_sentence(const LawRow &row, const std::vector<LawError> &errors, double tolerance) {
  const auto inside = [&](const LawError &e) {
    return row.valid_from && e.speed >= *row.valid_from && e.speed <= *row.valid_to;
  };
  std::string text;
  if (row.valid_from) {
    double peak = 0, rebound = 0;
    for (const auto &e : errors)
      if (inside(e)) peak = std::max(peak, std::abs(e.peak_force)), rebound = std::max(rebound, std::abs(e.rebound));
    text = fmt::format("{}: predicts runs left out {} (peak force within {}, rebound within {})", row.result.law,
                       row.n_valid > 1 ? fmt::format("from {:.3g} to {:.3g} m/s", *row.valid_from, *row.valid_to)
                                       : fmt::format("at {:.3g} m/s only", *row.valid_from),
                       percent_up(peak), percent_up(rebound));
  } else
    text = fmt::format("{}: predicts peak force and rebound within {:.0f} % at none of {} runs left out",
                       row.result.law, 100 * tolerance, errors.size());
  for (const LawError *end : {&errors.front(), &errors.back()})
    if (!inside(*end) && !std::isnan(end->peak_force) && (end == &errors.front() || errors.size() > 1))
      text += fmt::format("; at {:.3g} m/s the peak force is {} by {}, the rebound by {:+.0f} %", end->speed,
                          end->peak_force > 0 ? "overstated" : "understated", percent_up(std::abs(end->peak_force)),
                          100 * end->rebound);
  return text;
}

/// Empty without an error, or with one that is not known.
std::optional<double> largest(const std::vector<LawError> &errors, double LawError::*of) {
  double found = errors.empty() ? NAN : 0;
  for (const auto &error : errors) found = larger_of(found, std::abs(error.*of));
  return known(found);
}

/// The longest range of neighbouring speeds at which runs not fitted are met.
void find_range(LawRow &row, double tolerance) {
  const std::vector<LawError> errors = left_out_runs(row);
  int n = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const bool met = std::abs(errors[i].peak_force) <= tolerance && std::abs(errors[i].rebound) <= tolerance;
    n = met ? n + 1 : 0;
    if (n <= row.n_valid) continue;
    row.n_valid = n;
    row.valid_from = errors[i + 1 - n].speed, row.valid_to = errors[i].speed;
  }
  if (!errors.empty()) row.sentence = range_sentence(row, errors, tolerance);
}

} // namespace

std::vector<LawError> left_out_runs(const LawRow &row) {
  std::vector<LawError> errors;
  for (const auto &left : row.left_out)
    if (left.errors.size() == 1 && left.errors[0].folder == left.what && !left.errors[0].grazing)
      errors.push_back(left.errors[0]);
  std::sort(errors.begin(), errors.end(), [](const auto &a, const auto &b) { return a.speed < b.speed; });
  return errors;
}

LawRow judged(const Runs &runs, const FitOptions &options, const FitResult &result, double tolerance) {
  LawRow row;
  row.result = result;
  std::vector<LawError> firm; // grazing runs apart
  for (const StoredRun *run : runs) {
    row.fitted.push_back(error_of(*run, row.result));
    if (!row.fitted.back().grazing) firm.push_back(row.fitted.back());
  }
  double square = 0;
  for (const auto &error : firm) square += error.unexplained * error.unexplained / static_cast<double>(firm.size());
  row.unexplained = known(firm.empty() ? NAN : std::sqrt(square));
  row.largest_peak_error = largest(firm, &LawError::peak_force);
  row.largest_rebound_error = largest(firm, &LawError::rebound);
  row.left_out = leave_out(runs, options, row.result);
  const auto left_out = left_out_runs(row);
  row.left_out_peak_error = largest(left_out, &LawError::peak_force);
  row.left_out_rebound_error = largest(left_out, &LawError::rebound);
  find_range(row, tolerance);
  return row;
}

namespace {

/// With this many impacts one can be left out and two still tell a curve's shape from its size.
constexpr int enough_for_exponents = 3;

bool tells_all(const LawRow &row) {
  return std::all_of(row.result.parameters.begin(), row.result.parameters.end(),
                     [](const auto &entry) { return entry.second.identifiable; });
}

/// The law's exponents join once its other parameters are found. They stay if runs left out are then predicted better:
/// on the runs fitted two more parameters always look well. Where the impacts are fewer than the parameters, the curves
/// must also tell each of them.
LawRow row_of(const Runs &runs, FitOptions options, double tolerance) {
  std::vector<std::string> exponents = laws::impact_law(options.law).exponents;
  std::erase_if(exponents, [&](const auto &name) { return options.fixed.count(name) > 0; });
  FitOptions plain = options;
  for (const auto &name : exponents) plain.bounds.erase(name);
  LawRow row = judged(runs, plain, fit(runs, plain), tolerance);
  options.parameters.insert(options.parameters.end(), exponents.begin(), exponents.end());
  if (exponents.empty()) return row;
  if (row.result.n_impacts < enough_for_exponents) {
    row.held = held_in_words(exponents, runs.front()->scene, options.law,
                             fmt::format("for {} impacts do not tell a shape", row.result.n_impacts));
    return row;
  }
  for (const auto &name : plain.parameters) options.start[name] = row.result.parameters.at(name).value;
  options.n_starts = 0;
  const LawRow shaped = judged(runs, options, fit(runs, options), tolerance);
  const auto worst = [](const LawRow &r) { return std::max(r.left_out_peak_error, r.left_out_rebound_error); };
  const bool wider = shaped.n_valid > row.n_valid; // first: a run beyond what any exponents can follow does not decide
  const bool better = wider || (shaped.n_valid == row.n_valid && worst(shaped) < worst(row));
  const bool many = row.result.n_impacts >= static_cast<int>(options.parameters.size());
  if (better && (many || tells_all(shaped))) return shaped;
  row.held =
      held_in_words(exponents, runs.front()->scene, options.law,
                    better ? "for the curves do not tell them" : "for with them runs left out are not met better");
  return row;
}

} // namespace

bool of_a_law(const std::string &parameter) {
  const auto &laws = laws::impact_laws();
  return std::any_of(laws.begin(), laws.end(), [&](const auto *law) { return law->reads(parameter); });
}

FitOptions options_for(const std::string &law, const FitOptions &given) {
  FitOptions own = given;
  own.law = law;
  own.parameters = laws::impact_law(law).parameters;
  own.start.clear();
  own.n_starts = std::clamp(given.n_starts, 1, starts_a_law);
  const auto read = [&](const std::string &name) { return laws::impact_law(law).reads(name); };
  std::erase_if(own.bounds, [&](const auto &entry) { return !read(entry.first); });
  std::erase_if(own.fixed, [&](const auto &entry) { return of_a_law(entry.first) && !read(entry.first); });
  for (const auto &[name, value] : own.fixed) std::erase(own.parameters, name), own.bounds.erase(name);
  return own;
}

namespace {

/// A law's row, or why there is none.
struct Ranked {
  std::optional<LawRow> row;
  std::string note;
};
Ranked ranked(const Runs &runs, const std::string &law, const FitOptions &options, double tolerance) {
  const FitOptions own = options_for(law, options);
  if (laws::impact_law(law).parameters.empty())
    return {{}, fmt::format("the law {} is not ranked: it has no parameters to fit", law)};
  if (own.parameters.empty()) return {{}, fmt::format("the law {} is not ranked: all its parameters are fixed", law)};
  try {
    return {row_of(runs, own, tolerance), {}};
  } catch (const DataError &error) {
    return {{}, fmt::format("the law {} is not ranked: {}", law, error.what())};
  }
}

} // namespace

LawRanking rank_laws(const std::vector<const StoredRun *> &runs, const std::vector<std::string> &laws,
                     const FitOptions &options, std::vector<std::string> &notes, double tolerance) {
  LawRanking ranking{.tolerance = tolerance, .rows = {}, .sentence = {}};
  Runs struck;
  for (const StoredRun *run : runs)
    if (!run->impacts.empty()) struck.push_back(run);
  for (auto &[row, note] :
       parallel_map(laws, [&](const std::string &law) { return ranked(struck, law, options, tolerance); })) {
    if (row)
      ranking.rows.push_back(std::move(*row));
    else
      notes.push_back(note);
  }
  std::sort(ranking.rows.begin(), ranking.rows.end(), [](const auto &a, const auto &b) {
    return a.unexplained.value_or(INFINITY) < b.unexplained.value_or(INFINITY);
  });
  if (ranking.rows.empty()) return ranking;
  const auto &best = ranking.rows.front();
  ranking.sentence = fmt::format("The law that leaves least unexplained is {} ({} of the force)", best.result.law,
                                 percent_of(best.unexplained));
  ranking.sentence += best.sentence.empty() ? "." : "; " + best.sentence + ".";
  return ranking;
}

} // namespace rimpact::calibration
