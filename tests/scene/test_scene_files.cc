// Files beside a scene: its bearing, its records, the table of its surface.
#include "expect_error.h"
#include "scene/toml_writer.h"
#include "scene_text.h"
#include "temporary_folder.h"
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

TEST(SceneFiles, BearingFilesAndOverridesGoTogether) {
  const TemporaryFolder folder;
  Bearing own;
  own.name = "own-one", own.rim.height = 0.070, own.steel.yield.reset(), own.steel.tangent_modulus.reset();
  folder.write("own.toml", to_toml(own));
  const std::string path =
      folder.write("case.toml", "[bearing]\nfile = 'own.toml'\n[bearing.rim]\nthickness_mm = 30\n");
  const Scene scene = load_scene(path);
  own.rim.thickness = 0.030;
  EXPECT_EQ(scene.bearing, own);
  EXPECT_EQ(scene.name, "case");
  expect_same(scene, parse_scene(to_toml(scene), "scene.toml")); // no file any more: written out
  folder.write("own.toml", "[rim]\nheigth_mm = 1\n");
  expect_error<InputError>([&] { load_scene(path); }, {"own.toml:2:1", "height_mm", "bearing.file"});
  expect_error<InputError>([&] { load_scene(folder / "none.toml"); }, {"none.toml", "no such file"});
  expect_error<InputError>([] { load_scene("rimpush"); }, {"did you mean \"rim-push\""});
}

TEST(SceneFiles, OneKindOfFileIsNotAnother) {
  const TemporaryFolder folder;
  const auto scene = folder.write("s.toml", "[bearing]\nfile = 'own.toml'\n[excitation]\nkind = 'push'\n");
  expect_error<InputError>([&] { load_bearing(scene); }, {"s.toml:1", "this is a scene", "own.toml"});
  EXPECT_NO_THROW(load_bearing(folder.write("other.toml", "[contact]\nrim = 0\n")));
}

/// A maker's bearing for rung rim: no word of pad and foot, and a slider that the default socket does not fit.
TEST(SceneFiles, ABearingWithoutPadAndFootServesRungRim) {
  const TemporaryFolder folder;
  folder.write(
      "own.toml",
      "name = 'acme'\n[surface]\nkind = 'sphere'\nR0_m = 3.0\nplanar_radius_mm = 600\n[slider]\ndiameter_mm = 300\n"
      "bottom_mm = 95\ntop_mm = 200\n[rim]\nheight_mm = 90\nthickness_mm = 50\n");
  const auto path = folder.write(
      "s.toml",
      "[bearing]\nfile = 'own.toml'\n[load]\nvertical_kN = 2000\n[excitation]\nkind = 'window'\nwith = ['weight']\n");
  const Scene scene = load_scene(path);
  EXPECT_GT(scene.bearing.foot.cap_radius, 0.095);
  EXPECT_EQ(scene.bearing.assumed.keys.count("foot.cap_radius_mm"), 1u);
  expect_same(scene, parse_scene(to_toml(scene), "scene.toml"));
  for (const char *rung : {"rigid-dish", "full"})
    expect_error<InputError>([&] { load_scene(path, {std::string("model.rung=") + rung}); }, {"own.toml"});
  expect_error<InputError>([&] { load_scene(path, {"reduced.finite_pad=true"}); }, {"own.toml"});
  expect_error<InputError>([&] { load_scene(path, {"bearing.foot.cap_radius_mm=90"}); },
                           {"foot.cap_radius_mm 90", "95"});
}

