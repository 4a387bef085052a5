#include "answer_fixture.h"
#include "calibration/export/csi.h"
#include "calibration/export/gap_springs.h"
#include "calibration/export/law_csv.h"
#include "io/files/error.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace rimpact::calibration {
namespace {
using testing::answer_fixture, testing::stored;

std::vector<std::string> lines_with(const std::string &text, const std::string &needle) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.find(needle) != std::string::npos) found.push_back(line);
  return found;
}
double field(const std::string &line, const std::string &name) {
  return std::stod(line.substr(line.find(name) + name.size()));
}

TEST(SelfCheck, IntegratorMeetsClosedForms) {
  // spring and dashpot: e from xi, whatever the speed; half a period of the damped oscillator
  const double k = 3e8, m = 86952, e = 0.4, c = laws::damping_coefficient(k, e, m), xi = laws::damping_ratio(e);
  DashpotContact pulls(k, c, true);
  const auto impact = fly(pulls, m, 0.3, k);
  EXPECT_NEAR(impact.rebound, e, 2e-4);
  EXPECT_NEAR(impact.duration, M_PI / std::sqrt(k / m * (1 - xi * xi)), 2e-5);
  // plastic: energy in is work done; F^2 / (2 E) comes back
  const GapSpring spring{1e9, 4e5, 0.05};
  GapSpringsContact gap({spring});
  const auto dent = fly(gap, m, 0.5, spring.stiffness);
  EXPECT_NEAR(spring.work(dent.penetration) / (m * 0.125), 1, 1e-3);
  EXPECT_NEAR(m * std::pow(0.5 * dent.rebound, 2) / 2 / spring.returned(dent.penetration), 1, 1e-3);
}

TEST(ExportedRim, TakesARankedLawInItsUnitsOnly) {
  auto calibration = answer_fixture();
  EXPECT_DOUBLE_EQ(exported_rim(stored(calibration), {.law = "no-tension", .mass = {}}).settings.k_i, 4.5e8);
  calibration["laws"]["rows"][0]["parameters"]["k_i"]["unit"] = "N/m";
  try {
    exported_rim(stored(calibration), {.law = "no-tension", .mass = {}});
    FAIL() << "nothing was thrown";
  } catch (const DataError &error) {
    EXPECT_NE(std::string(error.what()).find("laws.rows, no-tension: parameters.k_i.unit is \"N/m\", not \"kN/m\""),
              std::string::npos)
        << error.what();
  }
}

/// An exported law ends at the fastest run whose foot bears it; where none does there is none.
TEST(ExportedRim, EndsWhereTheRimsFootGoes) {
  auto calibration = answer_fixture();
  auto &foot = calibration["answer"]["rim_foot"];
  foot = {{"in_words", "two fillet welds"}, {"goes_at_force_kN", 812.5}, {"goes_at_m_s", 0.5}, {"borne_to_m_s", 0.4}};
  const auto rim = exported_rim(stored(calibration), {});
  EXPECT_NEAR(rim.to, 0.4, 1e-12);
  EXPECT_NEAR(rim.from, 0.1, 1e-12);
  EXPECT_NE(
      std::find_if(rim.statement.begin(), rim.statement.end(),
                   [](const std::string &line) { return line.starts_with("ENDS at 812.5 kN of the rim's force"); }),
      rim.statement.end());
  foot["borne_to_m_s"] = nullptr, foot["goes_at_m_s"] = 0.1;
  try {
    exported_rim(stored(calibration), {});
    FAIL() << "nothing was thrown";
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("two fillet welds, goes at 0.1 m/s or below"), std::string::npos);
  }
  foot = {{"in_words", "one piece with the plate"},
          {"goes_at_force_kN", nullptr},
          {"goes_at_m_s", nullptr},
          {"borne_to_m_s", nullptr}};
  EXPECT_NEAR(exported_rim(stored(calibration), {}).to, 0.7, 1e-12);
}

TEST(PlasticLink, SeriesOfGapAndLinkIsTheLaw) {
  const auto rim = exported_rim(stored(answer_fixture()), {});
  const auto links = csi_rim(rim);
  EXPECT_LT(links.check.peak_force, 0.01); // the load path is the law's
  EXPECT_LT(links.check.penetration, 0.01);
  EXPECT_LT(links.check.rebound, 0.12);
  EXPECT_TRUE(links.check.serves());
  const auto &link = *links.plastic;
  for (std::size_t i = 1; i < link.force.size(); ++i) {
    EXPECT_GT(link.displacement[i], link.displacement[i - 1]);
    EXPECT_GT(link.force[i], link.force[i - 1]);
  }
  EXPECT_NEAR(link.force[1] / link.displacement[1] / link.unloading, 1, 1e-9); // unloading is the first segment's
}

