// calibration.json, written and read by one description.
#include "expect_error.h"
#include "scene/stored_calibration.h"
#include "temporary_folder.h"
#include <functional>

namespace {
using namespace rimpact;
using namespace rimpact::scene;
using nlohmann::json;

const std::string file = "there/calibration.json";

StoredParameter fitted(double value, const char *unit) {
  return {.value = value,
          .unit = unit,
          .standard_error = 0.01 * value,
          .stated_error = 0.005 * value,
          .interval_95 = {0.9 * value, {}},
          .identifiable = false,
          .at_bound = true,
          .verdict = "bound",
          .reason = "it ended at its bound"};
}

StoredLaw full_law() {
  return {.name = "elastoplastic",
          .chosen_by = "ranking",
          .remark = "a remark",
          .held = "an exponent is held",
          .sentence = "The law holds.",
          .gain = StoredGain{.factor = 1.02, .standard_error = 0.01, .stated_error = 0.03},
          .belongs_to = BelongsTo::mass,
          .parameters = {{"k_i", fitted(1.1e6, "kN/m")}},
          .element = {.lateral_capacity = 0.4003,
                      .reference_speed = 0.5,
                      .numbers = {{"k_i", 1.1e6}, {"yield_force", 455.24}, {"capacity_offset", 0.3}}},
          .fitted_from = 0.1,
          .fitted_to = 0.7,
          .valid_from = 0.2,
          .valid_to = 0.6,
          .tolerance = 0.05,
          .worst_left_out =
              StoredWorst{.peak_force = 0.02, .penetration = 0.03, .rebound = 0.04, .inside_valid_range = true},
          .force_unexplained = 0.07,
          .n_runs = 6,
          .converged = false};
}

/// Every member differs from what it is by itself.
StoredAnswer full_answer() {
  return {
      .bearing = "mine",
      .rim_identity = "0123456789abcdef",
      .source = "finite elements",
      .rungs = {"rim", "full"},
      .meshes = {1, 2},
      .mass = 86952,
      .vertical = 853e3,
      .gravity = 9.81,
      .law = full_law(),
      .rims_in_series = 2,
      .plates =
          FittedPlates{
              .radius = 0.75, .slider_height = 0.085, .slider_diameter = 0.14, .rim_height = 0.02, .capacity = 0.175},
      .pair = StoredPair{.law = "signed",
                         .k_i = 4.5e5,
                         .e = 0.5,
                         .c_i = 1700,
                         .mass = 86952,
                         .from = 0.2,
                         .to = 0.4,
                         .tolerance = 0.1,
                         .worst_peak_force = 0.08,
                         .worst_rebound = 0.05,
                         .parameters = {{"e", fitted(0.5, "-")}},
                         .sentence = "A pair."},
      .no_pair = "why",
      .strain = StoredStrain{.rows = {{.speed = 0.1, .depth = 1.5e-3, .strain = 0.02, .place = "rim_root"}},
                             .sentence = "It bears."},
      .foot = StoredFoot{.connection = "fillet",
                         .in_words = "two fillet welds",
                         .joint = "two fillet welds with a throat of 10 mm",
                         .goes_at_force = 812.5e3,
                         .goes_at = 0.5,
                         .borne_to = 0.4,
                         .sentence = "It goes.",
                         .doubt = "a doubt"},
      .mesh_error = {.peak_force = 0.015, .sentence = "Within 1.5 %."},
      .stack = StoredStack{.finite_pad = true,
                           .socket_friction = false,
                           .normal_force = NormalForce::pad,
                           .friction = Friction::park_wen,
                           .elastic_slip = 0.14e-3,
                           .slip_from = SlipFrom::fit},
      .steel_rate = "Cowper-Symonds",
      .steel_band = StoredBand{.calibration = "fast", .sentences = {"one", "two"}},
      .error_sentences = {"Peak force: within 28 %."},
      .finding_sentences = {"Run mesh 2."},
      .doubts = {"a doubt", "another"},
      .assumptions = {{"rim.height_mm", "60"}},
      .validity = "From 0.2 to 0.6 m/s."};
}

/// Through the text of a file.
StoredAnswer again(const StoredAnswer &answer) {
  return read_answer(json::parse(to_json(answer).dump()), file);
}

TEST(StoredAnswer, ComesBackAsItWasWritten) {
  EXPECT_TRUE(again(full_answer()) == full_answer());
  StoredAnswer bare; // as calibrations of measured tests are: nothing of steel, foot and pad
  bare.law.name = "signed", bare.law.element.numbers = {{"k_i", 3e5}, {"e", 0.5}};
  bare.rungs = {"measured"};
  EXPECT_TRUE(again(bare) == bare);
}

/// The contract's keys (docs/interface.md) with their units; the whole key is the unit's.
TEST(StoredAnswer, NumbersStandInTheUnitOfTheirKey) {
  const json written = to_json(full_answer());
  EXPECT_EQ(written["vertical_kN"], 853);
  EXPECT_EQ(written["rim_foot"]["goes_at_force_kN"], 812.5);
  EXPECT_DOUBLE_EQ(written["stack"]["elastic_slip_mm"].get<double>(), 0.14);
  EXPECT_DOUBLE_EQ(written["strain"]["rows"][0]["penetration_mm"].get<double>(), 1.5);
  EXPECT_EQ(written["law"]["element"]["k_i"], (json{{"value", 1.1e6}, {"unit", "kN/m"}}));
  EXPECT_EQ(written["law"]["parameters"]["k_i"]["interval_95"], (json{0.9 * 1.1e6, nullptr}));
  EXPECT_EQ(written["rung"], (json{"rim", "full"}));
  StoredAnswer one = full_answer();
  one.meshes = {1}, one.rungs = {};
  EXPECT_EQ(to_json(one)["mesh"], 1) << "one value stands by itself";
  EXPECT_TRUE(to_json(one)["rung"].is_null());
}

/// Calls `look` with every pointer below `at` and its path in words, "answer.law.parameters.k_i".
void each_value(const json &whole, const json::json_pointer &at, const std::string &path,
                const std::function<void(const json::json_pointer &, const std::string &)> &look) {
  const json &value = whole[at];
  look(at, path);
  if (value.is_object())
    for (const auto &[name, entry] : value.items()) each_value(whole, at / name, path + "." + name, look);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      each_value(whole, at / i, path + "[" + std::to_string(i) + "]", look);
}

TEST(StoredAnswer, EveryValueOfAnotherKindIsNamedWithFileAndKey) {
  const json whole = to_json(full_answer());
  int n = 0;
  each_value(whole, json::json_pointer(""), "answer", [&](const json::json_pointer &at, const std::string &path) {
    json broken = whole;
    broken[at] = whole[at].is_number() || whole[at].is_null() ? json("three")
                 : whole[at].is_boolean()                     ? json(3)
                                                              : json(true);
    SCOPED_TRACE(path);
    expect_error<DataError>([&] { read_answer(broken, file); }, {file.c_str(), (": " + path + " is not").c_str()});
    ++n;
  });
  EXPECT_GT(n, 100);
}

TEST(StoredAnswer, WhatHasToBeThereIsAskedFor) {
  for (const char *key : {"/law", "/law/name", "/law/element", "/law/element/k_i/value", "/law/element/k_i/unit",
                          "/pair/k_i_kN_per_m", "/pair/e", "/pair/mass_kg", "/pair/from_m_s", "/pair/to_m_s"}) {
    json broken = to_json(full_answer());
    const json::json_pointer at(key);
    broken[at.parent_pointer()].erase(at.back());
    std::string path = "answer";
    for (const char letter : std::string(key)) path += letter == '/' ? '.' : letter;
    expect_error<DataError>([&] { read_answer(broken, file); }, {(file + ": " + path + " is missing").c_str()});
  }
}

TEST(StoredAnswer, AParameterOfAnotherUnitOrUnknownIsRefused) {
  json other = to_json(full_answer());
  other["law"]["element"]["k_i"]["unit"] = "N/m";
  expect_error<DataError>([&] { read_answer(other, file); }, {"answer.law.element.k_i.unit is \"N/m\", not \"kN/m\""});
  json unknown = to_json(full_answer());
  unknown["law"]["element"]["k_j"] = {{"value", 1}, {"unit", "-"}};
  expect_error<DataError>([&] { read_answer(unknown, file); },
                          {"answer.law.element.k_j is no parameter that this version knows"});
  json neither = to_json(full_answer());
  neither["law"]["belongs_to"] = "plate";
  expect_error<DataError>([&] { read_answer(neither, file); },
                          {"answer.law.belongs_to is \"plate\", none of rim | mass"});
}

/// An earlier version's keys are fewer: what is not there is not known.
TEST(StoredAnswer, AnEarlierVersionsFileIsRead) {
  const json old = json::parse(R"({"law": {"name": "signed", "element": {"lateral_capacity_m": 0.4,
    "k_i": {"value": 3e5, "unit": "kN/m"}, "e": {"value": 0.5, "unit": "-"}}}, "mesh_error": {}, "rung": "rim"})");
  const StoredAnswer answer = read_answer(old, file);
  EXPECT_EQ(answer.law.element.numbers.at("k_i"), 3e5);
  EXPECT_EQ(answer.rungs, std::vector<std::string>{"rim"});
  EXPECT_FALSE(answer.gravity || answer.stack || answer.foot || answer.law.fitted_from);
  EXPECT_EQ(answer.rims_in_series, 1);
}

