#include "responses/limits.h"
#include "responses/steel_by_depth.h"
#include "scene/assumptions.h"
#include "scene/bearing_catalogue.h"
#include "scene/rim_identity.h"
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

Summary one_impact(double speed, double penetration) {
  Summary s;
  s.impacts.push_back({1.0, 1.05, 0.0, speed, 0.5 * speed, 1e6, penetration});
  s.peak_displacement = Bearing{}.lateral_capacity() + penetration;
  return s;
}

std::vector<std::string> warnings(const Summary &s) {
  return s.extra.value("warnings", std::vector<std::string>{});
}

TEST(Limits, AnOrdinaryRunHasNothingToSay) {
  Summary s = one_impact(0.2, 0.005);
  s.max_plastic_strain = 0.05;
  Scene scene;
  scene.reduced.fitted_from = 0.05, scene.reduced.fitted_to = 0.2;
  judge(scene, s);
  EXPECT_EQ(s.extra["beyond_rim"], false);
  EXPECT_EQ(s.extra["beyond_fit"], false);
  EXPECT_EQ(s.extra["strain_limit"]["exceeded"], false);
  EXPECT_TRUE(warnings(s).empty());
}

TEST(Limits, DeeperThanTheRimIsThick) {
  Summary s = one_impact(0.2, 0.090);
  s.extra["warnings"].push_back("an earlier one");
  Scene scene;
  scene.bearing.rim.thickness = 0.050;
  judge(scene, s);
  EXPECT_EQ(s.extra["beyond_rim"], true);
  ASSERT_EQ(warnings(s).size(), 2u);
  EXPECT_NE(warnings(s)[1].find("pressed 90 mm into a rim of 50 mm"), std::string::npos) << warnings(s)[1];
  scene.reduced.model = ModelKind::dcfp; // its rim has no thickness
  judge(scene, s);
  EXPECT_TRUE(s.extra["beyond_rim"].is_null());
}

TEST(Limits, TwoRimsAreEachPressedHalfAsDeep) {
  Scene scene;
  scene.bearing = builtin_bearing("dcfp-155");
  Summary s = one_impact(0.2, 0.030);
  s.peak_displacement = scene.lateral_capacity() + 0.030;
  judge(scene, s);
  EXPECT_EQ(s.extra["beyond_rim"], false) << "15 mm into each rim of 20 mm";
  s.impacts[0].peak_penetration = 0.050;
  judge(scene, s);
  EXPECT_EQ(s.extra["beyond_rim"], true);
}

TEST(Limits, ASliderTurnedByItsRimsTips) {
  Scene scene;
  scene.bearing = builtin_bearing("dcfp-155");
  Summary s = one_impact(0.2, 0.005);
  s.peak_displacement = scene.lateral_capacity();
  // By hand: the rims press 51.81 mm apart; the faces hold W D_s = 853 kN x 0.3 m.
  const double limit = 853e3 * 0.3 / 0.05181;
  s.peak_impact_force = 0.98 * limit;
  judge(scene, s);
  EXPECT_TRUE(warnings(s).empty()) << warnings(s)[0];
  s.peak_impact_force = 1.02 * limit;
  judge(scene, s);
  ASSERT_EQ(warnings(s).size(), 1u);
  EXPECT_NE(warnings(s)[0].find("it tips"), std::string::npos) << warnings(s)[0];
}

TEST(Limits, PastTheDishIsNoResult) {
  Summary s; // no impact element: nothing holds it
  s.peak_displacement = 1.4;
  judge({}, s);
  EXPECT_EQ(s.extra["beyond_rim"], true);
  ASSERT_EQ(warnings(s).size(), 2u);
  EXPECT_NE(warnings(s)[0].find("1400 mm from the middle, past the dish's edge at 520 mm"), std::string::npos)
      << warnings(s)[0];
  EXPECT_NE(warnings(s)[1].find("1000 mm past the wall of a rim of 40 mm that this run leaves out"), std::string::npos)
      << warnings(s)[1];
}

TEST(Limits, StrainBeyondTheCurveIsSaid) {
  Scene scene;
  scene.bearing.steel.hardening.law = HardeningLaw::table;
  scene.bearing.steel.hardening.curve.values = {{0, 360e6}, {0.1, 500e6}};
  Summary within = one_impact(0.2, 0.005), beyond = within;
  within.max_plastic_strain = 0.09, beyond.max_plastic_strain = 0.11;
  judge(scene, within), judge(scene, beyond);
  EXPECT_TRUE(warnings(within).empty());
  ASSERT_EQ(warnings(beyond).size(), 1u);
  EXPECT_NE(warnings(beyond)[0].find("reaches 0.11, beyond the last row of bearing.material.steel.curve at 0.1"),
            std::string::npos)
      << warnings(beyond)[0];
}

