// What an answer says against itself: doubts of its runs, the strain of the steel, the error of the mesh.
#include "answer_runs.h"
#include "calibration/answer/answer_json.h"
#include "calibration/answer/answer_text.h"
#include "calibration/answer/said_once.h"
#include "io/files/error.h"
#include "scene/bearing_catalogue.h"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

TEST(AnswerDoubts, OfOneKindAreOneLineWithACountAndTheWorst) {
  using Sentences = std::vector<std::string>;
  const Sentences one{"window-0.10: plastic strain reaches 21.0 %, above the 20 % that the steel is trusted to"};
  EXPECT_EQ(said_once(one), one);
  const Sentences alike{
      "window-0.10: plastic strain reaches 21.0 %, above the 20 % that the steel is trusted to",
      "ricker-0.78g-1.0s-x1.05: plastic strain reaches 56.6 %, above the 20 % that the steel is trusted to",
      "window-0.35: the rim is pressed at the end",
      "window-1.20: plastic strain reaches 33.0 %, above the 20 % that the steel is trusted to"};
  EXPECT_EQ(said_once(alike), (Sentences{"3 alike, the worst: " + alike[1], alike[2]}));
  // a run's name inside the sentence, and a sign
  const Sentences counted{"window-0.3 counts less: -0.50 % of its energy",
                          "window-0.4 counts less: 0.30 % of its energy"};
  EXPECT_EQ(said_once(counted), Sentences{"2 alike, the worst: " + counted[0]});
  EXPECT_TRUE(said_once({}).empty());
}

/// The program and the report tell doubts apart by one file; both are held to the same table
/// (tests/report/test_alike.py).
TEST(AnswerDoubts, AreAlikeAsTheReportHasThem) {
  const auto cases = nlohmann::json::parse(std::ifstream(RIMPACT_REFERENCES "/../../tests/alike.json"));
  ASSERT_FALSE(cases.empty());
  for (const auto &each : cases) {
    const auto said = each["said"].get<std::vector<std::string>>();
    const auto once = said_once(said);
    ASSERT_EQ(once.size(), each["kinds"].get<std::size_t>()) << said[0];
    if (once.size() == 1) EXPECT_TRUE(once[0].ends_with(said[each["worst"].get<std::size_t>()])) << once[0];
  }
}

