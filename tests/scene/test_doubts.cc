#include "scene/bearing_catalogue.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include "scene/isolator_catalogue.h"
#include "scene/isolator_doubts.h"
#include "scene/rim_identity.h"
#include "temporary_folder.h"
#include <functional>
#include <gtest/gtest.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

TEST(Doubts, NoneAboutTheDefaultScene) {
  EXPECT_TRUE(doubts(Scene{}).empty());
}

TEST(Doubts, AMassInTonnesIsNoticed) {
  Scene s;
  s.load.mass /= 1000;
  ASSERT_EQ(doubts(s).size(), 1u);
  EXPECT_NE(doubts(s)[0].find("1e+03 times load.mass_kg = 86.952"), std::string::npos) << doubts(s)[0];
  EXPECT_NE(doubts(s)[0].find("are the units right?"), std::string::npos) << doubts(s)[0];
  EXPECT_TRUE(doubts(s, false).empty()); // a building's bearings carry shares of it
  s.load.vertical = 0;                   // no weight is a case of its own, not a slip
  EXPECT_TRUE(doubts(s).empty());
}

TEST(Doubts, ARecordInTheWrongUnitIsNoticed) {
  Scene s;
  s.excitation.kind = ExcitationKind::record;
  s.excitation.x = {0.01, {0, 300, -780}}; // cm/s^2 read as m/s^2
  ASSERT_EQ(doubts(s).size(), 1u);
  EXPECT_NE(doubts(s)[0].find("79.5 g"), std::string::npos) << doubts(s)[0];
  s.excitation.scale = 0.01;
  EXPECT_TRUE(doubts(s).empty());
}

TEST(Doubts, AnImpactOfTenMetresASecondIsNoticed) {
  Scene s;
  s.excitation.kind = ExcitationKind::window;
  s.excitation.speed = 11;
  EXPECT_EQ(doubts(s).size(), 1u);
}

TEST(Doubts, AWeightTwiceItsMassIsNoticed) {
  Scene s;
  s.load.vertical = 2000e3;
  ASSERT_EQ(doubts(s).size(), 1u);
  EXPECT_NE(doubts(s)[0].find("2000 is 2.3 times load.mass_kg = 86952 times gravity (853 kN)"), std::string::npos)
      << doubts(s)[0];
  s.load.vertical = 1.9 * 853e3;
  EXPECT_TRUE(doubts(s).empty());
}

TEST(Doubts, StressesInPascalsAreNoticed) {
  for (const double yield : {355e12, 0.355e6}) {
    Scene s;
    s.bearing.steel.yield = yield;
    ASSERT_EQ(doubts(s).size(), 1u) << yield;
    EXPECT_NE(doubts(s)[0].find("is its unit MPa?"), std::string::npos) << doubts(s)[0];
  }
  Scene s;
  s.bearing.steel.E = 200e3, s.bearing.steel.density = 7.85, s.bearing.ertalyte.density = 1.39,
  s.bearing.ertalyte.E = 3.2e6;
  EXPECT_EQ(doubts(s).size(), 4u);
}

TEST(Doubts, APadOnASphereIsShapedToIt) {
  Scene s;
  s.bearing.surface.kind = SurfaceKind::sphere, s.bearing.surface.R0 = 3;
  EXPECT_TRUE(doubts(s).empty()) << "rung rim has no pad";
  s.model.rung = Rung::full;
  ASSERT_EQ(doubts(s).size(), 1u);
  EXPECT_NE(doubts(s)[0].find("pad.shape_radius_mm = 1400 on a sphere of R0_m = 3: a pad shaped to its dish has 3000"),
            std::string::npos)
      << doubts(s)[0];
}