/// A rim's own law is fitted to depths: under four times the mass they are reached at half the speeds.
TEST(Limits, SpeedsOfARimsOwnLawMoveWithTheMass) {
  Scene scene;
  scene.reduced.fitted_from = 0.1, scene.reduced.fitted_to = 0.4;
  scene.reduced.fitted_speeds_mass = scene.load.mass / 4;
  const auto beyond = [&](double speed, Summary s = {}) {
    s.impacts.push_back({1.0, 1.05, 0.0, speed, 0.5 * speed, 1e6, 0.005});
    judge(scene, s);
    return s;
  };
  EXPECT_EQ(beyond(0.1).extra["beyond_fit"], false);
  const auto fast = beyond(0.3);
  EXPECT_EQ(fast.extra["beyond_fit"], true);
  EXPECT_NE(warnings(fast).at(0).find("0.05 to 0.2 m/s at"), std::string::npos) << warnings(fast)[0];
  Summary building; // its heaviest loaded bearing carries what the element was fitted under
  building.extra["building"]["bearings"] = {
      {{"static_normal_force_N", *scene.reduced.fitted_speeds_mass * scene.load.gravity}}};
  EXPECT_EQ(beyond(0.3, building).extra["beyond_fit"], false);
}

TEST(Limits, SpeedsOutsideTheFit) {
  Scene scene;
  Summary unknown = one_impact(2.0, 0.01);
  judge(scene, unknown);
  EXPECT_TRUE(unknown.extra["beyond_fit"].is_null());
  scene.reduced.fitted_from = 0.05, scene.reduced.fitted_to = 1.0;
  for (const auto &[speed, beyond] : {std::pair{1.0005, false}, {1.01, true}, {0.05, false}, {0.04, true}}) {
    Summary s = one_impact(speed, 0.01);
    judge(scene, s);
    EXPECT_EQ(s.extra["beyond_fit"], beyond) << speed;
    EXPECT_EQ(warnings(s).size(), beyond ? 1u : 0u);
  }
  Summary fe = one_impact(2.0, 0.01);
  fe.rung = SolvedBy::rim;
  judge(scene, fe);
  EXPECT_EQ(fe.extra["beyond_fit"], true);
  EXPECT_TRUE(warnings(fe).empty()) << "finite elements have no fitted element";
}

// Three hits at 0.02, 0.1 and 0.5 m/s; null: not known, never 0.
TEST(Limits, EveryHitIsCountedAndTheUnknownIsNull) {
  const auto counted = [](const Scene &scene, std::optional<double> strain = {}) {
    Summary s;
    s.max_plastic_strain = strain;
    for (const double speed : {0.02, 0.1, 0.5})
      s.impacts.push_back({1.0, 1.05, 0.0, speed, 0.5 * speed, 1e6, 0.1 * speed});
    judge(scene, s);
    return s.extra["hit_limits"];
  };
  Scene scene;
  scene.reduced.k_i *= 0.9; // an element of which nothing is known
  EXPECT_TRUE(counted(scene)["hits_beyond_fit"].is_null());
  EXPECT_TRUE(counted(scene)["hits_beyond_pair"].is_null());
  EXPECT_TRUE(counted(scene)["hits_beyond_steel"].is_null());
  EXPECT_TRUE(counted(scene)["known_to_m_s"].is_null());
  EXPECT_EQ(counted(scene)["fastest_approach_speed_m_s"], 0.5);
  EXPECT_EQ(counted(scene)["slowest_approach_speed_m_s"], 0.02);
  scene.bearing.rim.thickness = 0.045;
  EXPECT_EQ(counted(scene)["hits_beyond_rim"], 1);
  scene.reduced.fitted_from = 0.05, scene.reduced.fitted_to = 0.2;
  EXPECT_EQ(counted(scene)["hits_beyond_fit"], 2);
  EXPECT_EQ(counted(scene)["known_to_m_s"], 0.2);
  EXPECT_EQ(counted({})["hits_beyond_pair"], 1) << "the thesis's own bearing on the thesis's pair";
  Scene heavy;
  heavy.load.mass *= 3, heavy.load.vertical *= 3;
  EXPECT_EQ(counted(heavy)["hits_beyond_pair"], 3) << "nothing is published for this mass";
  Scene steel;
  steel.bearing.steel.strain_limit = 0.2;
  EXPECT_EQ(counted(steel, 0.1)["hits_beyond_steel"], 0);
  EXPECT_TRUE(counted(steel, 0.3)["hits_beyond_steel"].is_null()) << "which of them did it is not known";
}

