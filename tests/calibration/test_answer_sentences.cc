// Every sentence of an answer used: what it says is typed into a scene and run.
#include "answer_runs.h"
#include "calibration/answer/answer_mesh_error.h"
#include "calibration/answer/answer_range.h"
#include "calibration/laws/law_errors.h"
#include "calibration/laws/percent.h"
#include "calibration/laws/windows_table.h"
#include "scene/toml_writer.h"
#include <cmath>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <regex>
#include <sstream>

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

/// Parted at full stops before a space.
std::vector<std::string> sentences_of(const std::string &text) {
  std::vector<std::string> found;
  std::size_t from = 0;
  for (auto stop = text.find(". "); stop != std::string::npos; stop = text.find(". ", from))
    found.push_back(text.substr(from, stop + 1 - from)), from = stop + 2;
  found.push_back(text.substr(from));
  return found;
}

int words_of(const std::string &sentence) {
  std::istringstream words(sentence);
  return static_cast<int>(std::distance(std::istream_iterator<std::string>(words), {}));
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

/// A law whose runs are as given, each by itself and nothing left out.
AnswerLaw law_of(std::vector<LawError> fitted) {
  Choice choice{.row = {}, .chosen_by = ChosenBy::only, .remark = {}};
  choice.row.result.law = "elastoplastic";
  choice.row.fitted = std::move(fitted);
  return answer_law(choice, yielding(0.1), {}, 0.05);
}

/// The largest error of no run is not zero: what is not known is said to be so.
TEST(AnswerSentences, AnErrorThatIsNotKnownIsNoneOfZero) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto nothing = law_of({}), unjudged = law_of({{"a", 0.1, unknown, unknown, unknown, unknown, unknown, false}});
  for (const auto &law : {nothing, unjudged}) {
    EXPECT_NE(law.sentence.find("not known"), std::string::npos) << law.sentence;
    EXPECT_TRUE(bounds_in(law.sentence).empty()) << law.sentence;
  }
  // runs that graze, where there are no others, are judged as they are
  const auto grazing =
      law_of({{"a", 0.01, -0.089, 0.1, 0.4, 0.1, 0.1, true}, {"b", 0.02, 0.01, 0.1, 0.1, 0.1, 0.1, true}});
  const auto bounds = bounds_in(grazing.sentence);
  ASSERT_EQ(bounds.size(), 2u) << grazing.sentence;
  EXPECT_NEAR(bounds[0], 0.089, 1e-12);
  EXPECT_NEAR(bounds[1], 0.4, 1e-12);
  EXPECT_TRUE(std::isnan(larger_of(0.1, unknown)) && std::isnan(larger_of(unknown, 0.1)));
}

TEST(AnswerSentences, WhatCouldNotBeLeftOutIsNotKnown) {
  TemporaryFolder folder;
  const auto c = calibrate({stand_in(folder, yielding(0.3))}, quick({"signed"}));
  const auto row = to_json(c)["laws"]["rows"][0];
  EXPECT_TRUE(row["left_out_peak_force_error"].is_null() && row["left_out_rebound_error"].is_null()) << row;
  EXPECT_TRUE(row["largest_peak_force_error"].is_number());
  EXPECT_TRUE(to_json(c)["answer"]["law"]["worst_left_out"].is_null());
  const std::string text = describe(c);
  EXPECT_NE(text.find("not known, for too few runs"), std::string::npos) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("signed .* not known +not known\n"))) << text;
}

/// Those of a page that is handed over: short, three figures, no codes.
TEST(AnswerSentences, AreShortAndPlain) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  for (const double v : {0.0698, 0.142, 0.289, 1.2}) runs.push_back(stand_in(folder, yielding(v)));
  for (auto laws : {std::vector<std::string>{"signed", "elastoplastic"}, std::vector<std::string>{}}) {
    const auto c = calibrate(runs, quick(laws));
    const auto &a = *c.answer;
    for (const auto &text : {a.validity, a.pair ? a.pair->sentence : a.no_pair, a.mesh_error.sentence, a.law.remark}) {
      for (const auto &sentence : sentences_of(text)) EXPECT_LE(words_of(sentence), 30) << sentence;
      EXPECT_FALSE(
          std::regex_search(text, std::regex(R"([0-9a-f]{12}|\binf\b|\bnan\b|[0-9]\.[0-9]{5}|[1-9]\.[0-9]{3})")))
          << text;
    }
    EXPECT_FALSE(c.notes.empty()); // a pair over such speeds leaves something to say, of its law alone
    for (const auto &note : c.notes) EXPECT_EQ(note.rfind("law signed fitted by itself: ", 0), 0u) << note;
    EXPECT_NE(a.validity.find("rim 60 mm high, 40 mm thick"), std::string::npos) << a.validity;
  }
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