TEST(Doubts, TheThesissPairBelongsToOneBearing) {
  Scene s;
  s.bearing = builtin_bearing("shfps-225");
  EXPECT_TRUE(doubts_of_element(s).empty());
  s.bearing.name = "under another name";
  EXPECT_TRUE(doubts_of_element(s).empty());
  s.bearing.rim.thickness = 0.050;
  ASSERT_EQ(doubts_of_element(s).size(), 1u);
  for (const char *words :
       {"k_i = 450000 kN/m, e = 0.65", "the thesis's for shfps-225", "not this bearing's", "--calibration DIR"})
    EXPECT_NE(doubts_of_element(s)[0].find(words), std::string::npos) << doubts_of_element(s)[0];
  Scene own = s;
  own.reduced.k_i = 1e8;
  EXPECT_TRUE(doubts_of_element(own).empty()) << "k_i is the user's";
  own = s, own.reduced.model = ModelKind::dcfp;
  ASSERT_EQ(doubts_of_element(own).size(), 1u) << "another kind of bearing";
  EXPECT_NE(doubts_of_element(own)[0].find("not this isolator's"), std::string::npos) << doubts_of_element(own)[0];
  EXPECT_NE(doubts_of_element(own)[0].find("surface.concave"), std::string::npos) << doubts_of_element(own)[0];
  own.reduced.model = ModelKind::tfp;
  EXPECT_NE(doubts_of_element(own)[0].find("tfp-kim-2023-inner"), std::string::npos) << doubts_of_element(own)[0];
  own.reduced.model = ModelKind::dcfp;
  own.reduced.k_i = 1e8;
  EXPECT_TRUE(doubts_of_element(own).empty()) << "k_i is the user's";
  own.reduced.fitted_rim = rim_identity(s.bearing); // a law of one dish's rim, whichever it is
  ASSERT_EQ(doubts_of_element(own).size(), 1u);
  EXPECT_NE(doubts_of_element(own)[0].find("fitted to another rim"), std::string::npos) << doubts_of_element(own)[0];
  own = s, own.excitation.kind = ExcitationKind::cyclic;
  EXPECT_TRUE(doubts_of_element(own).empty()) << "never touched";
  own = s, own.reduced.impact_law = &laws::impact_law("elastoplastic");
  ASSERT_EQ(doubts_of_element(own).size(), 1u);
  EXPECT_NE(doubts_of_element(own)[0].find("defaults of the law"), std::string::npos);
  s.bearing = builtin_bearing("shfps-225"), s.load.mass = 203900;
  ASSERT_EQ(doubts_of_element(s).size(), 1u);
  EXPECT_NE(doubts_of_element(s)[0].find("not this mass's"), std::string::npos);
}

/// A bearing ten times larger or smaller in all its dimensions is as good as another: sizes are held against its own.
TEST(Doubts, SizesAreHeldAgainstTheBearingsOwn) {
  const auto of = [](double scale, const std::function<void(Bearing &)> &change) {
    Scene s;
    Bearing &b = s.bearing;
    for (double *length :
         {&b.surface.planar_radius, &b.slider.diameter, &b.rim.height, &b.rim.thickness, &b.plate.base})
      *length *= scale;
    s.load.vertical *= scale * scale, s.load.mass *= scale * scale;
    change(b);
    return doubts(s);
  };
  for (const double scale : {0.2, 1.0, 3.0}) {
    EXPECT_TRUE(of(scale, [](Bearing &) {}).empty()) << scale;
    for (const double slip : {1e-3, 1 / 25.4}) { // metres, inches for millimetres
      const auto rim = of(scale, [&](Bearing &b) { b.rim.thickness *= slip; });
      ASSERT_EQ(rim.size(), 1u) << scale;
      EXPECT_NE(rim[0].find("bearing.rim.thickness_mm = "), std::string::npos) << rim[0];
      EXPECT_NE(rim[0].find("is its unit mm?"), std::string::npos) << rim[0];
      EXPECT_FALSE(of(scale, [&](Bearing &b) { b.plate.base *= slip; }).empty()) << scale;
      EXPECT_FALSE(of(scale, [&](Bearing &b) { b.slider.diameter *= slip; }).empty()) << scale;
    }
  }
}

