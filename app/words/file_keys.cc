#include "app/words/file_keys.h"

#include "app/words/key_describer.h"
#include "buildings/plane_frame.h"
#include "buildings/regular_building.h"
#include "calibration/data/mapping.h"
#include "studies/risk/study.h"
#include "studies/risk/study_reader.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::app {
namespace {

KeyDescription number(const char *path, const std::string &preset, const char *range, const char *meaning) {
  return {path, "number", unit_in_name(path), preset, range, meaning, false, ""};
}

KeyDescription text(const char *path, const std::string &preset, const std::string &range, const char *meaning) {
  return {path, "text", "", preset, range, meaning, false, ""};
}

template <Worded E> std::string any_of() {
  return fmt::format("{}", fmt::join(words<E>(), ", "));
}

/// The keys of a description by its own visit, those of a table under `section`.
template <class Description> std::vector<KeyDescription> visited(const std::string &section = "") {
  Description description;
  KeyDescriber describer(section.empty() ? "" : section + ".");
  visit(describer, description);
  const auto presets = presets_of([&](KeyVisitor &visitor) { visit(visitor, description); }, section);
  for (auto &key : describer.keys)
    if (const auto &preset = presets.at(key.path); preset != "inf") key.preset = preset;
  return describer.keys;
}

std::vector<KeyDescription> operator+(std::vector<KeyDescription> a, const std::vector<KeyDescription> &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<KeyDescription> sweep_keys() {
  return {
      text("grid.KEY", "", "a list, or from, to, count",
           "every value with every other grid's; `variable.NAME` is a column only"),
      number("grid.KEY.from", "", "a number", "first of evenly spaced values"),
      number("grid.KEY.to", "", "a number", "last of them"),
      number("grid.KEY.count", "", "2 and more", "how many"),
      text("case.KEY", "", "any value", "[[case]]: one run a table, all with the same keys"),
      text("case.name", "", "text", "column `case` of the table"),
      text("records.folder", "", "a folder", "of records, one run a station or component"),
      text("records.components", "", "x, xy, xyz", "x: each horizontal component alone; xy, xyz: together"),
      number("records.sa_period_s", "none", "> 0", "column record_sa_g: spectral acceleration at this period"),
      number("latin_hypercube.samples", "", "1 and more", "how many samples of the keys beside it"),
      number("latin_hypercube.seed", "1", "a whole number", "of the random numbers"),
      text("latin_hypercube.correlation", "[]", "lists of two keys and a number",
           "of the normal scores of two keys; the others are not correlated"),
      number("latin_hypercube.KEY.low", "", "a number", "least value"),
      number("latin_hypercube.KEY.high", "", "> low", "largest value"),
      text("latin_hypercube.KEY.log", "false", "true, false", "even in the logarithm"),
      number("latin_hypercube.KEY.mean", "", "low to high", "normal instead of even, cut at low and high"),
      number("latin_hypercube.KEY.deviation", "", "> 0", "its standard deviation"),
      text("linked.KEY.product", "", "a list of numbers and keys", "KEY is their product in every run"),
      text("linked.KEY.over", "none", "a key", "divided by it"),
      text("fractiles.along", "", "a key of the grid", "16, 50 and 84 % of the results along it: fractiles.csv"),
      text("fractiles.by", "[]", "keys of the grid", "fractiles of each group of their values apart"),
      number("plausible.QUANTITY", "", "> 0",
             "largest value that is believed, of a limit.quantity with values: runs beyond are doubted"),
  };
}

std::vector<KeyDescription> study_keys() {
  using namespace risk;
  const Study usual;
  return {
      text("name", "the file's", "text", "of the study"),
      text("scene", "", "text", "of every run: built in, or a file beside the study"),
      text("fragility", word(usual.fragility), any_of<FragilityRule>(), "how responses become fragilities and rates"),
      number("years", fmt::format("{}", usual.years), "> 0",
             "in which a limit is exceeded with the probability sought"),
      text("set.KEY", "", "any value", "in every run"),
      number("intensity.period_s", "", "0.01 to 100", "intensity is S_a at this period, 5 % damping"),
      text("intensity.levels_g", "[]", "numbers from 0 to 100", "every record at every one of these levels"),
      text("intensity.measure", word(Measure::component), any_of<Measure>(), "of levels_g: whose S_a is the level"),
      text("hazard.points", "", "pairs of S_a in g and return period in years", "the hazard curve, two or more"),
  };
}

std::vector<KeyDescription> motion_keys() {
  using namespace risk;
  const MotionSource motions;
  return {
      text("motions.folders", "[]", "folders",
           "of records; those of a table are named RSN<number>_...; --records adds one"),
      text("motions.table", "", "a CSV file", "which records stand at which level"),
      text("motions.level_is", word(motions.level_is), any_of<LevelKind>(), "what the table's column of levels holds"),
      text("motions.component", word(motions.component), any_of<ComponentRule>(),
           "the horizontal component whose S_a meets the level best, or the one named"),
      text("motions.list", word(motions.list), any_of<RecordList>(),
           "of levels_g: records by number, as the list has them"),
      text("motions.scale", word(motions.scale), any_of<ScaleRule>(),
           "the table's factor, or so that the level is met"),
      text("motions.columns.level", motions.level_column, "text", "name of the table's column of levels"),
      text("motions.columns.rsn", motions.rsn_column, "text", "of the record's number"),
      text("motions.columns.component", motions.component_column, "text, may be empty", "of the component"),
      text("motions.columns.factor", motions.factor_column, "text, may be empty", "of the factor"),
      text("motions.where.COLUMN", "", "a number or a text", "only rows with this value"),
      text("motions.set.search_results", "", "a CSV file",
           "[[motions.set]]: results of PEER's search in place of a table"),
      number("motions.set.level", "", "> 0", "of the set, as motions.level_is has it"),
  };
}

std::vector<KeyDescription> limit_keys() {
  const risk::Study usual;
  return {
      text("limit.quantity", "", fmt::format("{}", fmt::join(risk::quantities(), ", ")), "[[limit]]: what is limited"),
      text("limit.values", "", "numbers > 0, or from, to, count", "its limits, SI"),
      number("limit.values.from", "", "> 0", "first of evenly spaced limits"),
      number("limit.values.to", "", "> 0", "last of them"),
      number("limit.values.count", "", "2 to 1000", "how many"),
      text("difference.key", "", "a key of the systems", "[[difference]]: systems alike in all but this key"),
      text("difference.reference", "", "a value of it", "the others are compared with the one that has it"),
      number("bootstrap.replicates", fmt::format("{}", usual.bootstrap.replicates), "2 to 100000",
             "draws of the records for the bands"),
      number("bootstrap.confidence", fmt::format("{}", usual.bootstrap.confidence), "between 0 and 1", "of the bands"),
      number("bootstrap.seed", fmt::format("{}", usual.bootstrap.seed), "a whole number", "of the random numbers"),
  };
}

/// Of [p695].
std::vector<KeyDescription> acceptance_keys() {
  using namespace risk;
  const CollapseStudy usual;
  return {
      text("p695.quantity", usual.quantity, "one of the limits' quantities", "[p695]: what collapse is, by FEMA P-695"),
      number("p695.limit", "the first", "one of its values", "beyond which a run has collapsed"),
      number("p695.mce_g", "", "> 0", "maximum considered S_a at intensity.period_s"),
      number("p695.ductility", fmt::format("{:g}", usual.ductility), ">= 1", "period-based ductility"),
      text("p695.category", word(usual.category), any_of<reliability::ShapeCategory>(), "seismic design category"),
      text("p695.design_requirements", word(usual.design), any_of<reliability::Rating>(),
           "quality of the design rules"),
      text("p695.test_data", word(usual.tests), any_of<reliability::Rating>(), "quality of the test data"),
      text("p695.model", word(usual.model), any_of<reliability::Rating>(), "quality of the model"),
      text("p695.three_dimensional", "false", "true or false", "the margin times 1.2"),
  };
}

std::vector<KeyDescription> with_bearings(std::vector<KeyDescription> keys) {
  return std::move(keys) + std::vector{text("bearings.NODE", "the scene's", "text",
                                            "a bearing of its own under the node of this number: a name or a file")};
}

std::vector<KeyDescription> mapping_keys() {
  return visited<calibration::Mapping>() +
         std::vector{text("set", "[]", "KEY=VALUE texts", "changes to the scene, as --set")} +
         visited<calibration::Column>("columns.SIGNAL") + visited<calibration::TestPart>("test.NAME") +
         std::vector{text("test.NAME.set", "[]", "KEY=VALUE texts", "further changes to the scene, for this test")} +
         visited<calibration::Uncertainty>("uncertainty");
}

} // namespace

std::vector<FileKeys> file_keys() {
  return {
      {"sweep_keys", "Sweep files", "`KEY` stands for any scene key, or `variable.NAME`, a column only.", sweep_keys()},
      {"study_keys", "Reliability studies",
       "Parts `case`, `device`, `grid`, `latin_hypercube`, `linked` and `plausible` are those of a sweep file.",
       study_keys() + motion_keys() + limit_keys() + acceptance_keys()},
      {"building_keys", "Buildings", "A regular building, linear in space, for `--frame`.",
       with_bearings(visited<buildings::RegularBuilding>())},
      {"frame_keys", "Inelastic frames",
       "A regular frame in the plane, for `--frame`: known by `load_kN_per_m` or one of its tables.",
       with_bearings(visited<buildings::PlaneFrame>())},
      {"mapping_keys", "Mapping files", "What a table's columns are. `SIGNAL` is a name of `rimpact list signals`.",
       mapping_keys()}};
}

} // namespace rimpact::app
