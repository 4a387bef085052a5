// A steel for each part of a bearing: what its table leaves out, what is written back, what it changes.
#include "expect_error.h"
#include "scene/rim_identity.h"
#include "scene/stack_terms.h"
#include "scene/steel_grades.h"
#include "scene_text.h"
#include <algorithm>

namespace rimpact::scene {
namespace {

const std::string window = "[load]\nvertical_kN = 853\n[excitation]\nkind = \"window\"\n";

Scene with(const std::string &keys) {
  return scene_of(window + keys);
}

TEST(PartSteels, OneSteelIsThatOfAllPartsAndIsDescribedAsEver) {
  const Scene one = with("[bearing.material.steel]\nyield_MPa = 400\n");
  for (const auto part : {SteelPart::rim, SteelPart::dish, SteelPart::slider})
    EXPECT_EQ(one.bearing.steel_of(part), one.bearing.steel);
  EXPECT_EQ(to_toml(one).find("material.rim"), std::string::npos);
  EXPECT_EQ(to_toml(one).find("material.slider"), std::string::npos);
}

TEST(PartSteels, WhatATableLeavesOutIsTheBearingsSteels) {
  const Scene scene =
      with("[bearing.material.steel]\nyield_MPa = 400\nrate = \"cowper-symonds\"\nrate_D_per_s = 99\n"
           "[bearing.material.rim]\nyield_MPa = 500\n[bearing.material.slider]\ndensity_kg_per_m3 = 7000\n");
  const Bearing &b = scene.bearing;
  EXPECT_EQ(*b.steel_of(SteelPart::rim).yield, 500e6);
  EXPECT_EQ(b.steel_of(SteelPart::rim).rate.D, 99);
  EXPECT_EQ(b.steel_of(SteelPart::rim).tangent_modulus, b.steel.tangent_modulus);
  EXPECT_EQ(*b.steel_of(SteelPart::slider).yield, 400e6);
  EXPECT_EQ(b.steel_of(SteelPart::dish), b.steel);
  EXPECT_NEAR(slider_mass(b) / slider_mass(with("").bearing), 7000.0 / 7850, 1e-12);
  expect_same(parse_scene(to_toml(scene), "again.toml"), scene);
  EXPECT_TRUE(scene.remarks.empty());
}

TEST(PartSteels, AGradeOfAPartIsThatOfItsThickness) {
  const Scene scene = with("[bearing.rim]\nthickness_mm = 15\n[bearing.material.steel]\nyield_MPa = 235\n"
                           "[bearing.material.rim]\ngrade = \"S355\"\n[bearing.material.dish]\ngrade = \"S355\"\n");
  const Bearing &b = scene.bearing;
  EXPECT_EQ(*b.steel_of(SteelPart::rim).yield, 355e6);  // up to 16 mm
  EXPECT_EQ(*b.steel_of(SteelPart::dish).yield, 335e6); // of 50 mm
  EXPECT_EQ(*b.steel_of(SteelPart::slider).yield, 235e6);
  EXPECT_EQ(b.steel_of(SteelPart::rim).hardening, steel_of(steel_grade("S355"), 0.015).hardening);
  expect_same(parse_scene(to_toml(scene), "again.toml"), scene);
}

TEST(PartSteels, ACurveOfAPartThatNecksIsRemarkedUponOnce) {
  const std::string curve = "curve = [[0.0, 360.0], [0.1, 450.0], [0.2, 430.0]]\ncurve_kind = \"engineering\"\n";
  const auto of_rim = with("[bearing.material.rim]\n" + curve).remarks;
  ASSERT_EQ(of_rim.size(), 1u);
  EXPECT_NE(of_rim[0].find("bearing.material.rim.curve necks"), std::string::npos) << of_rim[0];
  EXPECT_EQ(
      with("[bearing.material.steel]\n" + curve + "[bearing.material.rim]\ndensity_kg_per_m3 = 7000\n").remarks.size(),
      1u)
      << "inherited";
}

TEST(PartSteels, ASliderBetweenTwoDishesStandsOnItsOwnSteel) {
  const std::string two = "[bearing]\nname = \"dcfp-155\"\n";
  const double one = pad_stiffness(with(two).bearing);
  EXPECT_NEAR(pad_stiffness(with(two + "[bearing.material.slider]\nE_MPa = 100000\n").bearing) / one, 0.5, 1e-12);
  EXPECT_NEAR(pad_stiffness(with(two + "[bearing.material.rim]\nE_MPa = 100000\n").bearing) / one, 1, 1e-12);
}

TEST(PartSteels, TheLowerLimitOfTheRimsSideIsJudged) {
  EXPECT_EQ(*strain_limit(with("").bearing), 0.20);
  EXPECT_EQ(*strain_limit(with("[bearing.material.rim]\nstrain_limit = 0.05\n").bearing), 0.05);
  EXPECT_EQ(*strain_limit(with("[bearing.material.dish]\nstrain_limit = 0.30\n").bearing), 0.20);
  EXPECT_EQ(*strain_limit(with("[bearing.material.slider]\nstrain_limit = 0.05\n").bearing), 0.20);
  EXPECT_EQ(*strain_limit(with("[bearing.material.dish]\nstrain_limit = inf\n").bearing), 0.20);
}

TEST(PartSteels, ALawOfARimIsNotThatOfAnotherPartsSteel) {
  const auto identity = [](const std::string &keys) { return rim_identity(with(keys).bearing); };
  EXPECT_NE(identity("[bearing.material.slider]\nyield_MPa = 700\n"), identity(""));
  EXPECT_NE(identity("[bearing.material.slider]\nyield_MPa = 700\n"),
            identity("[bearing.material.rim]\nyield_MPa = 700\n"));
  EXPECT_EQ(identity("[bearing.material.rim]\nyield_MPa = 700\n"),
            identity("[bearing.material.rim]\nyield_MPa = 700\nstrain_limit = 0.1\nfracture_C1 = 0.5\n"));
}

TEST(PartSteels, WhatIsAssumedOfTheBearingsSteelIsAssumedOfThePart) {
  const auto assumed = [](const std::string &keys) {
    std::vector<std::string> list;
    for (const auto &[key, value] : assumptions(with(keys).bearing))
      if (key.starts_with("material.rim.")) list.push_back(key.substr(13));
    return list;
  };
  using Keys = std::vector<std::string>;
  EXPECT_EQ(assumed(""), Keys{});
  const Keys found = assumed("[bearing.material.rim]\nyield_MPa = 500\n");
  EXPECT_EQ(std::count(found.begin(), found.end(), "yield_MPa"), 0);
  EXPECT_EQ(std::count(found.begin(), found.end(), "density_kg_per_m3"), 1);
  const Keys given = assumed("[bearing.material.rim]\nyield_MPa = 500\ndensity_kg_per_m3 = 7800\n");
  EXPECT_EQ(std::count(given.begin(), given.end(), "density_kg_per_m3"), 0);
}

TEST(PartSteels, BadKeysAreRefusedByTheirPart) {
  const auto refused = [](const std::string &keys, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { with(keys).validate(); }, words);
  };
  refused("[bearing.material.rim]\nyield = 500\n", {"unknown key", "yield", "bearing.material.rim"});
  refused("[bearing.material.rim]\ngrade = \"S356\"\n", {"grade", "S356"});
  refused("[bearing.material.rim]\nyield_MPa = -1\n", {"bearing.material.rim.yield_MPa", "-1", "> 0"});
  refused("[bearing.material.dish]\ntangent_modulus_MPa = 300000\n", {"material.dish.tangent_modulus_MPa", "300000"});
  refused("[bearing.material.slider]\nhardening = \"voce\"\n", {"material.slider.hardening", "hardening_Q_MPa"});
  refused("[bearing.material.rim]\nchaboche = [[1000, 1], [1000, 1], [1000, 1]]\n",
          {"material.rim.chaboche", "3", "2"});
  refused("[bearing.material.steel]\nchaboche = \"steel.csv\"\n", {"material.steel.chaboche", "steel.csv"});
}

TEST(PartSteels, KeysThatNothingReadsAreSaid) {
  const auto remarks = with("[bearing.material.rim]\nrate_D_per_s = 100\n").remarks;
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].find("bearing.material.rim.rate_D_per_s is not read by this scene"), 0u) << remarks[0];
  // By the rim's own choice, not by the base steel's.
  const auto own = with("[bearing.material.steel]\nrate = \"cowper-symonds\"\n[bearing.material.rim]\nrate = \"none\"\n"
                        "rate_D_per_s = 100\n")
                       .remarks;
  ASSERT_EQ(own.size(), 1u);
  EXPECT_NE(own[0].find("bearing.material.rim.rate \"none\""), std::string::npos) << own[0];
  EXPECT_EQ(own[0].find("cowper-symonds"), std::string::npos) << own[0];
}

TEST(PartSteels, BackstressAndSofteningAreReadAndWrittenBack) {
  const Scene scene = with("[bearing.material.steel]\nchaboche = [[40000, 400], [3000, 0]]\nsoftening = \"adiabatic\"\n"
                           "melting_K = 1480\nfracture_C1 = 0.27\nfracture_C2 = 0.47\n");
  const Material &steel = scene.bearing.steel;
  EXPECT_EQ(steel.hardening.chaboche.values, (std::vector<std::array<double, 2>>{{40e9, 400}, {3e9, 0}}));
  EXPECT_EQ(steel.heat, (PlasticHeat{.model = Softening::adiabatic, .melting = 1480}));
  EXPECT_EQ(fracture_locus(steel.fracture).shear, 0.27);
  expect_same(parse_scene(to_toml(scene), "again.toml"), scene);
  EXPECT_NE(rim_identity(scene.bearing), rim_identity(with("").bearing));
  for (const char *key : {"chaboche", "softening", "fracture_C1"})
    EXPECT_EQ(to_toml(with("")).find(key), std::string::npos) << key;
}

} // namespace
} // namespace rimpact::scene