// 10 % at 4 mm, 30 % at 12 mm: a straight line meets 20 % at 8 mm; what no run is as deep as is known only beyond
TEST(Limits, TheCalibrationsRunsTellTheStrainOfAPenetration) {
  const SteelByDepth steel({{0.012, 0.30}, {0.004, 0.10}, {0.008, 0.05}});
  EXPECT_EQ(steel.is_beyond(0.009, 0.2), false) << "a strain that fell, of another load, does not count";
  EXPECT_EQ(steel.is_beyond(0.0101, 0.2), true);
  EXPECT_EQ(steel.is_beyond(0.030, 0.2), true);
  EXPECT_EQ(steel.is_beyond(0.0019, 0.05), false);
  EXPECT_EQ(steel.is_beyond(0.0021, 0.05), true) << "from no strain at no depth";
  EXPECT_EQ(steel.is_beyond(0.012, 0.4), false);
  EXPECT_FALSE(steel.is_beyond(0.013, 0.4)) << "no run was as deep";
}

/// A reduced run with a calibration's element of this rim counts its hits beyond the steel; else it is not known.
TEST(Limits, HitsBeyondTheSteelOfAReducedRunAreCounted) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("rimpact-steel-" + std::to_string(::getpid()));
  fs::create_directories(folder / "other");
  std::ofstream(folder / "calibration.json")
      << R"({"answer": {"law": {"name": "signed", "element": {}}, "strain": {"rows": [
             {"speed_m_s": 0.2, "penetration_mm": 4, "strain": 0.1}, {"speed_m_s": 0.5, "penetration_mm": 12, "strain": 0.3}, {"speed_m_s": 1, "strain": 0.9}]}}})";
  std::ofstream(folder / "other" / "calibration.json") << R"({"answer": {"strain": null}})";
  const auto counted = [](const Scene &scene) {
    Summary s;
    for (const double depth : {0.002, 0.007, 0.009, 0.020}) s.impacts.push_back({1.0, 1.05, 0.0, 0.5, 0.2, 1e6, depth});
    judge(scene, s);
    return s.extra["hit_limits"]["hits_beyond_steel"];
  };
  Scene scene;
  scene.bearing = builtin_bearing("shfps-225");
  EXPECT_TRUE(counted(scene).is_null()) << "no calibration";
  scene.reduced.calibration = folder, scene.reduced.fitted_rim = rim_identity(scene.bearing);
  EXPECT_EQ(counted(scene), 2);
  scene.bearing.steel.strain_limit = 0.35;
  EXPECT_TRUE(counted(scene).is_null()) << "20 mm are deeper than any run";
  scene.bearing.steel.strain_limit.reset();
  EXPECT_TRUE(counted(scene).is_null()) << "no limit";
  scene.bearing = builtin_bearing("shfps-225"), scene.bearing.rim.thickness = 0.05;
  EXPECT_TRUE(counted(scene).is_null()) << "another rim";
  scene.bearing = builtin_bearing("shfps-225"), scene.reduced.calibration = folder / "other";
  EXPECT_TRUE(counted(scene).is_null()) << "a calibration without strain";
  fs::remove_all(folder);
}

TEST(Limits, StrainOfTheSteel) {
  Scene scene;
  scene.bearing = builtin_bearing("shfps-225");
  Summary s = one_impact(1.0, 0.01);
  s.max_plastic_strain = 0.475;
  judge(scene, s);
  EXPECT_EQ(s.extra["strain_limit"],
            (nlohmann::json{
                {"limit", 0.2}, {"largest", 0.475}, {"place", nullptr}, {"exceeded", true}, {"assumption", true}}));
  EXPECT_NE(warnings(s)[0].find("47.5 %, above the 20 %"), std::string::npos) << warnings(s)[0];
  EXPECT_NE(warnings(s)[0].find("an assumption"), std::string::npos);
  scene.bearing.assumed.keys.clear();
  Summary given = one_impact(1.0, 0.01);
  given.max_plastic_strain = 0.475;
  judge(scene, given);
  EXPECT_EQ(given.extra["strain_limit"]["assumption"], false);
  EXPECT_EQ(warnings(given)[0].find("an assumption"), std::string::npos);
  scene.bearing.steel.strain_limit.reset();
  judge(scene, given);
  EXPECT_TRUE(given.extra["strain_limit"].is_null());
}