TEST(Doubts, ALoadIsHeldAgainstTheSlidersArea) {
  for (const double vertical : {3.2e3, 853e6}) { // the mass follows it, so that the two agree
    Scene s;
    s.load.vertical = vertical, s.load.mass = vertical / s.load.gravity;
    ASSERT_EQ(doubts(s).size(), 1u) << vertical;
    EXPECT_NE(doubts(s)[0].find("presses a slider of 240 mm"), std::string::npos) << doubts(s)[0];
    EXPECT_NE(doubts(s)[0].find("is its unit kN?"), std::string::npos) << doubts(s)[0];
    EXPECT_TRUE(doubts(s, false).empty()); // a building's bearings carry shares of it
    s.reduced.model = ModelKind::dcfp;     // another slider
    EXPECT_TRUE(doubts(s).empty());
  }
}

TEST(Doubts, RecordsThatBelongToAnotherAxis) {
  const TemporaryFolder folder;
  const std::string text = "PEER\nMADE UP\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .01 SEC\n .1 .2 .1\n";
  const std::string along = folder.write("A090.AT2", text), up = folder.write("A-UP.AT2", text),
                    lone = folder.write("lone.AT2", text);
  const auto of = [](const std::string &x, const std::string &y, const std::string &z) {
    Scene s;
    s.excitation.kind = ExcitationKind::record;
    s.excitation.x_file = x, s.excitation.y_file = y, s.excitation.z_file = z;
    return doubts(s);
  };
  EXPECT_TRUE(of(along, lone, up).empty());
  EXPECT_TRUE(of("builtin:near-fault-x", "builtin:near-fault-y", "").empty());
  ASSERT_EQ(of(up, "", "").size(), 1u);
  EXPECT_NE(of(up, "", "")[0].find("excitation.x = " + up + " is a vertical record"), std::string::npos);
  ASSERT_EQ(of("", "", along).size(), 1u);
  ASSERT_EQ(of(along, along, "").size(), 1u);
  EXPECT_NE(of(along, along, "")[0].find("excitation.x and excitation.y are the same component"), std::string::npos);
  // Of another station: A090 beside its own A000 is none, B000 is one, along any two axes; what says no station is
  // none.
  const std::string across = folder.write("A000.AT2", text), other = folder.write("B000.AT2", text),
                    other_up = folder.write("B-UP.AT2", text);
  EXPECT_TRUE(of(along, across, up).empty());
  ASSERT_EQ(of(along, other, "").size(), 1u);
  EXPECT_NE(of(along, other, "")[0].find("excitation.x and excitation.y are of two stations, A and B"),
            std::string::npos);
  ASSERT_EQ(of(along, across, other_up).size(), 2u);
  EXPECT_NE(of(along, "", other_up)[0].find("excitation.x and excitation.z are of two stations"), std::string::npos);
}

/// Plates clear one another at rest; bearings that we assumed numbers of do.
TEST(Doubts, RimsThatLieInOneAnotherAtRestAreNoticed) {
  EXPECT_TRUE(doubts_of_isolator({}, ModelKind::dcfp).empty());
  EXPECT_TRUE(doubts_of_isolator({}, ModelKind::lir_dcfp).empty());
  for (const auto &name : builtin_isolator_names())
    EXPECT_TRUE(doubts_of_isolator(builtin_isolator(name), ModelKind::tfp).empty()) << name;

  Scene s; // the thesis's chapter 4, T_b = 3 s
  s.reduced.model = ModelKind::dcfp;
  s.isolator.radius = 1.175, s.isolator.capacity = 0.41;
  ASSERT_EQ(doubts(s).size(), 1u);
  EXPECT_NE(doubts(s)[0].find("isolator.rim_height_mm = 20: at rest the rims of the two plates lie in one another by "
                              "52.9 mm, and the edges of their dishes by 12.9 mm. No bearing"),
            std::string::npos)
      << doubts(s)[0];

  auto triple = builtin_isolator("tfp-kim-2023"); // the same effective radius and travel of the pivot
  triple.inner.radius = 0.508, triple.inner.bottom_height = triple.inner.top_height = 0.1143;
  triple.inner.travel = 0.092387;
  ASSERT_EQ(doubts_of_isolator(triple, ModelKind::tfp).size(), 1u);
  EXPECT_NE(doubts_of_isolator(triple, ModelKind::tfp)[0].find("inner.rim_height_mm = 30: at rest the rims of the two "
                                                               "slide plates"),
            std::string::npos);
}

} // namespace
