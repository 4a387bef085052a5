// Steels by name: what a grade gives, what a file puts in its place, and the curve through yield and necking.
#include "expect_error.h"
#include "scene/steel_doubts.h"
#include "scene/steel_grades.h"
#include "scene/toml_writer.h"
#include "scene_text.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

const std::string grade_head = "[load]\nvertical_kN = 853\n[excitation]\nkind = \"window\"\n[bearing.material.steel]\n";

TEST(SteelGrades, EveryNumberHasASourceAndAPlace) {
  ASSERT_EQ(steel_grades().size(), 7u);
  for (const SteelGrade &grade : steel_grades()) {
    for (const char *key : {"E_MPa", "nu", "density_kg_per_m3", "yield_MPa", "ultimate_MPa", "uniform_strain"})
      EXPECT_TRUE(grade.find(key)) << grade.name << ' ' << key;
    for (const auto &[key, number] : grade.numbers) {
      EXPECT_GT(number.source.size(), 5u) << grade.name << ' ' << key;
      EXPECT_FALSE(number.scatter.empty()) << grade.name << ' ' << key;
    }
    for (const double thickness : {0.005, 0.04, 0.1, 1.0}) {
      Scene scene = scene_of(grade_head + "grade = \"" + grade.name + "\"\n[bearing.rim]\nthickness_mm = 40\n");
      scene.bearing.steel = steel_of(grade, thickness);
      EXPECT_NO_THROW(scene.validate()) << grade.name << ' ' << thickness;
    }
  }
}

/// Yield of the part's thickness, a curve that is the grade's, and numbers of the file that win.
TEST(SteelGrades, AGradeGivesWhatTheFileDoesNot) {
  const auto with = [](const std::string &keys) {
    return scene_of(grade_head + "grade = \"S355\"\n" + keys + "[bearing.rim]\nthickness_mm = 40\n").bearing;
  };
  const Bearing s355 = with("");
  EXPECT_EQ(s355.steel.E, 210e9);
  EXPECT_EQ(s355.steel.yield, 345e6);
  EXPECT_EQ(s355.steel.hardening.law, HardeningLaw::voce);
  EXPECT_EQ(steel_of(steel_grade("S355"), 0.016).yield, 355e6);
  EXPECT_EQ(steel_of(steel_grade("S355"), 0.0161).yield, 345e6);
  EXPECT_EQ(steel_of(steel_grade("S355"), 0.9).yield, 275e6);
  const Bearing measured = with("yield_MPa = 410\nE_MPa = 205000\n");
  EXPECT_EQ(measured.steel.yield, 410e6);
  EXPECT_EQ(measured.steel.E, 205e9);
  EXPECT_EQ(measured.steel.hardening, voce_through(410e6, 470e6, 0.15));
  const Bearing straight = with("hardening = \"bilinear\"\ntangent_modulus_MPa = 2000\n");
  EXPECT_EQ(straight.steel.hardening.law, HardeningLaw::bilinear);
  EXPECT_EQ(straight.steel.tangent_modulus, 2000e6);
}

TEST(SteelGrades, AResolvedSceneReadsBackTheSame) {
  for (const SteelGrade &grade : steel_grades())
    for (const char *keys : {"", "hardening = \"bilinear\"\n", "yield_MPa = 340\n", "rate = \"cowper-symonds\"\n"}) {
      if (grade.name == "1.4301" && std::string(keys).starts_with("yield")) continue;
      const Scene scene = scene_of(grade_head + "grade = \"" + grade.name + "\"\n" + keys);
      EXPECT_TRUE(scene.remarks.empty()) << scene.remarks.front();
      expect_same(parse_scene(to_toml(scene), "again.toml"), scene);
    }
}

TEST(SteelGrades, WhatIsNotCheckedIsAnAssumption) {
  const auto assumed = scene_of(grade_head + "grade = \"S355\"\nrate = \"cowper-symonds\"\n").bearing.assumed.keys;
  EXPECT_EQ(assumed.count("material.steel.E_MPa"), 0u);
  EXPECT_EQ(assumed.count("material.steel.yield_MPa"), 0u);
  EXPECT_EQ(assumed.count("material.steel.rate_D_per_s"), 1u);
  EXPECT_EQ(assumed.count("material.steel.hardening_Q_MPa"), 1u);
}

