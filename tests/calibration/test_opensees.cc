#include "answer_fixture.h"
#include "calibration/export/comment.h"
#include "calibration/export/opensees.h"
#include "io/files/error.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using testing::answer_fixture, testing::stored;

/// Comments as they were before lines were broken.
std::string unbroken(std::string text) {
  for (std::size_t at; (at = text.find("\n# ")) != std::string::npos;) text.erase(at, 2);
  return text;
}
ExportedRim rim_of(const nlohmann::json &calibration, const ExportChoice &choice = {}) {
  return exported_rim(stored(calibration), choice);
}

TEST(OpenSees, FourSpringsStopTheMassAsTheLawDoes) {
  const auto rim = opensees_rim(rim_of(answer_fixture()));
  ASSERT_EQ(rim.springs.size(), 4u);
  EXPECT_LT(rim.check.peak_force, 0.04);
  EXPECT_LT(rim.check.rebound, 0.04);
  EXPECT_LT(rim.check.penetration, 0.04);
  ASSERT_EQ(rim.check.rows.size(), 5u);
  EXPECT_NEAR(rim.check.rows.front().speed, 0.1, 1e-12);
  EXPECT_NEAR(rim.check.rows.back().speed, 0.7, 1e-12);
  for (const auto &spring : rim.springs) {
    EXPECT_GT(spring.stiffness, 0);
    EXPECT_GT(spring.yield_force, 0);
    EXPECT_GE(spring.hardening, 0);
    EXPECT_LT(spring.hardening, 1); // OpenSees sets others to zero
  }
  // over less than a factor of two in speed they follow closer
  auto narrow = answer_fixture();
  narrow["answer"]["law"]["valid_from_m_s"] = 0.3, narrow["answer"]["law"]["valid_to_m_s"] = 0.5;
  const auto near = opensees_rim(rim_of(narrow));
  EXPECT_LT(near.check.peak_force, 0.04); // 3.0 %, where the wide range has up to 8
  EXPECT_LT(near.check.peak_force, rim.check.peak_force);
  EXPECT_LT(near.check.rebound, 0.05);
}

TEST(OpenSees, FourSpringsMeetTheLawOnItsDentAndBelowTheSlowestSpeed) {
  const auto rim = rim_of(answer_fixture());
  const auto springs = opensees_rim(rim);
  EXPECT_LT(springs.check.again(), SelfCheck::tolerance);
  LawContact law(rim.element());
  GapSpringsContact contact(springs.springs);
  const double slow = 0.6 * rim.from; // what weight and friction leave of the slowest
  const auto a = fly(law, rim.mass, slow, rim.settings.k_i), b = fly(contact, rim.mass, slow, springs.stiffness);
  EXPECT_NEAR(b.peak_force / a.peak_force, 1, 0.05);
  EXPECT_NEAR(b.rebound, a.rebound, 0.05);
}

TEST(OpenSees, TheWorkOfGapSpringsIsThatOfTheirForce) {
  GapSpringsContact contact({{1e9, 1e6, 0.1}, {4e8, 2e5, 0.3, 1e-3}});
  for (const double dent : {0.0, 3e-3, 6e-3}) {
    contact.accept(dent);
    double work = 0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) work += contact.force(8e-3 * (i + 0.5) / n, 0) * 8e-3 / n;
    EXPECT_NEAR(contact.work(8e-3) / work, 1, 1e-6) << dent;
  }
}

TEST(OpenSees, OneGapSpringFollowsTheRulesOfItsSource) {
  // E 1e9 N/m, yields at 1e6 N (1 mm), slope 1e8 beyond
  GapSpringsContact contact({{1e9, 1e6, 0.1}});
  EXPECT_DOUBLE_EQ(contact.force(0.5e-3, 0), 0.5e6);
  EXPECT_NEAR(contact.force(3e-3, 0), 1.2e6, 1e-3);
  contact.accept(3e-3);
  EXPECT_NEAR(contact.force(2.4e-3, 0), 0.6e6, 1e-3); // back along E
  EXPECT_NEAR(contact.force(1.8e-3, 0), 0, 1e-3);     // open at D - F / E
  EXPECT_EQ(contact.force(1.0e-3, 0), 0);             // the dent
  contact.accept(0);
  EXPECT_EQ(contact.force(1.7e-3, 0), 0); // stays
  EXPECT_NEAR(contact.force(5e-3, 0), 1.4e6, 1e-3);
}

