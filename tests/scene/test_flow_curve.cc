// The steel's curve in files: rows and laws, tensile tests made true, what is refused and what is said.
#include "expect_error.h"
#include "scene/flow_curve.h"
#include "scene/rim_identity.h"
#include "scene/toml_writer.h"
#include "scene_text.h"
#include "temporary_folder.h"
#include <cmath>
#include <filesystem>
#include <fstream>

namespace rimpact::scene {
namespace {

const std::string curve_head = "[load]\nvertical_kN = 853\n[excitation]\nkind = \"window\"\n[bearing.material.steel]\n";
const std::string three_rows = "curve = [[0, 355], [0.02, 360], [0.1, 520]]\n";

TEST(FlowCurve, RowsAndLawsAreReadAndWrittenBack) {
  const Scene table = scene_of(curve_head + three_rows);
  EXPECT_EQ(table.bearing.steel.hardening.law, HardeningLaw::table);
  EXPECT_EQ(table.bearing.steel.yield, 355e6); // the curve's own
  const Scene swift =
      scene_of(curve_head + "hardening = \"swift\"\nhardening_K_MPa = 800\nhardening_e0 = 0.01\nhardening_n = 0.2\n");
  EXPECT_DOUBLE_EQ(*swift.bearing.steel.yield, 800e6 * std::pow(0.01, 0.2));
  const Scene voce =
      scene_of(curve_head + "hardening = \"voce\"\nyield_MPa = 350\nhardening_Q_MPa = 200\nhardening_b = 15\n");
  const Scene ludwik = scene_of(curve_head + "hardening = \"ludwik\"\nhardening_K_MPa = 700\nhardening_n = 0.6\n");
  EXPECT_EQ(ludwik.bearing.steel.yield, 360e6);
  for (const Scene &scene : {table, swift, voce, ludwik}) {
    expect_same(parse_scene(to_toml(scene), "again.toml"), scene);
    EXPECT_TRUE(scene.remarks.empty());
    EXPECT_FALSE(scene.bearing.steel.tangent_modulus.has_value());
    EXPECT_NE(rim_identity(scene.bearing), rim_identity(scene_of(curve_head).bearing));
  }
}

TEST(FlowCurve, TwoStraightLinesAreDescribedAsEver) {
  const Scene named = scene_of(curve_head + "hardening = \"bilinear\"\n"), ever = scene_of(curve_head);
  EXPECT_EQ(to_toml(named), to_toml(ever));
  EXPECT_EQ(to_toml(ever).find("hardening"), std::string::npos);
}

/// Rows of a tensile test whose true curve is sigma = 600 MPa eps^0.15: it necks where eps = 0.15.
std::string power_law_test(double furthest) {
  std::string text = "curve_kind = \"engineering\"\ncurve = [[0, 0], [0.001, 200]";
  for (int k = 1; k <= 300; ++k) {
    const double strain = furthest * k / 300, stress = 600 * std::pow(strain, 0.15);
    const double total = strain + stress / 200e3, stretch = std::exp(total);
    text += ", [" + std::to_string(stretch - 1) + ", " + std::to_string(stress / stretch) + "]";
  }
  return text + "]\n";
}

TEST(FlowCurve, ATensileTestIsMadeTrueAndCutWhereItNecks) {
  const Scene scene = scene_of(curve_head + power_law_test(0.30));
  const FlowCurve curve = flow_curve(scene.bearing.steel);
  ASSERT_TRUE(curve.necks_at.has_value());
  // Considere: d sigma / d eps = sigma, at a total strain of 0.15 (up to rows 0.001 apart).
  EXPECT_NEAR(std::log1p(*curve.necks_at), 0.15, 0.004);
  EXPECT_NEAR(curve.rows.back()[0], 0.15, 0.004);
  for (const auto &[strain, stress] : curve.rows)
    EXPECT_NEAR(stress / (600e6 * std::pow(std::max(strain, 0.002), 0.15)), 1, 3e-3) << strain; // from the proof stress
  EXPECT_EQ(scene.bearing.steel.yield, curve.rows.front()[1]);
  ASSERT_EQ(scene.remarks.size(), 1u);
  EXPECT_NE(scene.remarks[0].find("necks at a strain of"), std::string::npos);
  EXPECT_TRUE(scene_of(curve_head + power_law_test(0.10)).remarks.empty());
  expect_same(parse_scene(to_toml(scene), "again.toml"), scene);
}

TEST(FlowCurve, AFileBesideTheSceneIsRead) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string &text) { folder.write("steel.csv", text); };
  folder.write("scene.toml", curve_head + "curve = \"steel.csv\"\n");
  const auto read = [&] { return load_scene(folder / "scene.toml"); };
  write("# a mill certificate\nplastic_strain,true_stress_MPa\n0,355\n0.02,360\n0.1,520\n");
  EXPECT_EQ(read().bearing, scene_of(curve_head + three_rows).bearing);
  const auto refused = [&](const std::string &text, std::initializer_list<const char *> words) {
    write(text);
    expect_error<DataError>([&] { read(); }, words);
  };
  refused("strain,stress_MPa\n0,355\n",
          {"material.steel.curve", "steel.csv:1", "\"plastic_strain,true_stress_MPa\"", "true"});
  refused("plastic_strain,true_stress_MPa\n0,355\n0.1,5x0\n", {"steel.csv:3", "\"5x0\"", "finite number"});
  refused("plastic_strain,true_stress_MPa\n0,355,1\n", {"steel.csv:2", "3 of 2 columns"});
  refused("plastic_strain,true_stress_MPa\n-0.1,355\n", {"steel.csv:2", "-0.1", ">= 0"});
  refused("# nothing\n", {"steel.csv", "no header line"});
  std::filesystem::remove(folder / "steel.csv");
  expect_error<DataError>([&] { read(); }, {"steel.csv"});
}