/// The engineering stress of the curve is largest where, and as large as, the grade says.
TEST(SteelGrades, TheCurveNecksWhereItIsSaidTo) {
  for (const SteelGrade &grade : steel_grades()) {
    const Material m = steel_of(grade, 0.04);
    const double ultimate = 1e6 * grade.find("ultimate_MPa")->at(0.04), uniform = grade.find("uniform_strain")->value;
    double largest = 0, at = 0;
    for (int k = 0; k <= 20000; ++k) {
      const double p = 0.5 * k / 20000,
                   engineering = (*m.yield + m.hardening.Q * -std::expm1(-m.hardening.b * p)) * std::exp(-p);
      if (engineering > largest) largest = engineering, at = std::expm1(p);
    }
    EXPECT_NEAR(largest / ultimate, 1, 1e-6) << grade.name;
    EXPECT_NEAR(at, uniform, 1e-3) << grade.name;
  }
  expect_error<InputError>([] { voce_through(500e6, 480e6, 0.01); }, {"500", "480", "0.01"});
}

TEST(SteelGrades, AHardnessEstimatesTheYieldStress) {
  const Bearing b = scene_of(grade_head + "hardness_HB = 150\n").bearing;
  EXPECT_NEAR(*b.steel.yield, (2.876 * 150 / 0.95 - 90.7) * 1e6, 1);
  EXPECT_EQ(b.assumed.keys.count("material.steel.yield_MPa"), 1u);
  const Scene scene = scene_of(grade_head + "hardness_HB = 150\n");
  expect_same(parse_scene(to_toml(scene), "again.toml"), scene);
}

TEST(SteelGrades, AHardnessBesideAGradeIsAnAssumption) {
  const Bearing b = scene_of(grade_head + "grade = \"S355\"\nhardness_HB = 150\n").bearing;
  EXPECT_NEAR(*b.steel.yield / yield_of_hardness(150), 1, 1e-12);
  EXPECT_EQ(b.assumed.keys.count("material.steel.yield_MPa"), 1u);
}

TEST(SteelGrades, WhatStandsInAGradesPlaceIsDoubted) {
  const auto found = [](const std::string &keys, double thickness) {
    return doubts_of_grade(
        scene_of(grade_head + keys + fmt::format("[bearing.rim]\nthickness_mm = {}\n", thickness)).bearing);
  };
  EXPECT_TRUE(found("grade = \"S355\"\n", 40).empty());
  EXPECT_TRUE(found("grade = \"S355\"\nhardness_HB = 150\n", 40).empty());
  EXPECT_TRUE(found("yield_MPa = 360\n", 40).empty());
  const auto own = found("grade = \"S355\"\nE_MPa = 200000\nyield_MPa = 360\ntangent_modulus_MPa = 1450\n", 40);
  ASSERT_EQ(own.size(), 1u);
  for (const char *words :
       {"E_MPa 2e+05 (the grade's: 2.1e+05)", "yield_MPa 360 (the grade's: 345)", "two straight lines"})
    EXPECT_NE(own[0].find(words), std::string::npos) << own[0];
  const auto of_part = found("yield_MPa = 360\n[bearing.material.slider]\ngrade = \"S355\"\nE_MPa = 200000\n", 40);
  ASSERT_EQ(of_part.size(), 1u);
  EXPECT_NE(of_part[0].find("bearing.material.slider of grade S355"), std::string::npos) << of_part[0];
  const auto thick = found("grade = \"S460\"\n", 151);
  ASSERT_EQ(thick.size(), 1u);
  EXPECT_NE(thick[0].find("the rim is 151 mm thick, beyond the 150 mm"), std::string::npos) << thick[0];
}

TEST(SteelGrades, BadKeysAreRefused) {
  const auto refused = [](const std::string &keys, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { scene_of(grade_head + keys).validate(); }, words);
  };
  refused("grade = \"S356\"\n", {"my.toml:6", "grade", "S356", "did you mean \"S355\""});
  refused("grade = 355\n", {"grade", "must be a string"});
  refused("grade = \"S355\"\nyield_MPa = 700\n", {"my.toml:6", "S355", "700", "necks"});
  refused("hardness_HB = 20\n", {"hardness_HB", "20", "80"});
  refused("hardness_HB = 150\nyield_MPa = 500\n", {"hardness_HB 150", "yield_MPa", "363", "give one"});
  refused("hardness_HB = 150\ncurve = [[0, 355], [0.1, 500]]\n", {"my.toml:6", "hardness_HB", "355 MPa", "give one"});
  refused("hardness_HB = 150\nhardening = \"swift\"\nhardening_K_MPa = 800\nhardening_e0 = 0.002\nhardening_n = 0.2\n",
          {"hardness_HB", "a curve", "give one"});
  refused("grade = \"S355\"\nfracture_D1 = 0\n", {"fracture_D1", "0", "> 0"});
}

} // namespace
} // namespace rimpact::scene