TEST(OpenSees, AGapSpringMayBeginLater) {
  const GapSpring spring{1e9, 1e6, 0.1, 2e-3};
  GapSpringsContact contact({spring});
  EXPECT_EQ(contact.force(1.5e-3, 0), 0);
  EXPECT_NEAR(contact.force(2.5e-3, 0), 0.5e6, 1e-3);
  EXPECT_NEAR(contact.force(5e-3, 0), 1.2e6, 1e-3);
  EXPECT_EQ(spring.work(2e-3), 0);
  EXPECT_NEAR(spring.work(5e-3), 0.5e3 + 2e-3 * 1.1e6, 1e-6);
  contact.accept(5e-3);
  EXPECT_NEAR(contact.force(3.8e-3, 0), 0, 1e-3);
  EXPECT_NEAR(contact.force(4.4e-3, 0), 0.6e6, 1e-3);
}

TEST(OpenSees, PerfectlyPlasticSpringsAtTheVerticesReturnTooMuch) {
  // why the four springs harden: exact on the load path, an elastic-perfectly-plastic parallel gives back F D - W
  const auto rim = rim_of(answer_fixture());
  const auto element = rim.element();
  std::vector<GapSpring> springs;
  const auto slope = [&](double d) { return laws::elastoplastic_backbone(element, d).d_penetration; };
  const int n = 400;
  for (int i = 1; i <= n; ++i) {
    const double step = 20e-3 / n, d = step * (i - 0.5), E = slope(d) - slope(d + step);
    springs.push_back({E, E * (d + step / 2), 0});
  }
  springs.push_back({slope(20e-3), 1e12, 0});
  const auto check = self_check(
      rim, "parallel", [&](double) { return std::make_unique<GapSpringsContact>(springs); }, 1.1e9);
  EXPECT_LT(check.peak_force, 0.03);
  EXPECT_GT(check.rows.back().spring.rebound / check.rows.back().law.rebound, 3);
}

TEST(OpenSees, DashpotsHoldForTheirMassOnly) {
  const auto calibration = answer_fixture();
  const auto rim = rim_of(calibration, {.law = "no-tension", .mass = {}});
  EXPECT_TRUE(rim.of_mass);
  EXPECT_EQ(rim.law().name, "no-tension");
  const auto springs = opensees_rim(rim);
  EXPECT_TRUE(springs.in_series); // ViscoelasticGap would pull, and return e = 0.35 exactly
  EXPECT_LT(springs.check.peak_force, 1e-3);
  EXPECT_LT(springs.check.rebound, 1e-3);
  EXPECT_GT(springs.check.rows[0].spring.rebound, 0.36);
  EXPECT_THROW(rim_of(calibration, {.law = "no-tension", .mass = 203900}), InputError);
  EXPECT_NO_THROW(rim_of(calibration, {.law = "", .mass = 203900})); // the law belongs to the rim
  EXPECT_THROW(rim_of(calibration, {.law = "pair", .mass = {}}), InputError);
  EXPECT_THROW(rim_of(calibration, {.law = "signed", .mass = {}}), InputError); // not ranked
}

TEST(OpenSees, ALawOfTheRimMovesWithTheMass) {
  const auto rim = rim_of(answer_fixture(), {.law = "", .mass = 4 * 86952.0});
  EXPECT_NEAR(rim.from, 0.05, 1e-12); // the same penetrations at half the speed
  EXPECT_NEAR(rim.to, 0.35, 1e-12);
  EXPECT_TRUE(std::any_of(rim.statement.begin(), rim.statement.end(), [](const std::string &line) {
    return line.starts_with(
        "Steel: the speeds of this sentence are of 86952 kg, for 347808 kg they are 0.5 times as high. The steel");
  }));
}

TEST(OpenSees, ARangeOfOneSpeedIsNotWhatSpringsAreTunedTo) {
  auto calibration = answer_fixture(); // met exactly at one speed, four springs would be off elsewhere unsaid
  calibration["answer"]["law"]["valid_to_m_s"] = 0.1;
  const auto rim = rim_of(calibration);
  EXPECT_DOUBLE_EQ(rim.from, 0.1);
  EXPECT_DOUBLE_EQ(rim.to, 0.7);
  EXPECT_EQ(opensees_rim(rim).check.rows.size(), 5u);
  EXPECT_EQ(std::count(rim.statement.begin(), rim.statement.end(),
                       "DOUBT: that range is narrow, springs and self-check are made for the speeds fitted instead."),
            1);
}