/// The question is whether the rim holds: a slider's edge that is crushed is another.
TEST(Limits, TheRimsStrainIsJudgedAndTheSlidersEdgeIsSaidBeside) {
  Scene scene;
  scene.bearing = builtin_bearing("shfps-225");
  Summary s = one_impact(0.4, 0.01);
  s.max_plastic_strain = 0.36;
  s.steel = {{SteelPlace::rim_wall, {.largest = 0.12, .averaged = 0.08, .triaxiality = -0.2, .damage = 0.01}},
             {SteelPlace::rim_root,
              {.largest = 0.17, .averaged = 0.15, .triaxiality = 0.5, .damage = 0.12, .place = {0.522, 0, 0.088}}},
             {SteelPlace::dish, {.largest = 0.05, .averaged = 0.04, .triaxiality = 0.3, .damage = 0.02}},
             {SteelPlace::slider_edge, {.largest = 0.36, .averaged = 0.21, .triaxiality = -0.7, .damage = 0.03}}};
  judge(scene, s);
  EXPECT_EQ(s.extra["strain_limit"]["largest"], 0.15);
  EXPECT_EQ(s.extra["strain_limit"]["place"], "rim_root");
  EXPECT_EQ(s.extra["strain_limit"]["exceeded"], false);
  EXPECT_EQ(s.extra["hit_limits"]["hits_beyond_steel"], 0) << "the slider's edge counts no hit";
  ASSERT_EQ(warnings(s).size(), 1u);
  EXPECT_NE(warnings(s)[0].find("the slider's edge is crushed: its plastic strain reaches 21.0 %"), std::string::npos)
      << warnings(s)[0];
  const auto written = to_json(s)["steel"];
  EXPECT_EQ(written["rim_root"]["limit"], 0.2);
  EXPECT_EQ(written["rim_root"]["place_mm"][0], 522);
  const SteelReport back = steel_report_in(to_json(s), "here");
  EXPECT_EQ(back.at(SteelPlace::rim_root).triaxiality, 0.5);
  EXPECT_EQ(back.at(SteelPlace::slider_edge).averaged, 0.21);
  Scene hard = scene; // a slider of its own, beside a rim that is not judged
  hard.bearing.part_steels[SteelPart::slider] = hard.bearing.steel;
  hard.bearing.steel.strain_limit.reset();
  Summary own = s;
  own.extra = {};
  judge(hard, own);
  ASSERT_EQ(warnings(own).size(), 1u);
  EXPECT_NE(warnings(own)[0].find("the slider's edge is crushed"), std::string::npos) << warnings(own)[0];
  s.steel[SteelPlace::dish].averaged = 0.25;
  s.extra = {};
  judge(scene, s);
  EXPECT_EQ(s.extra["strain_limit"]["exceeded"], true);
  EXPECT_EQ(s.extra["hit_limits"]["hits_beyond_steel"], 1);
  EXPECT_NE(warnings(s)[0].find("plastic strain of the dish below the rim reaches 25.0 %, above the 20 %"),
            std::string::npos)
      << warnings(s)[0];
}

/// Each place is held against the limit of its own part's steel; the judged one has most of its limit.
TEST(Limits, PartsOfTheirOwnSteelHaveLimitsOfTheirOwn) {
  Scene scene;
  scene.bearing = builtin_bearing("shfps-225");
  Material iron = scene.bearing.steel, tough = scene.bearing.steel;
  iron.strain_limit = 0.05, tough.strain_limit = 0.40;
  scene.bearing.part_steels = {{SteelPart::rim, iron}, {SteelPart::slider, tough}};
  scene.bearing.assumed.keys = {"material.rim.strain_limit"};
  Summary s = one_impact(0.4, 0.01);
  s.max_plastic_strain = 0.36;
  s.steel = {{SteelPlace::rim_wall, {.largest = 0.12, .averaged = 0.06}},
             {SteelPlace::dish, {.largest = 0.15, .averaged = 0.10}},
             {SteelPlace::slider_edge, {.largest = 0.36, .averaged = 0.30}}};
  judge(scene, s);
  EXPECT_EQ(s.extra["strain_limit"],
            (nlohmann::json{
                {"limit", 0.05}, {"largest", 0.06}, {"place", "rim_wall"}, {"exceeded", true}, {"assumption", true}}));
  ASSERT_EQ(warnings(s).size(), 1u) << "the slider bears 40 %";
  EXPECT_NE(
      warnings(s)[0].find("above the 5 % that the steel is trusted to (material.rim.strain_limit, an assumption)"),
      std::string::npos)
      << warnings(s)[0];
  const auto written = to_json(s)["steel"];
  EXPECT_EQ(written["rim_wall"]["limit"], 0.05);
  EXPECT_EQ(written["dish"]["limit"], 0.2);
  EXPECT_EQ(written["slider_edge"]["limit"], 0.4);
  EXPECT_EQ(*steel_report_in(to_json(s), "here").at(SteelPlace::dish).limit, 0.2);
  EXPECT_EQ(s.extra["hit_limits"]["hits_beyond_steel"], 1);
}

} // namespace