TEST(SceneFiles, ResolvedRecordsRunFromAnywhere) {
  const TemporaryFolder folder;
  folder.write("r.csv", "time_s,acceleration_g\n0,0\n0.01,0.5\n0.02,0\n");
  const std::string path = folder.write("s.toml", "[excitation]\nkind = 'record'\ny = 'r.csv'\n");
  const Scene scene = load_scene(path);
  EXPECT_NEAR(scene.excitation.y.values[1], 0.5 * 9.81, 1e-12);
  EXPECT_TRUE(std::filesystem::path(scene.excitation.y_file).is_absolute());
  const Scene again = parse_scene(to_toml(scene), "scene.toml", {}, "/");
  EXPECT_EQ(again.excitation.y, scene.excitation.y);
  expect_error<DataError>([&] { load_scene(path, {"excitation.y=gone.AT2"}); }, {"--set excitation.y", "no such file"});
}

TEST(SceneFiles, SylmarAsksForItsRecords) {
  if (std::filesystem::exists("RSN1086_NORTHR_SYL360.AT2")) GTEST_SKIP() << "the records are in the current folder";
  const char *given = std::getenv("RIMPACT_RECORDS");
  const std::string folder = given ? given : "";
  unsetenv("RIMPACT_RECORDS");
  expect_error<DataError>([] { load_scene("sylmar-bidirectional"); }, {"RSN1086_NORTHR_SYL360.AT2", "--set"});
  if (given) setenv("RIMPACT_RECORDS", folder.c_str(), 1);
}

const char *const table_text = "[surface]\nkind = 'table'\nfile = 'dish.csv'\n";

TEST(SceneFiles, TableOfRevolutionFromAFileIsWrittenOut) {
  const TemporaryFolder folder;
  std::string rows = "# a sphere of 2.25 m\nradius_mm,height_mm\n";
  for (int r = 0; r <= 530; r += 10)
    rows += fmt::format("{}, {:.9f}\n", r, 2250 - std::sqrt(2250.0 * 2250 - double(r) * r));
  folder.write("dish.csv", rows);
  const auto name = folder.write("b.toml", table_text);
  const Bearing b = load_bearing(name);
  EXPECT_NEAR(lift(b, 0.39), 2.25 - std::sqrt(2.25 * 2.25 - 0.39 * 0.39), 1e-9);
  EXPECT_EQ(b.surface.table_file, "");
  EXPECT_EQ(load_bearing(folder.write("out.toml", to_toml(b))), b) << "rows in place of the file";
  const auto scene = folder.write("scene.toml", "[bearing]\nfile = 'b.toml'\n");
  EXPECT_EQ(load_scene(scene).bearing.surface, b.surface);
}

TEST(SceneFiles, RefusesTablesWithTheirPlace) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string &bearing) {
    const auto name = folder.write("b.toml", bearing);
    return [name] { load_bearing(name); };
  };
  expect_error<DataError>(load(table_text), {"b.toml:3", "surface.file", "dish.csv"});
  folder.write("dish.csv", "radius_mm,height_mm\n0,0\n10,x\n");
  expect_error<DataError>(load(table_text), {"b.toml:3", "dish.csv:3", "\"x\" is not a finite number"});
  folder.write("dish.csv", "r,z\n0,0\n");
  expect_error<DataError>(load(table_text), {"dish.csv:1", "radius_mm,height_mm"});
  folder.write("dish.csv", "radius_mm,height_mm\n0,0\n10,1,2\n");
  expect_error<DataError>(load(table_text), {"dish.csv:3", "3 of 2 columns"});
  expect_error<InputError>(load(std::string(table_text) + "radius_mm = [0, 1]\n"), {"b.toml:3", "or the rows"});
  expect_error<InputError>(load("[surface]\nfile = 'dish.csv'\n"), {"b.toml:2", "needs surface.kind \"table\""});
  expect_error<InputError>(load("[surface]\nkind = 'table'\nradius_mm = [0, 'a']\n"),
                           {"b.toml:3", "surface.radius_mm must be a number", "\"a\""});
  expect_error<InputError>(load("[surface]\nkind = 'table'\nradius_mm = [0, 10]\nheight_mm = [0, 1]\n"),
                           {"b.toml:3", "at least 4 rows"});
}

} // namespace
