// Every sentence of an answer used: what it says is typed into a scene and run.
#include "answer_runs.h"
#include "calibration/laws/law_errors.h"
#include "calibration/laws/percent.h"
#include "calibration/laws/windows_table.h"
#include <gtest/gtest.h>
#include <regex>

namespace rimpact::calibration {
namespace {
using namespace testing;

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

/// For each law, runs that it has made: what its sentences say is typed in over the stated range.
TEST(AnswerSentences, WhatTheSentencesSayHoldsWhenTyped) {
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
TEST(AnswerSentences, WhatTheSentencesSayHoldsOfKeptFiniteElements) {
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
  EXPECT_NEAR(answer.strain->largest.largest, 0.566, 1e-3);
  EXPECT_NEAR(answer.strain->largest_speed_below_limit.value(), 0.1, 1e-3);
}

} // namespace
} // namespace rimpact::calibration