TEST(AnswerDoubts, DoubtsOfRunsTravelAndWeigh) {
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

TEST(AnswerDoubts, SaysWhetherTheSteelBearsIt) {
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
  EXPECT_NE(s.sentence.find(
                "The rim is not shown to bear it. The plastic strain of some body, the slider perhaps, reaches 30 %, "
                "beyond its limit of 20 % (an assumption"),
            std::string::npos)
      << s.sentence;
  EXPECT_NE(s.sentence.find("Up to 0.2 m/s it stays below"), std::string::npos) << s.sentence;
  EXPECT_EQ(c.answer->source(), "finite elements");
  EXPECT_EQ(to_json(*c.answer)["rung"], "rim");
  EXPECT_EQ(to_json(*c.answer)["mesh"], 1);
  EXPECT_TRUE(c.answer->mesh_error.peak_force) << c.answer->mesh_error.sentence;  // a kept study knows shfps-225
  EXPECT_FALSE(calibrate({folder.write(window(0.4))}, quick({})).answer->strain); // the reduced model knows no strain
}

/// One whose steel is known by its places is judged by the rim, with a line each for a crack and for the slider's edge.
TEST(AnswerDoubts, TheRimIsJudgedByItsOwnSteel) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  const double rim[] = {0.02, 0.09, 0.15}, edge[] = {0.05, 0.15, 0.30};
  for (int i = 0; i < 3; ++i) {
    auto scene = window(0.1 * (i + 1));
    scene.bearing = scene::builtin_bearing("shfps-225");
    runs.push_back(folder.write(scene));
    const SteelReport steel{{SteelPlace::rim_root,
                             {.largest = 2 * rim[i],
                              .averaged = rim[i],
                              .damage = rim[i],
                              .averaged_damage = 4 * rim[i] * rim[i],
                              .averaged_locus_damage = 60 * rim[i] * rim[i]}},
                            {SteelPlace::slider_edge, {.largest = 2 * edge[i], .averaged = edge[i]}}};
    amend(runs[i], {{"max_plastic_strain", 2 * edge[i]}, {"steel", to_json(steel)}, {"rung", "rim"}, {"mesh", 1}});
  }
  const auto c = calibrate(runs, quick({}));
  const auto &s = *c.answer->strain;
  EXPECT_FALSE(s.exceeded());
  EXPECT_EQ(s.largest.place, SteelPlace::rim_root);
  EXPECT_EQ(s.sentence,
            "The rim bears it, up to 0.3 m/s. The plastic strain of the rim's root, a mean over 12 mm around it, "
            "reaches 15 %, below its limit of 20 % (an assumption: take your steel's).");
  EXPECT_NE(s.crack_sentence.find("the runs reach 1.35, in the rim's root at 0.3 m/s"), std::string::npos)
      << s.crack_sentence;
  EXPECT_NE(s.crack_sentence.find("a finer mesh moves by up to 20 %"), std::string::npos) << s.crack_sentence;
  EXPECT_NE(s.slider_sentence.find("crushed, by 30 % at 0.3 m/s"), std::string::npos) << s.slider_sentence;
  EXPECT_EQ(to_json(*c.answer)["strain"]["rows"][1]["place"], "rim_root");
  ASSERT_EQ(s.places.size(), 2u);
  // 0.486 at 0.2 m/s, 1.35 at 0.3: a straight line passes 1 at 0.259 m/s.
  EXPECT_EQ(s.places[0].sentence,
            "the rim's root: damage 1.35 at 0.3 m/s (by Bao and Wierzbicki; 0.09 by Johnson and Cook), 1 passed at "
            "about 0.26 m/s (runs at 0.2 and 0.3); strain 15 % at 0.3 m/s, its limit of 20 % not reached");
  // Between 15 % at 0.2 m/s and 30 % at 0.3 m/s a straight line passes 20 % a third of the way.
  EXPECT_EQ(s.places[1].sentence, "the slider's edge: damage 0.00 at 0.1 m/s (by Johnson and Cook; 0.00 by Bao and "
                                  "Wierzbicki), 1 not reached; strain 30 % at 0.3 m/s, "
                                  "its limit of 20 % passed at about 0.23 m/s (runs at 0.2 and 0.3)");
  EXPECT_NEAR(to_json(*c.answer)["strain"]["places"][0]["damage_bao_wierzbicki"], 1.35, 1e-9);
  EXPECT_NEAR(*s.places[1].limit.expected, 0.2 + 0.1 / 3, 1e-6);
  EXPECT_EQ(to_json(*c.answer)["strain"]["places"][1]["limit"]["beyond_m_s"], s.places[1].limit.beyond);
}