TEST(Csi, TablesHoldTheLink) {
  const auto rim = exported_rim(stored(answer_fixture()), {});
  const auto links = csi_rim(rim);
  const auto dish = dish_of(scene::Scene{}, rim.lateral_capacity);
  const auto text = sap2000(rim, links, dish, {"command"});
  for (const char *table :
       {"01 - GENERAL", "03 - MULTILINEAR", "05 - GAP", "08 - SLIDING ISOLATOR", "11 - MULTILINEAR PLASTIC"})
    EXPECT_EQ(lines_with(text, std::string("TABLE:  \"LINK PROPERTY DEFINITIONS ") + table + "\"").size(), 1u) << table;
  const auto rows = lines_with(text, "Link=RIM   DOF=U1");
  ASSERT_EQ(rows.size(), links.plastic->force.size() + 2);
  EXPECT_NE(rows[0].find("HysType=Kinematic"), std::string::npos);
  for (std::size_t i = 1; i < rows.size(); ++i) { // both columns grow through zero
    EXPECT_GT(field(rows[i], "Displ="), field(rows[i - 1], "Displ="));
    EXPECT_GT(field(rows[i], "Force="), field(rows[i - 1], "Force="));
  }
  EXPECT_NEAR(field(rows[0], "Force="), -links.plastic->force.back() / 1e3, 1e-3);
  EXPECT_NEAR(field(lines_with(text, "TransOpen=")[0], "TransOpen="), 0.4, 1e-9);
  EXPECT_NEAR(field(lines_with(text, "Link=DISH   DOF=U2")[0], "Radius="), 0,
              1e-12); // no sphere: flat, with DISH_SPRING beside it
  scene::Scene sphere;
  sphere.bearing.surface.kind = scene::SurfaceKind::sphere, sphere.bearing.surface.R0 = 3;
  const auto other = sap2000(rim, links, dish_of(sphere, rim.lateral_capacity), {"command"});
  EXPECT_NEAR(field(lines_with(other, "Link=DISH   DOF=U2")[0], "Radius="), 3, 1e-9);
  EXPECT_TRUE(lines_with(other, "DISH_SPRING").empty());
  const auto e2k = etabs(rim, links, dish, {"command"});
  EXPECT_EQ(lines_with(e2k, "LINKPROPFORCEDISPL  \"RIM\"").size(), rows.size());
  EXPECT_NE(text.find("was not tried"), std::string::npos);
  const auto csv = link_csv(rim, links, dish, {"command"});
  auto cells = lines_with(csv, "RIM,");
  std::erase_if(cells, [](const auto &line) { return line.rfind("RIM,", 0) != 0; }); // comments may end in it
  EXPECT_EQ(cells.size(), rows.size());
  for (const auto &each : {text, e2k, csv}) EXPECT_FALSE(lines_with(each, "DOUBT: Run w-0.70").empty());
}

TEST(Csi, APairIsGapAndDashpot) {
  auto calibration = answer_fixture();
  calibration["answer"]["pair"] = {{"law", "no-tension"},
                                   {"k_i_kN_per_m", 450000.0},
                                   {"e", 0.5},
                                   {"mass_kg", 86952.0},
                                   {"from_m_s", 0.2},
                                   {"to_m_s", 0.4},
                                   {"tolerance", 0.1},
                                   {"worst_peak_force_error", 0.08},
                                   {"worst_rebound_error", 0.05},
                                   {"sentence", "A pair."}};
  const auto rim = exported_rim(stored(calibration), {.law = "pair", .mass = {}});
  EXPECT_DOUBLE_EQ(rim.from, 0.2);
  EXPECT_DOUBLE_EQ(rim.settings.restitution, 0.5);
  const auto links = csi_rim(rim);
  EXPECT_LT(links.check.peak_force, 0.01);
  EXPECT_LT(links.check.rebound, 0.01);
  const auto text = sap2000(rim, links, std::nullopt, {"command"});
  EXPECT_NEAR(field(lines_with(text, "Link=RIM   DOF=U1")[0], "TransKE="), 450000, 1e-3);
  EXPECT_NEAR(field(lines_with(text, "Link=RIM   DOF=U1")[0], "TransCE="),
              laws::damping_coefficient(4.5e8, 0.5, 86952) / 1e3, 1e-2);
  EXPECT_THROW(exported_rim(stored(calibration), {.law = "pair", .mass = 100000}), InputError);
}

TEST(LawCsv, LoadsAndUnloadsFromFiveDepths) {
  const auto rim = exported_rim(stored(answer_fixture()), {});
  const auto text = law_csv(rim, {"command"});
  const auto element = rim.element();
  std::istringstream lines(text);
  std::set<std::string> speeds;
  int n = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#' || line.rfind("branch", 0) == 0) continue;
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 4u) << line;
    if (cells[0] == "loading") {
      const double d = std::stod(cells[2]) / 1e3;
      EXPECT_NEAR(std::stod(cells[3]), laws::elastoplastic_backbone(element, d).force / 1e3, 1e-2);
    } else {
      EXPECT_EQ(cells[0], "unloading");
      speeds.insert(cells[1]);
    }
    ++n;
  }
  EXPECT_EQ(speeds.size(), 5u);
  EXPECT_GT(n, 200);
}

} // namespace
} // namespace rimpact::calibration
