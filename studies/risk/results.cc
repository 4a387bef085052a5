#include "studies/risk/results.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "io/files/table_csv.h"
#include "io/files/table_hdf5.h"
#include "studies/reliability/failure_rate.h"
#include "studies/risk/collapse_check.h"
#include "studies/risk/comparisons.h"
#include "studies/risk/disaggregation.h"
#include "studies/risk/rate_doubts.h"
#include "studies/risk/reductions.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::risk {
namespace {

using nlohmann::ordered_json;

/// A counted fractile, runs that went beyond above all others: empty where it is one of them.
Cell fractile(std::vector<double> values, std::size_t n_beyond, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() + n_beyond - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = static_cast<std::size_t>(std::ceil(place));
  if (above >= values.size()) return {};
  return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

class Writer {
public:
  Writer(const Study &study, const Systems &systems) : study_(study), systems_(systems) {
    runs = GatheredTable(keys());
    begin("ida", {"quantity", "level_g", "n_records", "n_runs", "n_beyond", "n_zero", "n_without_result", "p16", "p50",
                  "p84", "mean_ln", "sigma_ln", "fit_p16", "fit_p50", "fit_p84", "n_hit", "hit_probability"});
    begin("fragility", {"quantity", "limit", "level_g", "probability", "low", "high", "counted", "n_unknown", "least",
                        "most", "fitted", "source", "counted_low", "counted_high", "curve"});
    begin("reliability", {"quantity",
                          "limit",
                          "rate_per_year",
                          "rate_low",
                          "rate_high",
                          "rate_below_levels",
                          "rate_above_levels",
                          "years",
                          "probability",
                          "probability_low",
                          "probability_high",
                          "probability_most",
                          "n_unknown",
                          "probability_if_none",
                          "probability_if_all",
                          "rate_by_lognormals",
                          "rate_range_low",
                          "rate_range_high",
                          "probability_range_low",
                          "probability_range_high",
                          "settled",
                          "rate_counted",
                          "rate_flat",
                          "probability_flat",
                          "curve_median_g",
                          "curve_deviation",
                          "curve_test"});
    begin("difference",
          {"key", "reference_system", "quantity", "limit", "probability", "reference_probability", "reduction",
           "reduction_low", "reduction_high", "n_unknown", "reduction_at_least", "reduction_at_most"});
    begin("levels", {"quantity", "limit", "level_g", "share"});
    begin("records", {"quantity", "limit", "record", "share"});
    begin("sensitivity", {"quantity", "limit", "key", "elasticity"});
    begin("hits", {"level_g", "n_hits", "fastest_approach_speed_m_s", "known_to_m_s", "share_beyond_fit",
                   "share_beyond_pair", "share_beyond_rim", "share_beyond_steel"});
  }

  void add(std::size_t system, const ResponseSet &set, const SystemSample &sample,
           const std::vector<LimitResult> &limits, RateDoubts &doubts) {
    add_ida(system, set, sample);
    add_hits(system, set);
    for (const auto &limit : limits) {
      add_limit(system, set, limit);
      const Disaggregation why = disaggregate(set, sample, limit);
      add_disaggregation(system, set, limit, why);
      doubts.add(system, quantity(limit), limit, why.tail);
    }
  }

  void add_difference(const Comparison &c, const std::vector<LimitResult> &limits,
                      const std::vector<LimitResult> &reference, const std::vector<Banded> &reductions) {
    for (std::size_t i = 0; i < limits.size(); ++i)
      row("difference", c.system,
          {study_.differences[c.difference].key, double(c.reference + 1), quantity(limits[i]), limits[i].limit,
           limits[i].probability.value, reference[i].probability.value, reductions[i].value, reductions[i].low,
           reductions[i].high, double(limits[i].n_unknown + reference[i].n_unknown),
           reduction(limits[i].if_all, reference[i].if_none), reduction(limits[i].if_none, reference[i].if_all)});
  }

  /// Of a system's rows: its number and its keys.
  std::vector<Cell> values_of(std::size_t system) const {
    std::vector<Cell> values{double(system + 1)};
    values.insert(values.end(), systems_.all[system].values.begin(), systems_.all[system].values.end());
    return values;
  }

  std::map<std::string, Table> tables;
  GatheredTable runs;

private:
  std::vector<std::string> keys() const {
    std::vector<std::string> names{"system"};
    names.insert(names.end(), systems_.keys.begin(), systems_.keys.end());
    return names;
  }
  void begin(const std::string &name, const std::vector<std::string> &columns) {
    Table &table = tables[name];
    table.meta = {{"study", study_.name}, {"scene", study_.scene}};
    table.columns = keys();
    table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  }
  void row(const std::string &name, std::size_t system, const std::vector<Cell> &cells) {
    std::vector<Cell> all = values_of(system);
    all.insert(all.end(), cells.begin(), cells.end());
    tables[name].rows.push_back(std::move(all));
  }
  const std::string &quantity(const LimitResult &limit) const { return study_.limits[limit.quantity].quantity; }

  void add_ida(std::size_t system, const ResponseSet &set, const SystemSample &sample) {
    for (std::size_t k = 0; k < study_.limits.size(); ++k) {
      const auto models = sample.levels(k, sample.once());
      for (std::size_t i = 0; i < set.levels.size(); ++i) {
        const auto &level = set.levels[i];
        const auto &model = models[i].finished;
        std::vector<double> values;
        for (const auto &run : level.runs)
          if (!run.beyond) values.push_back(run.values[k]);
        const std::size_t n_beyond = level.runs.size() - values.size();
        std::vector<Cell> cells{study_.limits[k].quantity,      level.intensity_g, double(level.n_records),
                                double(level.runs.size()),      double(n_beyond),  double(model.n_zero),
                                double(level.unfinished.size())};
        for (const double share : {0.16, 0.5, 0.84}) cells.push_back(fractile(values, n_beyond, share));
        if (model.fit) {
          const auto &fit = model.fit->distribution;
          cells.insert(cells.end(), {fit.mean_ln, fit.sigma_ln});
          for (const double share : {0.16, 0.5, 0.84}) cells.emplace_back(fit.quantile(share));
        }
        cells.resize(15);
        const auto n_hit = std::count_if(level.runs.begin(), level.runs.end(), [](const auto &run) { return run.hit; });
        cells.emplace_back(static_cast<double>(n_hit));
        cells.push_back(models[i].apart ? Cell(models[i].apart->hit_share) : Cell());
        row("ida", system, cells);
      }
    }
  }

  void add_hits(std::size_t system, const ResponseSet &set) {
    const auto cell = [](const std::optional<double> &value) { return value ? Cell(*value) : Cell(); };
    for (const auto &level : set.levels) {
      const auto &h = level.hits;
      row("hits", system,
          {level.intensity_g, static_cast<double>(h.n_hits()), cell(h.fastest()), cell(h.known_to()),
           cell(h.fit().share()), cell(h.pair().share()), cell(h.rim().share()), cell(h.steel().share())});
    }
  }

  void add_limit(std::size_t system, const ResponseSet &set, const LimitResult &r) {
    for (std::size_t i = 0; i < set.levels.size(); ++i)
      row("fragility", system,
          {quantity(r), r.limit, set.levels[i].intensity_g, r.fragility[i].value, r.fragility[i].low,
           r.fragility[i].high, r.counted[i], double(r.bounds[i].n_unknown), r.bounds[i].least, r.bounds[i].most,
           r.fitted[i], std::string(r.is_counted[i] ? "counted" : "fitted"), r.checks[i].low, r.checks[i].high,
           r.across ? Cell(r.across->at(set.levels[i].intensity_g)) : Cell()});
    row("reliability", system,
        {quantity(r),
         r.limit,
         r.rate.value,
         r.rate.low,
         r.rate.high,
         r.below,
         r.above,
         study_.years,
         r.probability.value,
         r.probability.low,
         r.probability.high,
         r.probability_most,
         double(r.n_unknown),
         r.if_none,
         r.if_all,
         r.rate_fitted,
         r.range.least,
         r.range.most ? Cell(*r.range.most) : Cell(),
         r.probability_least,
         r.probability_range_most,
         double(is_settled(r)),
         r.rate_checked,
         r.rate_flat,
         reliability::probability_in(study_.years, r.rate_flat),
         r.across ? Cell(r.across->median()) : Cell(),
         r.across ? Cell(r.across->deviation()) : Cell(),
         r.across ? Cell(r.test_across) : Cell()});
  }

  void add_disaggregation(std::size_t system, const ResponseSet &set, const LimitResult &r, const Disaggregation &d) {
    constexpr double least = 0.005;
    for (std::size_t i = 0; i < set.levels.size(); ++i)
      row("levels", system, {quantity(r), r.limit, set.levels[i].intensity_g, d.levels[i]});
    for (std::size_t i = 0; i < set.records.size(); ++i)
      if (d.records[i] >= least) row("records", system, {quantity(r), r.limit, set.records[i], d.records[i]});
    if (d.tail >= least) row("records", system, {quantity(r), r.limit, std::string(), d.tail});
    for (std::size_t i = 0; i < set.inputs.size(); ++i)
      row("sensitivity", system,
          {quantity(r), r.limit, set.inputs[i], std::isnan(d.elasticities[i]) ? Cell() : Cell(d.elasticities[i])});
  }

  const Study &study_;
  const Systems &systems_;
};

Table table_of(const Motions &motions) {
  Table table;
  table.columns = {"level_g", "return_period_years", "record", "file", "scale", "scaled_sa_over_level"};
  for (const auto &level : motions.levels)
    for (const auto &motion : level.motions)
      table.rows.push_back(
          {level.intensity_g, level.return_period_years, motion.record, motion.file, motion.scale, motion.over_level});
  return table;
}

std::vector<double> levels_without_result(const Motions &motions, const ResponseSet &set) {
  std::vector<double> levels;
  for (const auto &level : motions.levels) {
    const auto is_it = [&](const ResponseLevel &r) { return r.intensity_g == level.intensity_g; };
    if (!level.motions.empty() && std::none_of(set.levels.begin(), set.levels.end(), is_it))
      levels.push_back(level.intensity_g);
  }
  return levels;
}

std::vector<double> levels_of(const Motions &motions) {
  std::vector<double> levels;
  for (const auto &level : motions.levels) levels.push_back(level.intensity_g);
  return levels;
}

ordered_json levels_json(const Motions &motions) {
  auto levels = ordered_json::array();
  for (const auto &level : motions.levels)
    levels.push_back({{"level_g", level.intensity_g},
                      {"return_period_years", level.return_period_years},
                      {"n_records", level.motions.size()},
                      {"n_listed", level.n_listed}});
  return levels;
}

/// Runs that leave their rim behind.
void doubt_rims(std::size_t system, const ResponseSet &set, std::vector<std::string> &doubts) {
  if (set.n_through_rim > 0)
    doubts.push_back(fmt::format("system {}: {} runs pressed deeper into the rim than it is thick. Such a rim has "
                                 "failed: they count for limits of the travel, of others nothing is known",
                                 system + 1, set.n_through_rim));
  if (set.n_past_wall > 0)
    doubts.push_back(fmt::format("system {}: {} runs went past the wall of a rim that they leave out, by more than its "
                                 "thickness; they count as if there were none",
                                 system + 1, set.n_past_wall));
}

} // namespace

Results evaluate_study(const Study &study, const Systems &systems, const Motions &motions, const std::string &folder,
                       const std::function<void(std::size_t)> &done) {
  Writer writer(study, systems);
  std::vector<SystemSample> samples;
  std::vector<std::vector<LimitResult>> limits;
  std::size_t n_without = 0;
  fleets::HitShares hits;
  RateDoubts rates;
  std::vector<CollapseCheck> checks;
  const bool has_own_bounds = fleets::ImplausibleRuns(study.parts.plausible).bound_the_frame();
  std::vector<std::string> doubts = motions.doubts;
  for (std::size_t s = 0; s < systems.size(); ++s) {
    const ResponseSet set = collect(study, folder_of_system(folder, s), motions);
    for (const auto &level : set.levels) n_without += level.unfinished.size(), hits.add(level.hits);
    doubt_rims(s, set, doubts);
    for (const auto &doubt : set.implausible.doubts()) doubts.push_back(fmt::format("system {}: {}", s + 1, doubt));
    for (const double level : levels_without_result(motions, set))
      doubts.push_back(fmt::format("system {}: no run at {:.4g} g has a result; its fragility is made without that "
                                   "level",
                                   s + 1, level));
    samples.emplace_back(study, set);
    limits.push_back(evaluate(study, set, samples.back()));
    if (study.collapse) checks.push_back(collapse_check(study, limits.back(), samples.back().intensities()));
    writer.add(s, set, samples.back(), limits.back(), rates);
    writer.runs.add(folder_of_system(".", s).substr(2) + "/table.h5", set.runs, writer.values_of(s));
    if (done) done(s + 1);
  }
  for (const auto &sentences :
       {rates.sentences(levels_of(motions)), hits.doubts(!has_own_bounds)}) // before those of single systems
    doubts.insert(doubts.begin() + static_cast<std::ptrdiff_t>(motions.doubts.size()), sentences.begin(),
                  sentences.end());
  Reductions sums;
  for (const auto &c : comparisons(study, systems)) {
    if (samples[c.system].n_levels() != samples[c.reference].n_levels()) continue; // a level without any result
    const auto all = reductions(study, samples[c.system], samples[c.reference]);
    writer.add_difference(c, limits[c.system], limits[c.reference], all);
    const auto &key = study.differences[c.difference].key;
    const auto at = std::find(systems.keys.begin(), systems.keys.end(), key) - systems.keys.begin();
    for (std::size_t i = 0; i < all.size(); ++i)
      sums.add(key, systems.all[c.system].values[static_cast<std::size_t>(at)],
               study.limits[limits[c.system][i].quantity].quantity, limits[c.system][i], limits[c.reference][i],
               all[i]);
  }
  Results results{std::move(writer.tables), std::move(writer.runs), {}};
  results.tables["motions"] = table_of(motions);
  auto hazard = ordered_json::array();
  for (const auto &point : study.hazard) hazard.push_back({point.intensity, point.return_period_years});
  results.summary = {{"study", study.name},
                     {"scene", study.scene},
                     {"years", study.years},
                     {"period_s", study.period_s},
                     {"n_systems", systems.size()},
                     {"keys", systems.keys},
                     {"samples", std::max(1, study.parts.samples)},
                     {"n_runs_without_result", n_without},
                     {"levels", levels_json(motions)},
                     {"hazard", hazard},
                     {"confidence", study.bootstrap.confidence},
                     {"replicates", study.bootstrap.replicates},
                     {"hits", hits.json()},
                     {"differences", sums.json()},
                     {"doubts", doubts},
                     {"missing", motions.missing}};
  if (study.collapse) results.summary["p695"] = to_json(checks);
  return results;
}

void write_results(const Results &results, const std::string &folder) {
  for (const auto &[name, table] : results.tables) {
    if (table.rows.empty()) continue;
    write_hdf5(table, fmt::format("{}/{}.h5", folder, name));
    write_csv(table, fmt::format("{}/{}.csv", folder, name));
  }
  if (results.runs.n_rows() > 0)
    results.runs.write(folder + "/runs.h5",
                       {{"study", results.summary.at("study")}, {"scene", results.summary.at("scene")}});
  write_atomically(json_text(results.summary), folder + "/reliability.json");
}

} // namespace rimpact::risk