TEST(AnswerDoubts, TheMeshOfAnotherRimUnderTheSameNameIsNotKnown) {
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

/// A law ends at the fastest run whose foot bears it; of a rim in one piece the needed weld is told.
TEST(AnswerDoubts, TheLawEndsWhereTheRimsFootGoes) {
  TemporaryFolder folder;
  std::vector<std::string> runs, whole;
  for (int i = 0; i < 4; ++i) {
    auto scene = window(0.1 * (i + 1));
    FootReport foot;
    foot.weld = 1e6 * (i + 1), foot.needed_throat = 0.004 * (i + 1), foot.worst = {0, 2e6 * (i + 1), 0, 3e4 * (i + 1)};
    whole.push_back(folder.write(scene));
    amend(whole[i], {{"rung", "rim"}, {"mesh", 1}, {"rim_foot", to_json(foot, scene.bearing.rim.connection)}});
    scene.bearing.rim.connection.kind = scene::ConnectionKind::fillet, scene.bearing.rim.connection.throat = 0.010;
    scene.name += "-fillet";
    foot.use = 0.4 * (i + 1); // beyond 1 at 0.3 m/s
    if (i >= 2) foot.goes_at_force = 8e5 + 1e4 * i;
    runs.push_back(folder.write(scene));
    amend(runs[i], {{"rung", "rim"},
                    {"mesh", 1},
                    {"max_plastic_strain", 0.05},
                    {"rim_foot", to_json(foot, scene.bearing.rim.connection)}});
  }
  const auto c = calibrate(runs, quick({"signed"}));
  ASSERT_TRUE(c.answer->foot);
  ASSERT_TRUE(c.answer->strain);
  EXPECT_EQ(c.answer->strain->sentence.find("The rim breaks off its plate between 0.2 and 0.3 m/s, where the joint at "
                                            "its foot goes. In one piece with the plate its steel would bear it, up"),
            0u)
      << c.answer->strain->sentence;
  EXPECT_NEAR(c.answer->foot->runs.gone.expected.value(), 0.25, 1e-9);
  EXPECT_NEAR(c.answer->law.fitted_to, 0.2, 1e-3) << "the law ends there";
  EXPECT_LE(c.answer->law.valid_to.value_or(0), 0.2 + 1e-3);
  EXPECT_NEAR(c.answer->table.back().speed, 0.2, 1e-3);
  EXPECT_NE(c.answer->foot->sentence.find("used to 1.60 at 0.4 m/s, 1 passed at about 0.25 m/s (runs at 0.2 and 0.3)"),
            std::string::npos)
      << c.answer->foot->sentence;
  EXPECT_NE(c.answer->validity.find("It ends at 0.2 m/s"), std::string::npos) << c.answer->validity;
  EXPECT_NE(to_toml_fragment(*c.answer).find("# Doubt: The joint at the rim's foot"), std::string::npos);
  const auto json = to_json(*c.answer)["rim_foot"];
  EXPECT_EQ(json["rows"].size(), 4u);
  EXPECT_EQ(json["goes_at_force_kN"], 820) << "the least of all runs";
  EXPECT_NEAR(json["borne_to_m_s"].get<double>(), 0.2, 1e-3);
  EXPECT_NEAR(json["goes_at_m_s"].get<double>(), 0.3, 1e-3);
  EXPECT_EQ(json["joint"], scene::strength_in_words(c.scene.bearing.rim.connection));
  EXPECT_NE(to_toml_fragment(*c.answer).find("foot_force_kN = 820\n"), std::string::npos);
  EXPECT_NE(c.answer->foot->doubt.find("at a rim force of 820 kN"), std::string::npos) << c.answer->foot->doubt;
  // With fast steel the joint goes earlier: the law ends there.
  auto options = quick({"signed"});
  options.steel_band = SteelBand{};
  FootReport bears, breaks;
  bears.use = 0.9, breaks.use = 1.3;
  options.steel_band->twins = {{.speed = 0.1, .static_steel = {}, .fast = {}, .fast_foot = bears},
                               {.speed = 0.2, .static_steel = {}, .fast = {}, .fast_foot = breaks}};
  const auto banded = answer_foot(c, {}, options.steel_band);
  EXPECT_FALSE(banded) << "no run tells";
  AnswerFoot both = *c.answer->foot;
  both.twins.rows = {{0.1, bears}, {0.2, breaks}}, both.twins.gone = passing({{0.1, 0.9}, {0.2, 1.3}}, 1);
  EXPECT_NEAR(both.goes_at().value(), 0.2, 1e-9);
  EXPECT_NEAR(both.borne_to().value(), 0.1, 1e-3);
  both.twins.rows = {{0.05, breaks}}, both.twins.gone = passing({{0.05, 1.3}}, 1);
  EXPECT_FALSE(both.borne_to());
  const auto one_piece = calibrate(whole, quick({"signed"}));
  EXPECT_NEAR(one_piece.answer->law.fitted_to, 0.4, 1e-3);
  EXPECT_NE(
      one_piece.answer->foot->sentence.find("one piece with the plate, an assumption (bearing.rim.connection); at "
                                            "0.4 m/s each mm of it carries 8.00 kN of shear and 120 kN mm"),
      std::string::npos)
      << one_piece.answer->foot->sentence;
  EXPECT_TRUE(one_piece.answer->foot->doubt.empty());
}

} // namespace
} // namespace rimpact::calibration