TEST(FlowCurve, BadCurvesAreRefused) {
  const auto refused = [](const std::string &keys, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { scene_of(curve_head + keys).validate(); }, words);
  };
  refused("curve = [[0, 355]]\n", {"my.toml:6", "1 rows", "at least 2"});
  refused("curve = [[0.01, 355], [0.1, 400]]\n", {"row 1", "0.01", "must be 0"});
  refused("curve = [[0, 355], [0.1, 400], [0.1, 410]]\n", {"row 3", "0.1", "does not lie beyond"});
  refused("curve = [[0, 355], [1e-300, 400]]\n", {"row 2", "1e-300", "1e-06 at least"});
  refused("curve = [[0, 355], [0.1, 340]]\n", {"row 2", "falls from 355 to 340 MPa"});
  refused("curve = [[0, 0], [0.1, 340]]\n", {"row 1", "0 MPa", "> 0"});
  refused("curve = [[0, 355], [0.1, -340]]\n", {"curve", "-340", ">= 0"});
  refused("curve = [[0, 355], [0.1]]\n", {"curve", "row 2", "two numbers"});
  refused("curve = 355\n", {"curve", "rows of two numbers or a file's name", "355"});
  refused("curve = [[0, nan], [0.1, 340]]\n", {"curve", "nan"});
  refused(three_rows + "yield_MPa = 235\n", {"yield_MPa 235", "355 MPa", "leave it out"});
  refused("hardening = \"swift\"\nhardening_K_MPa = 800\n", {"my.toml:6", "swift", "hardening_e0 and hardening_n"});
  refused("hardening = \"voce\"\n", {"voce", "hardening_Q_MPa and hardening_b"});
  refused("hardening = \"ludwik\"\nhardening_K_MPa = 700\nhardening_n = 1.5\n", {"hardening_n", "1.5", "<= 1"});
  refused("hardening = \"table\"\n", {"curve has 0 rows"});
  refused("hardening = \"powerlaw\"\n", {"hardening", "powerlaw", "swift"});
  refused("curve_kind = \"engineering\"\ncurve = [[0, 0], [0.001, 200]]\n", {"no row", "200 MPa", "0.2 %"});
}

TEST(FlowCurve, KeysThatNothingReadsAreSaid) {
  const auto said = [](const std::string &keys) {
    const auto remarks = scene_of(curve_head + keys).remarks;
    return remarks.size() == 1 ? remarks[0] : std::to_string(remarks.size()) + " remarks";
  };
  EXPECT_NE(said("hardening_b = 15\n").find("hardening_b is not read by this scene"), std::string::npos);
  EXPECT_NE(said(three_rows + "tangent_modulus_MPa = 2000\n").find("tangent_modulus_MPa is not read"),
            std::string::npos);
  EXPECT_NE(said(three_rows + "hardening = \"bilinear\"\n").find("curve is not read by this scene"), std::string::npos);
}

} // namespace
} // namespace rimpact::scene
