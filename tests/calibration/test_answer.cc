// What a calibration hands over: its law, its table, its pair, its JSON and its fragment of a scene.
#include "answer_runs.h"
#include "calibration/answer/answer_json.h"
#include "calibration/answer/answer_mesh_error.h"
#include "calibration/answer/answer_text.h"
#include "calibration/laws/law_errors.h"
#include "reduced_models/simulate.h"
#include "scene/bearing_catalogue.h"
#include "scene/rim_identity.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

/// Fitted at one mass and asked at another: what "belongs to" means.
TEST(Answer, TheLawBelongsToTheRimThePairToTheMass) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  for (const double v : {0.1, 0.2, 0.4, 0.8}) runs.push_back(stand_in(folder, yielding(v)));
  const auto c = calibrate(runs, quick({"signed", "elastoplastic"}));
  ASSERT_TRUE(c.answer);
  EXPECT_EQ(c.answer->law.result.law, "elastoplastic");
  EXPECT_FALSE(c.answer->law.of_the_mass);
  double missed = 0;
  for (const double v : {0.15, 0.3, 0.6}) {
    const auto truth = reduced::simulate(yielding(v, 2.3 * 86952)).summary;
    auto scene = yielding(v, 2.3 * 86952);
    scene.reduced = c.answer->scene.reduced;
    EXPECT_NEAR(*reduced::simulate(scene).summary.peak_impact_force / *truth.peak_impact_force, 1, 1e-3) << v;
    scene = with_fitted(yielding(v, 2.3 * 86952), c.result); // signed
    missed =
        std::max(missed, std::abs(*reduced::simulate(scene).summary.peak_impact_force / *truth.peak_impact_force - 1));
  }
  EXPECT_GT(missed, 0.10); // the pair of one mass is no pair of another
  auto options = quick({"signed", "elastoplastic"});
  options.fit.law = "signed";
  const auto pair = calibrate(runs, options).answer;
  EXPECT_TRUE(pair->law.of_the_mass);
  EXPECT_EQ(pair->law.chosen_by, ChosenBy::user);
  EXPECT_NE(pair->law.remark.find("The law elastoplastic is better: it leaves"), std::string::npos) << pair->law.remark;
  EXPECT_NE(to_toml_fragment(*pair).find("fitted_mass_kg = 86952"), std::string::npos) << to_toml_fragment(*pair);
}

/// Without a comparison of laws no exponent is fitted: that is said too, unless the user named or held it.
TEST(Answer, ExponentsHeldWithoutAComparisonAreSaid) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  for (const double v : {0.1, 0.3, 0.6}) runs.push_back(stand_in(folder, yielding(v)));
  auto options = quick({});
  options.fit.law = "elastoplastic", options.fit.parameters.clear();
  options.fit.fixed["hardening_exponent"] = 0.75;
  const Answer answer = *calibrate(runs, options).answer;
  EXPECT_NE(answer.law.held.find("held unloading_exponent at 0.5, for"), std::string::npos) << answer.law.held;
  EXPECT_EQ(answer.law.held.find("hardening_exponent"), std::string::npos) << answer.law.held;
  EXPECT_NE(describe(answer).find(answer.law.held), std::string::npos);
  options.fit.law = "bilinear", options.fit.fixed.clear();
  EXPECT_TRUE(calibrate(runs, options).answer->law.held.empty()) << "it has none";
}