TEST(OpenSees, TextHoldsStatementAndNumbersOnly) {
  const auto rim = rim_of(answer_fixture());
  const auto springs = opensees_rim(rim);
  scene::Scene scene;
  const auto dish = dish_of(scene, rim.lateral_capacity);
  EXPECT_FALSE(dish.sphere);
  EXPECT_NEAR(dish.error_full, std::sqrt(1 - std::pow(0.4 / 0.5625, 2)) - 1,
              1e-9); // ellipse: h' = r / R0 / sqrt(1 - (r / a)^2)
  for (const auto &text :
       {opensees_tcl(rim, springs, dish, {"command"}), opensees_python(rim, springs, dish, {"command"})})
    for (const char *needle :
         {"shfps-225", "86952 kg", "853 kN", "elastoplastic", "0.1 to 0.7 m/s", "peak force 2.1 %", "DOUBT: Run w-0.70",
          "95 % interval", "Assumed, not given (1)", "Validity: Holds for this rim",
          "Self-check of the four ElasticPPGap", "0.475", "rim_yield_force",
          "rides on an ellipsoid of half-widths 0.5625 and 0.140625 m", "Time step"})
      EXPECT_NE(unbroken(text).find(needle), std::string::npos) << needle << "\n" << text.substr(0, 6000);
}

TEST(OpenSees, NumbersMustBeNumbers) {
  for (const char *key : {"k_i", "yield_force", "hardening", "lateral_capacity_m"}) {
    for (const nlohmann::json &bad : {nlohmann::json("1; exec rm"), nlohmann::json(nullptr), nlohmann::json(-1.0)}) {
      auto calibration = answer_fixture();
      calibration["answer"]["law"]["element"][key] = bad;
      EXPECT_THROW(rim_of(calibration), DataError) << key << " " << bad;
    }
  }
  for (const char *key : {"mass_kg", "vertical_kN", "gravity_m_per_s2"}) {
    auto calibration = answer_fixture();
    calibration["answer"][key] = "853]";
    EXPECT_THROW(rim_of(calibration), DataError) << key;
  }
  EXPECT_THROW(rim_of(nlohmann::json::object()), DataError);
  for (const char *key :
       {"law", "laws", "element", "parameters"}) { // other kinds than calibrations write: a sentence, no crash
    auto calibration = answer_fixture();
    (std::string(key) == "laws"  ? calibration[key]
     : std::string(key) == "law" ? calibration["answer"][key]
                                 : calibration["answer"]["law"][key]) = {1, 2};
    try {
      rim_of(calibration, {.law = std::string(key) == "laws" ? "signed" : "", .mass = {}});
    } catch (const Error &) {
    }
  }
}

TEST(Comment, WhateverItHoldsItStaysAComment) {
  const std::string hostile = "a\nimport os; os.system('x')\r\n]; exec rm -rf / \\\n${x} [exit] \"\"\" ''' \x1b[2J "
                              "`id` {} b\xc3\xbc\xff\t\v\f\xe2\x80\xa8z";
  const std::string line = comment_line("#", hostile);
  for (const char c : {'\\', '$', '[', ']', '{', '}', '"', ';', '`', '\r', '\t', '\x1b', '\v', '\f'})
    EXPECT_EQ(line.find(c), std::string::npos) << int(c);
  EXPECT_EQ(line.find("'''"), std::string::npos);
  for (const unsigned char c : line) EXPECT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7f));
  std::istringstream lines(line);
  for (std::string one; std::getline(lines, one);) EXPECT_EQ(one.rfind("# ", 0), 0u) << one;
  const std::string broken = comment_line("$", std::string(1000, 'x') + " y"); // no blank to break at
  std::istringstream more(broken);
  for (std::string one; std::getline(more, one);) EXPECT_EQ(one.rfind("$ ", 0), 0u) << one;
  EXPECT_EQ(comment_line("#", ""), "# \n");
}

} // namespace
} // namespace rimpact::calibration