TEST(StoredCalibration, HasTheLawsBesideTheAnswerAndTheRuns) {
  const StoredRankedLaw row{.law = "no-tension",
                            .parameters = {{"k_i", fitted(4.5e5, "kN/m")}},
                            .valid_from = 0.1,
                            .valid_to = 0.2,
                            .left_out_peak_force = 0.45,
                            .left_out_rebound = 0.6,
                            .sentence = "It holds nowhere."};
  const json whole{{"answer", to_json(full_answer())},
                   {"laws", {{"tolerance", 0.05}, {"rows", {to_json(row)}}}},
                   {"fit", {{"runs/w-0.10", {}}, {"runs/w-0.20", {}}}}};
  const TemporaryFolder folder;
  folder.write("calibration.json", whole.dump());
  const StoredCalibration read = read_calibration(folder.path());
  EXPECT_EQ(read.file, folder / "calibration.json");
  EXPECT_TRUE(read.answer == full_answer());
  EXPECT_TRUE(read.laws == (StoredLaws{.tolerance = 0.05, .rows = {row}}));
  EXPECT_EQ(read.fitted_runs, (std::vector<std::string>{"runs/w-0.10", "runs/w-0.20"}));
  EXPECT_FALSE(read_calibration(json{{"parameters", {}}}, file).answer) << "an earlier version wrote it";
}

TEST(StoredCalibration, WhatCannotBeReadIsSaid) {
  const TemporaryFolder folder;
  folder.write("calibration.json", "{\"answer\": ");
  expect_error<DataError>([&] { read_calibration(folder.path()); }, {"calibration.json: is not valid JSON"});
  folder.write("calibration.json", "[1]");
  expect_error<DataError>([&] { read_calibration(folder.path()); }, {"calibration.json: it is not a JSON object"});
  expect_error<DataError>(
      [] {
        read_calibration(json{{"laws", {{"rows", {{{"parameters", 3}}}}}}}, file);
      },
      {"there/calibration.json: laws.rows[0].law is missing"});
  expect_error<DataError>([] { read_calibration(json{{"fit", 3}}, file); }, {"fit is not a JSON object"});
}

} // namespace
