// What a calibration hands over, and every sentence of it used: what it says is typed into a scene and run.
#include "calibration/answer/answer.h"
#include "calibration/answer/answer_parts.h"
#include "calibration/answer/calibration_json.h"
#include "calibration/laws/law_errors.h"
#include "calibration/laws/no_tension_pair.h"
#include "calibration/laws/percent.h"
#include "calibration/laws/windows_table.h"
#include "files/error.h"
#include "impact_laws/catalogue.h"
#include "scene/rim_identity.h"
#include "synthetic.h"
#include <fstream>
#include <gtest/gtest.h>
#include <regex>

namespace rimpact::calibration {
namespace {
using namespace testing;

/// A yielding rim; `mass` [kg].
scene::Scene yielding(double speed, double mass = 86952) {
  auto s = window(speed, 6e8);
  s.name = fmt::format("yielding-{:g}-{:g}", speed, mass);
  s.load.mass = mass, s.load.vertical = mass * 9.81;
  s.reduced.impact_law = &laws::impact_law("elastoplastic");
  s.reduced.yield_force = 0.9e6;
  s.reduced.hardening = 0.1;
  s.reduced.unloading_gain = 0.3;
  return s;
}

/// A run folder of `truth` whose scene.toml knows nothing of its law, as one of finite elements does.
std::string stand_in(const TemporaryFolder &folder, const scene::Scene &truth) {
  const std::string path = folder.write(truth);
  auto told = truth;
  told.reduced = {};
  std::ofstream(path + "/scene.toml") << scene::to_toml(told);
  return path;
}

/// Changes summary.json of a run folder.
void amend(const std::string &folder, const nlohmann::json &patch) {
  auto summary = nlohmann::json::parse(std::ifstream(folder + "/summary.json"));
  summary.merge_patch(patch);
  std::ofstream(folder + "/summary.json") << summary.dump(2);
}

CalibrationOptions quick(std::vector<std::string> laws) {
  CalibrationOptions options;
  options.laws = std::move(laws);
  options.profiles = false;
  options.grazing_reports = false;
  options.fit.n_starts = 2;
  return options;
}

/// "name = value" of a sentence typed as --set would.
std::vector<std::string> typed(const std::string &sentence) {
  std::vector<std::string> assignments;
  const std::regex number(R"(([a-z_]+) = ([-+0-9.e]+))"), law(R"(law ([a-z-]+))");
  for (std::sregex_iterator i(sentence.begin(), sentence.end(), number), end; i != end; ++i)
    assignments.push_back(parameter((*i)[1]).toml_key + "=" + (*i)[2].str());
  std::smatch found;
  if (std::regex_search(sentence, found, law)) assignments.push_back("reduced.impact_law=" + found[1].str());
  return assignments;
}

/// Largest share in the words "within X %".
std::vector<double> bounds_in(const std::string &sentence) {
  std::vector<double> bounds;
  const std::regex bound(
      R"(within ([0-9.]+) %( in peak force| and the rebound| in rebound)?( and ([0-9.]+) % in rebound)?)");
  for (std::sregex_iterator i(sentence.begin(), sentence.end(), bound), end; i != end; ++i) {
    bounds.push_back(std::stod((*i)[1]) / 100);
    if ((*i)[4].matched) bounds.push_back(std::stod((*i)[4]) / 100);
  }
  return bounds;
}

/// Errors of a run's hardest impact with what a sentence says typed into its scene.
LawError flown(const StoredRun &run, const std::vector<std::string> &assignments) {
  StoredRun own = run;
  own.scene = scene::parse_scene(scene::to_toml(run.scene), "typed.toml", assignments);
  FitResult nothing; // everything stands in the scene
  nothing.law = own.scene.reduced.impact_law->name;
  return error_of(own, nothing);
}

TEST(PercentUp, IsNeverLessThanWhatWasMeasured) {
  EXPECT_EQ(percent_up(0.136), "14 %");
  EXPECT_EQ(percent_up(0.0312), "3.2 %");
  EXPECT_EQ(percent_up(0.03), "3 %");
  EXPECT_EQ(percent_up(0), "0.1 %");
  EXPECT_EQ(percent_up(1.89), "189 %");
}

TEST(NoTensionPair, IsWhatTheReducedModelFlies) {
  for (const double e : {0.02, 0.3, 0.65, 0.95})
    for (const double v : {0.1, 0.8}) {
      auto scene = window(v, 3e8, e);
      scene.reduced.impact_law = &laws::impact_law("no-tension");
      const auto impact = reduced::simulate(scene).summary.impacts.at(0);
      EXPECT_NEAR(impact.restitution(), no_tension_rebound(e), 1e-3) << e;
      const auto pair = no_tension_pair(impact.peak_force, impact.restitution(), v, scene.load.mass);
      ASSERT_TRUE(pair);
      EXPECT_NEAR(pair->k_i / 3e8, 1, 2e-3) << e;
      EXPECT_NEAR(pair->e, e, 1e-3) << e;
    }
  EXPECT_FALSE(no_tension_pair(1e6, 0.12, 0.5, 1e5)); // below exp(-2): no such law rebounds so little
  EXPECT_FALSE(no_tension_pair(1e6, 1.01, 0.5, 1e5));
}

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
  EXPECT_EQ(scene.reduced.fitted_rim, json["rim_identity"]);
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

/// For each law, runs that it has made: what its sentences say is typed in over the stated range.
TEST(Answer, WhatTheSentencesSayHoldsWhenTyped) {
  for (const char *law : {"signed", "no-tension", "hunt-crossley", "elastoplastic"}) {
    TemporaryFolder folder;
    std::vector<std::string> names;
    std::vector<StoredRun> runs;
    for (const double v : {0.1, 0.2, 0.35, 0.6}) {
      auto truth = yielding(v);
      truth.name = fmt::format("{}-{:g}", law, v);
      truth.reduced.impact_law = &laws::impact_law(law);
      truth.reduced.restitution = 0.5;
      names.push_back(stand_in(folder, truth));
      runs.push_back(read_run(names.back(), {}));
    }
    auto options = quick({"signed", "no-tension", "hunt-crossley", "elastoplastic"});
    options.fit.law = law;
    options.fit.parameters = laws::impact_law(law).parameters;
    const auto c = calibrate(names, options);
    std::vector<std::string> sentences{c.answer->law.sentence, c.windows->sentence};
    if (c.answer->pair) sentences.push_back(c.answer->pair->sentence);
    for (const auto &sentence : sentences) {
      const auto assignments = typed(sentence);
      ASSERT_FALSE(assignments.empty()) << sentence;
      const auto bounds = bounds_in(sentence);
      ASSERT_FALSE(bounds.empty()) << sentence;
      for (const auto &run : runs) {
        const auto error = flown(run, assignments);
        EXPECT_LE(std::abs(error.peak_force), bounds[0] + 1e-3) << sentence << " at " << error.speed;
      }
      EXPECT_EQ(sentence.find("onstant pair") != std::string::npos,
                sentence.find("supported mass of") != std::string::npos)
          << sentence;
    }
    EXPECT_EQ(c.windows->sentence.find("onstant pair") != std::string::npos, c.answer->law.of_the_mass)
        << c.windows->sentence;
  }
}

/// Real finite-element windows (rung rigid-dish, with weight and friction): every bound the sentences state, each typed
/// in from the run's own state at touch.
TEST(Answer, WhatTheSentencesSayHoldsOfKeptFiniteElements) {
  const std::string kept = RIMPACT_REFERENCES;
  std::vector<std::string> names;
  std::vector<StoredRun> runs, others;
  for (const char *v : {"0.07", "0.10", "0.35", "0.50", "1.00", "1.20"}) {
    names.push_back(kept + "/window-" + v);
    runs.push_back(read_run(names.back(), {}));
  }
  for (const char *v : {"0.20", "0.70"}) others.push_back(read_run(kept + "/window-" + v, {}));
  auto options = quick({"no-tension", "elastoplastic"});
  const auto c = calibrate(names, options);
  const auto &answer = *c.answer;
  EXPECT_EQ(answer.law.result.law, "elastoplastic");
  EXPECT_EQ(answer.source(), "finite elements");
  EXPECT_TRUE(answer.published_applies);
  EXPECT_FALSE(answer.pair) << answer.pair->sentence; // a rim that yields has none over three speeds
  EXPECT_NE(answer.no_pair.find("elastoplastic"), std::string::npos) << answer.no_pair;
  ASSERT_TRUE(answer.law.valid_from);
  const auto assignments = typed(answer.law.sentence);
  const auto bounds = bounds_in(answer.law.sentence);
  ASSERT_EQ(bounds.size(), 4u) << answer.law.sentence; // within the valid range, and elsewhere
  for (const auto &run : runs) {
    const auto error = flown(run, assignments);
    const bool inside = error.speed >= *answer.law.valid_from && error.speed <= *answer.law.valid_to;
    EXPECT_LE(std::abs(error.peak_force), bounds[inside ? 0 : 2] + 5e-4)
        << answer.law.sentence << " at " << error.speed;
    EXPECT_LE(std::abs(error.rebound), bounds[inside ? 1 : 3] + 5e-4) << answer.law.sentence << " at " << error.speed;
  }
  for (const auto &run : others) EXPECT_LE(std::abs(flown(run, assignments).peak_force), 0.05) << run.folder;
  ASSERT_TRUE(answer.strain);
  EXPECT_NEAR(answer.strain->largest, 0.566, 1e-3);
  EXPECT_NEAR(answer.strain->largest_speed_below_limit.value(), 0.1, 1e-3);
}

TEST(Answer, DoubtsOfRunsTravelAndWeigh) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  for (const double v : {0.1, 0.2, 0.3, 0.4, 0.5}) runs.push_back(folder.write(window(v)));
  amend(runs[1], {{"warnings", {"the rim is pressed at the end"}}});
  amend(runs[2], {{"energy", {{"imbalance_relative", -0.005}}}});
  amend(runs[3], {{"energy", {{"imbalance_relative", 0.03}}}});
  amend(runs[4], {{"status", "stopped"}, {"reason", "no step is small enough"}});
  auto options = quick({"signed"});
  const auto c = calibrate(runs, options);
  EXPECT_EQ(c.fit.size(), 3u);
  EXPECT_EQ(c.answer->law.n_runs, 3);
  const auto says = [&](const std::string &words) {
    return std::any_of(c.answer->doubts.begin(), c.answer->doubts.end(),
                       [&](const auto &doubt) { return doubt.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says("window-0.2: the rim is pressed at the end"));
  EXPECT_TRUE(says("window-0.3 counts less: -0.50 % of its energy"));
  EXPECT_TRUE(says("window-0.4 is left out of the fit: 3.00 % of its energy"));
  EXPECT_TRUE(says("window-0.5 is left out of the fit: it is stopped"));
  EXPECT_NE(to_toml_fragment(*c.answer).find("# Doubt: window-0.3 counts less"), std::string::npos);
  options.keep_stopped = true;
  EXPECT_EQ(calibrate(runs, options).fit.size(), 4u);
  EXPECT_THROW(calibrate({runs[3]}, options), DataError);
}

TEST(Answer, SaysWhetherTheSteelBearsIt) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  const double strains[] = {0.05, 0.12, 0.30};
  for (int i = 0; i < 3; ++i) {
    auto scene = window(0.1 * (i + 1));
    scene.bearing = scene::builtin_bearing("shfps-225"); // with its marks: the limit is an assumption
    runs.push_back(folder.write(scene));
    amend(runs[i], {{"max_plastic_strain", strains[i]}, {"rung", "rim"}, {"mesh", 1}});
  }
  const auto c = calibrate(runs, quick({}));
  ASSERT_TRUE(c.answer->strain);
  const auto &s = *c.answer->strain;
  EXPECT_TRUE(s.exceeded());
  EXPECT_TRUE(s.limit_is_assumption);
  EXPECT_NEAR(s.largest_speed_below_limit.value(), 0.2, 1e-9);
  EXPECT_NE(
      s.sentence.find("not shown to bear it: its plastic strain reaches 30 %, beyond its limit of 20 % (an assumption"),
      std::string::npos)
      << s.sentence;
  EXPECT_NE(s.sentence.find("up to 0.2 m/s it stays below"), std::string::npos) << s.sentence;
  EXPECT_EQ(c.answer->source(), "finite elements");
  EXPECT_EQ(to_json(*c.answer)["rung"], "rim");
  EXPECT_EQ(to_json(*c.answer)["mesh"], 1);
  EXPECT_TRUE(c.answer->mesh_error.peak_force) << c.answer->mesh_error.sentence;  // a kept study knows shfps-225
  EXPECT_FALSE(calibrate({folder.write(window(0.4))}, quick({})).answer->strain); // the reduced model knows no strain
}

TEST(Answer, TheMeshOfAnotherRimUnderTheSameNameIsNotKnown) {
  TemporaryFolder folder;
  auto scene = window(0.2);
  scene.bearing.rim.thickness = 0.05; // still "shfps-225"
  const auto run = folder.write(scene);
  amend(run, {{"rung", "rim"}, {"mesh", 1}, {"wall_time_s", 60}});
  const auto error = calibrate({run}, quick({})).answer->mesh_error;
  EXPECT_FALSE(error.peak_force);
  EXPECT_NE(error.sentence.find("unknown"), std::string::npos) << error.sentence;
  EXPECT_NE(error.sentence.find("rimpact study " + run + "/scene.toml --axes mesh --meshes 1,2,3"), std::string::npos)
      << error.sentence;
  EXPECT_NE(error.sentence.find("(about "), std::string::npos) << error.sentence;
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