TEST(Answer, IsTheContractsJsonAndItsFragmentFliesTheSame) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  for (const double v : {0.1, 0.2, 0.4, 0.8}) runs.push_back(stand_in(folder, yielding(v)));
  const auto c = calibrate(runs, quick({"signed", "no-tension", "elastoplastic"}));
  const auto json = to_json(c)["answer"];
  for (const char *key : {"bearing", "rim_identity", "rung", "mesh", "mass_kg", "vertical_kN", "gravity_m_per_s2",
                          "source", "law", "table", "pair_law", "pair", "no_pair", "published_applies", "strain",
                          "mesh_error", "assumptions", "doubts", "validity"})
    EXPECT_TRUE(json.contains(key)) << key;
  for (const char *key :
       {"name", "chosen_by", "remark", "belongs_to", "parameters", "element", "fitted_from_m_s", "fitted_to_m_s",
        "valid_from_m_s", "valid_to_m_s", "tolerance", "worst_left_out", "force_unexplained", "n_runs", "sentence"})
    EXPECT_TRUE(json["law"].contains(key)) << key;
  EXPECT_EQ(scene::to_json(scene::read_answer(json, "calibration.json")), scene::to_json(stored(*c.answer)))
      << "what is written is read";
  EXPECT_TRUE(json["plates"].is_null()) << "one dish";
  EXPECT_EQ(json["law"]["name"], "elastoplastic");
  EXPECT_EQ(json["law"]["chosen_by"], "ranking");
  EXPECT_EQ(json["law"]["belongs_to"], "rim");
  EXPECT_EQ(json["rim_identity"], scene::rim_identity(scene::Bearing()));
  EXPECT_TRUE(json["published_applies"].get<bool>());
  EXPECT_EQ(to_json(c)["parameters"].size(), 2u); // k_i and e stay as they were asked for
  const auto scene = scene::parse_scene(to_toml_fragment(*c.answer), "calibration.toml");
  EXPECT_EQ(scene.reduced.impact_law->name, "elastoplastic");
  EXPECT_NEAR(scene.reduced.yield_force / 0.9e6, 1, 1e-3);
  EXPECT_NEAR(*scene.reduced.fitted_from / 0.1, 1, 1e-3); // of the first sample pressed
  EXPECT_NEAR(*scene.reduced.fitted_to / 0.8, 1, 1e-3);
  EXPECT_FALSE(scene.reduced.fitted_mass);
  EXPECT_EQ(scene.reduced.fitted_rim, json["rim_identity"].get<std::string>());
  ASSERT_EQ(c.answer->table.size(), 5u);
  for (const auto &row : c.answer->table) {
    const auto truth = reduced::simulate(yielding(row.speed)).summary;
    EXPECT_NEAR(row.peak_force / *truth.peak_impact_force, 1, 2e-3);
    if (!row.e) continue;
    auto pair = window(row.speed, *row.k_i, *row.e);
    pair.reduced.impact_law = &laws::impact_law("no-tension");
    const auto flown = reduced::simulate(pair).summary.impacts.at(0);
    EXPECT_NEAR(flown.peak_force / row.peak_force, 1, 1e-3) << row.speed;
    EXPECT_NEAR(flown.restitution(), row.restitution, 1e-3) << row.speed;
  }
}

TEST(Answer, OfTwoDishesKeepsThePlates) {
  TemporaryFolder folder;
  auto run = window(0.2);
  run.bearing = scene::builtin_bearing("dcfp-155");
  const auto plates = to_json(calibrate({folder.write(run)}, quick({})))["answer"]["plates"];
  EXPECT_DOUBLE_EQ(plates["radius_m"], run.bearing.surface.R0);
  EXPECT_DOUBLE_EQ(plates["slider_height_mm"], 1e3 * run.bearing.slider.height);
  EXPECT_DOUBLE_EQ(plates["slider_diameter_mm"], 1e3 * run.bearing.slider.diameter);
  EXPECT_DOUBLE_EQ(plates["rim_height_mm"], 1e3 * run.bearing.rim.height);
  EXPECT_DOUBLE_EQ(plates["lateral_capacity_m"], run.bearing.lateral_capacity());
}

TEST(Answer, ThePublishedPairIsOfItsBearingAndMassOnly) {
  TemporaryFolder folder;
  auto heavier = window(0.2);
  heavier.name = "heavier", heavier.load.mass = 90000;
  auto other = window(0.2);
  other.name = "other", other.bearing.rim.thickness = 0.05;
  for (const auto &scene : {heavier, other}) {
    const auto json = to_json(calibrate({folder.write(scene)}, quick({})));
    EXPECT_TRUE(json["published"].is_null());
    EXPECT_TRUE(json["fit"].begin().value()["published_values"].is_null());
    EXPECT_FALSE(json["answer"]["published_applies"].get<bool>());
  }
  auto renamed = window(0.2);
  renamed.name = "renamed", renamed.bearing.name = "mine";
  EXPECT_TRUE(to_json(calibrate({folder.write(renamed)}, quick({})))["answer"]["published_applies"].get<bool>());
}

TEST(Answer, ErrorsBetweenRunsAreThoseOfTheRuns) {
  std::vector<LawError> errors(2);
  errors[0].speed = 0.1, errors[0].peak_force = 0.02;
  errors[1].speed = 0.4, errors[1].peak_force = 0.06;
  EXPECT_NEAR(errors_at(0.2, errors, &LawError::peak_force).value(), 0.04, 1e-12);
  EXPECT_NEAR(errors_at(0.05, errors, &LawError::peak_force).value(), 0.02, 1e-12);
  errors[1].peak_force = -0.06; // which side it errs to between them is not known
  EXPECT_NEAR(errors_at(0.2, errors, &LawError::peak_force).value(), 0.06, 1e-12);
  EXPECT_FALSE(errors_at(0.2, {}, &LawError::peak_force));
}

TEST(Answer, WithoutAPairSaysWhy) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  for (const double v : {0.1, 0.2, 0.4, 0.8}) {
    auto scene = window(v, 3e8 * std::pow(v, -0.8));
    runs.push_back(stand_in(folder, scene));
  }
  const auto answer = calibrate(runs, quick({"signed", "no-tension"})).answer;
  EXPECT_FALSE(answer->pair);
  EXPECT_NE(answer->no_pair.find("none of law no-tension meets peak force and rebound within 20 %"), std::string::npos)
      << answer->no_pair;
}

} // namespace
} // namespace rimpact::calibration
