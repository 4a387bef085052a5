// clang-format off
/// A reliability study: which systems, under which records at which intensity, against which limits. TOML, a sweep file
/// (studies/fleets/sweep.h: [[case]], [[device]], [grid], [latin_hypercube], [linked]) with these tables:
///
///   scene = "frame-four-dof"      # built in, or a file beside the study
///   years = 50.0                  # of the probability
///   fragility = "hits-apart"      # | "thesis": one lognormal a level, flat above the last
///   [set]                         # keys that every run has
///   excitation.duration_s = 40.0
///   [intensity]
///   period_s = 3.0                # S_a at this period, 5 % damping
///   measure = "component"         # of levels_g: each component's own S_a | "rotd50", "rotd100": its pair's
///   levels_g = [0.1, 0.2]         # without a table: every record at every level
///   [motions]
///   folders = ["records"]         # beside the study; or --records DIR
///   table = "table.csv"           # records of each level; columns as below, any separator, decimal commas
///   level_is = "return_period_years"   # or "intensity_g": what the table's column `level` holds
///   component = "nearest"         # of a record's two the one whose factor x S_a meets the level | "printed"
///   list = "none"                 # | "p695-far-field": levels_g of that set, normalised as it says
///   scale = "factor"              # as the table has it | "level": to meet the level
///   [motions.columns]             # names of the table's columns; component and factor may be ""
///   level = "level"
///   rsn = "rsn"
///   component = "component"
///   factor = "factor"
///   [[motions.set]]               # in place of `table`: a result of PEER's search for each level
///   search_results = "475/_SearchResults.csv"   # Record Sequence Number, Scale Factor
///   level = 475                   # as level_is says
///   [motions.where]               # only rows whose column has this value
///   period_s = 3
///   [hazard]
///   points = [[0.113, 475], ...]  # S_a [g], mean return period [years]
///   [[limit]]                     # any number
///   quantity = "ductility"        # a column of the runs' table, see quantities()
///   values = { from = 1.0, to = 10.0, count = 37 }   # or a list
///   [[difference]]                # systems that differ in nothing but `key`, which is `reference` in one of them
///   key = "bearing.surface.a_m"
///   reference = 2.25
///   [p695]                        # acceptance by FEMA P-695, see collapse_check.h
///   quantity = "collapsed"        # and `limit`, of a [[limit]]: what collapse is
///   mce_g = 0.9                   # S_MT: the maximum considered S_a at period_s
///   ductility = 6.0               # mu_T, period-based
///   category = "Dmax"             # | "C" | "E"
///   design_requirements = "B"     # A to D; so are test_data and model
///   three_dimensional = false     # 1.2 times the margin
///   [plausible]                   # as in a sweep file (studies/fleets/implausible_runs.h)
///   [bootstrap]
///   replicates = 500
///   confidence = 0.9
///   seed = 1
///
/// Cases x devices x grid are the systems; samples are runs of each. A quantity of one [[limit]] only.
// clang-format on
#pragma once
#include "io/files/choice.h"
#include "studies/fleets/sweep_reader.h"
#include "studies/reliability/bootstrap.h"
#include "studies/reliability/collapse_margin.h"
#include "studies/reliability/hazard.h"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::risk {

enum class LevelKind { return_period, intensity };
constexpr auto choices(LevelKind) {
  return choices_of<LevelKind>(
      {{LevelKind::return_period, "return_period_years"}, {LevelKind::intensity, "intensity_g"}});
}
enum class ComponentRule { nearest, printed };
constexpr auto choices(ComponentRule) {
  return choices_of<ComponentRule>({{ComponentRule::nearest, "nearest"}, {ComponentRule::printed, "printed"}});
}
enum class ScaleRule { factor, level };
constexpr auto choices(ScaleRule) {
  return choices_of<ScaleRule>({{ScaleRule::factor, "factor"}, {ScaleRule::level, "level"}});
}

/// How responses become fragilities, and fragilities rates.
enum class FragilityRule {
  hits_apart, ///< runs that hit the rim and runs that do not; a curve across levels beyond them
  thesis      ///< thesis 2.6.6: one lognormal a level; straight between levels, flat above the last
};
constexpr auto choices(FragilityRule) {
  return choices_of<FragilityRule>(
      {{FragilityRule::hits_apart, "hits-apart", "runs that hit the rim apart; a curve across levels beyond them"},
       {FragilityRule::thesis, "thesis", "one lognormal a level, flat above the last"}});
}

/// Lists of records by number that the study need not bring.
enum class RecordList { none, p695_far_field };
constexpr auto choices(RecordList) {
  return choices_of<RecordList>({{RecordList::none, "none", "every record of the folders"},
                                 {RecordList::p695_far_field, "p695-far-field",
                                  "the far-field set of FEMA P-695, normalised, its median S_a at each level"}});
}

/// What a component's S_a is where every record of the folders stands at every level.
enum class Measure { component, rotd50, rotd100 };
constexpr auto choices(Measure) {
  return choices_of<Measure>({{Measure::component, "component", "its own"},
                              {Measure::rotd50, "rotd50", "the median over all directions of its pair"},
                              {Measure::rotd100, "rotd100", "the largest over all directions of its pair"}});
}

/// One level's result of PEER's search.
struct MotionSet {
  std::string search_results;
  double level;
};

/// Where the ground motions come from.
struct MotionSource {
  std::vector<MotionSet> sets;
  std::vector<std::string> folders; ///< of record files
  std::string table;                ///< CSV; empty: every horizontal component of the folders at every level
  LevelKind level_is = LevelKind::return_period;
  ComponentRule component = ComponentRule::nearest;
  RecordList list = RecordList::none; ///< of levels_g
  ScaleRule scale = ScaleRule::factor;
  std::string level_column = "level", rsn_column = "rsn", component_column = "component", factor_column = "factor";
  std::map<std::string, std::string> where; ///< column -> value
};

/// A quantity of the runs and the values it must not exceed, growing, > 0, in the unit its name ends with.
struct Limit {
  std::string quantity;
  std::vector<double> values;
};

/// What FEMA P-695 asks of a study: the limit that is collapse, the intensity, and how well all of it is known.
struct CollapseStudy {
  std::string quantity = "collapsed";
  double limit = 0;     ///< one of the limit's values; 0: its first one
  double mce_g = 0;     ///< S_MT [g], > 0
  double ductility = 1; ///< mu_T, >= 1
  reliability::ShapeCategory category = reliability::ShapeCategory::low;
  reliability::Rating design = reliability::Rating::good, tests = reliability::Rating::good,
                      model = reliability::Rating::good;
  bool is_three_dimensional = false;
};

struct Difference {
  std::string key;
  Cell reference;
};

struct Study {
  std::string name, origin; ///< origin: the file
  std::string scene;        ///< built in, or an absolute path
  double years = 50;
  FragilityRule fragility = FragilityRule::hits_apart;
  std::vector<std::string> settings;    ///< KEY=VALUE of [set]
  fleets::SweepParts parts;             ///< its records are not used
  double period_s = 0;                  ///< of S_a
  Measure measure = Measure::component; ///< of levels_g
  std::vector<double> levels_g;
  MotionSource motions;
  std::vector<reliability::HazardPoint> hazard;
  std::vector<Limit> limits;
  std::vector<Difference> differences;
  std::optional<CollapseStudy> collapse = {};
  reliability::Bootstrap bootstrap;
};

inline constexpr const char *collapsed = "collapsed";

} // namespace rimpact::risk
