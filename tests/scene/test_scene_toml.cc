#include "expect_error.h"
#include "scene/scene.h"
#include "scene/scene_catalogue.h"
#include "temporary_folder.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;
using Overrides = std::vector<std::string>;

Scene parse(const std::string &text, const Overrides &overrides = {}) {
  return parse_scene(text, "my.toml", overrides);
}

bool is_available(const std::string &name) {
  return find_builtin_scene(name)->needs.empty(); // not the user's records
}

/// Everything a scene says, compared field by field where it has an ==, by text for the settings.
void expect_same(const Scene &a, const Scene &b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.bearing, b.bearing);
  EXPECT_EQ(a.load.vertical, b.load.vertical);
  EXPECT_EQ(a.load.mass, b.load.mass);
  EXPECT_EQ(a.excitation.x, b.excitation.x);
  EXPECT_EQ(a.excitation.travel, b.excitation.travel);
  EXPECT_EQ(a.reduced.elastic_slip, b.reduced.elastic_slip);
  EXPECT_EQ(a.reduced.k_i, b.reduced.k_i);
  EXPECT_EQ(to_toml(a), to_toml(b));
}

/// A dish of 500 rows comes back from its own scene.toml, which reads on lines of bearable length.
TEST(SceneToml, ALongTableComesBackFromItsOwnFile) {
  std::string radii = "0.0", heights = "0.0";
  for (int i = 1; i < 500; ++i) {
    const double r = 1.1 * i;
    radii += fmt::format(", {}", r),
        heights += fmt::format(", {:.9f}", 140.625 * (1 - std::sqrt(1 - r * r / (562.5 * 562.5))));
  }
  const Scene scene = parse("[bearing.surface]\nkind = \"table\"\nplanar_radius_mm = 520.0\nradius_mm = [" + radii +
                            "]\nheight_mm = [" + heights + "]\n");
  ASSERT_EQ(scene.bearing.surface.table_radius.size(), 500u);
  const std::string text = to_toml(scene);
  expect_same(scene, parse(text));
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\n', at), text.size());
    EXPECT_LT(end - at, 200u);
    at = end + 1;
  }
}

TEST(SceneToml, InterfacesExampleIsUnderstood) {
  const Scene s = parse(R"(
[bearing]
name = "shfps-225"
[load]
vertical_kN = 853.0
mass_kg = 86952.0
gravity_m_per_s2 = 9.81
[excitation]
kind = "ricker"
scale = 1.05
amplitude_g = 0.78
period_s = 1.0
centre_s = 2.0
duration_s = 8.0
[model]
rung = "rim"
mesh = 2
[reduced]
model = "physical"
k_i_kN_per_m = 4.5e5
restitution = 0.65
impact_law = "no-tension"
friction = "coulomb"
mu_fast = 0.07
mu_slow = 0.07
normal_force = "static"
)");
  EXPECT_EQ(s.name, "my");
  EXPECT_EQ(s.bearing, Bearing{});
  EXPECT_DOUBLE_EQ(s.load.vertical, 853e3);
  EXPECT_DOUBLE_EQ(s.excitation.scale, 1.05);
  EXPECT_EQ(s.model.mesh, 2);
  EXPECT_DOUBLE_EQ(s.reduced.k_i, 4.5e8);
  EXPECT_EQ(s.reduced.impact_law->name, "no-tension");
  EXPECT_EQ(s.reduced.normal_force, NormalForce::statics);
}

TEST(SceneToml, DefaultsFollowOtherKeys) {
  const Scene long_pulse = parse("[excitation]\nperiod_s = 1.5\n");
  EXPECT_DOUBLE_EQ(long_pulse.excitation.centre, 3.0);
  EXPECT_DOUBLE_EQ(long_pulse.excitation.duration, 9.0);
  const Scene window = parse("[excitation]\nkind = 'window'\n");
  EXPECT_DOUBLE_EQ(window.excitation.duration, 0.2);
  EXPECT_FALSE(window.excitation.with_weight || window.excitation.with_friction || window.excitation.with_ground);
  EXPECT_TRUE(parse("[excitation]\nkind = 'window'\nwith = ['weight', 'ground']").excitation.with_ground);
  EXPECT_DOUBLE_EQ(parse("[excitation]\nkind = 'figure-eight'\n").excitation.amplitude, 0.31);
  EXPECT_DOUBLE_EQ(parse("[bearing.contact]\nsteel_ertalyte = 0.05\n").reduced.mu_slow, 0.05);
  EXPECT_DOUBLE_EQ(parse("[excitation]\nkind='record'\nx='builtin:near-fault-x'\n").excitation.duration, 6.0);
}

TEST(SceneToml, EveryBuiltInRoundTripsExactly) {
  for (const auto &name : builtin_scene_names()) {
    if (!is_available(name)) continue;
    SCOPED_TRACE(name);
    const Scene scene = load_scene(name);
    EXPECT_EQ(scene.name, name);
    expect_same(scene, parse_scene(to_toml(scene), "scene.toml"));
    const bool is_static = name.starts_with("static");
    EXPECT_EQ(scene.model.rung, is_static ? Rung::rigid_dish : Rung::rim);
  }
  for (const auto &name : builtin_bearing_names()) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    EXPECT_EQ(load_bearing(folder.write("b.toml", to_toml(builtin_bearing(name)))), builtin_bearing(name));
    EXPECT_EQ(builtin_scene_text(name), to_toml(builtin_bearing(name)));
  }
}

TEST(SceneToml, EveryOverrideRoundTripsExactly) {
  const Overrides each{"bearing.name=fps-225",
                       "bearing.surface.kind=sphere",
                       "bearing.surface.kind=cone",
                       "bearing.surface.kind=polynomial",
                       "bearing.rim.height_mm=70.3",
                       "bearing.slider.diameter_mm=230.1",
                       "bearing.plate.base_mm=33.33",
                       "bearing.rim.thickness_mm=17",
                       "bearing.material.steel.yield_MPa=inf",
                       "bearing.material.steel.tangent_modulus_MPa=0",
                       "bearing.material.ertalyte.yield_MPa=90",
                       "bearing.contact.pad_foot=frictional",
                       "load.vertical_kN=1234.567",
                       "load.mass_kg=1e5",
                       "excitation.scale=1.05",
                       "excitation.kind=cyclic",
                       "excitation.kind=push",
                       "excitation.kind=free",
                       "excitation.kind=window",
                       "excitation.direction_deg=37.5",
                       "model.rung=full",
                       "model.mesh=3",
                       "model.step_ms=0.35",
                       "model.rho_inf=1",
                       "model.symmetry=whole",
                       "reduced.k_i_kN_per_m=123456.789",
                       "reduced.restitution=1.0",
                       "reduced.friction=park-wen",
                       "reduced.elastic_slip_mm=0.3",
                       "reduced.mu_fast=0.1",
                       "reduced.vertical_restitution=0.2",
                       "reduced.finite_pad=true",
                       "reduced.socket_friction=true",
                       "reduced.tolerance=1e-7",
                       "reduced.output_step_ms=1.7",
                       "name='with \"quotes\" and \\ and \t'"};
  for (const auto &assignment : each) {
    SCOPED_TRACE(assignment);
    const Scene changed = load_scene("ricker-0.78g-1.0s", {assignment});
    EXPECT_NE(to_toml(changed), to_toml(load_scene("ricker-0.78g-1.0s")));
    expect_same(changed, parse_scene(to_toml(changed), "scene.toml"));
  }
  const Scene window = load_scene("impact-window", {"excitation.with=['weight','friction','ground']"});
  expect_same(window, parse_scene(to_toml(window), "scene.toml"));
}

TEST(SceneToml, ErrorsNameFileLineColumnAndBound) {
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    SCOPED_TRACE(text);
    expect_error<InputError>([&] { parse(text); }, words);
  };
  refuse("[load]\nmas_kg = 3\n", {"my.toml:2:1", "mas_kg", "[load]", "did you mean \"mass_kg\""});
  refuse("[laod]\nmass_kg = 3\n", {"my.toml:1:2", "laod", "did you mean \"load\""});
  refuse("[load]\nmass_kg = \"heavy\"\n", {"my.toml:2:11", "load.mass_kg", "number", "heavy"});
  refuse("[load]\n\n  mass_kg = -3\n", {"my.toml:3:13", "-3", "> 0"});
  refuse("[load]\nmass_kg = nan\n", {"my.toml:2", "nan"});
  refuse("[load]\nmass_kg = inf\n", {"my.toml:2", "a finite number, got inf"});
  refuse("[excitation]\nkind = 'riker'\n", {"my.toml:2:8", "riker", "did you mean \"ricker\""});
  refuse("[bearing.surface]\nkind = 'elipse'\n", {"my.toml:2:8", "elipse", "did you mean \"ellipse\"", "sphere"});
  refuse("[bearing.contact]\npad_foot = 'tide'\n", {"my.toml:2", "tide", "did you mean \"tied\""});
  refuse("[reduced]\nfriction = 'x'\n", {"my.toml:2", "\"x\" is not known", "coulomb, park-wen"});
  refuse("[reduced]\nnormal_force = 'x'\n", {"my.toml:2", "inertia, static, constant"});
  refuse("[reduced]\nmodel = 'pysical'\n", {"reduced.model \"pysical\" is unknown; known: physical, dcfp, lir-dcfp"});
  refuse("[excitation]\nwith = ['wieght']\n", {"my.toml:2", "wieght", "did you mean \"weight\""});
  refuse("[excitation]\nreturn = 1\n", {"my.toml:2", "true or false"});
  refuse("[model]\nmesh = 2.0\n", {"my.toml:2", "whole number, got 2.0"});
  refuse("[model]\nmesh = 9\n", {"my.toml:2", "9", "between 0 and 3"});
  refuse("[model\n", {"my.toml:1"});
  refuse("[load]\nmass_kg = 1\nmass_kg = 2\n", {"my.toml:3"});
  refuse("load = 3\n", {"my.toml:1", "load must be a table"});
  refuse("[bearing.rim]\nheight_mm = 5\n", {"my.toml:2:13", "92", "100"});
  refuse("[bearing.rim]\nhieght_mm = 5\n", {"my.toml:2:1", "[bearing.rim]", "did you mean \"height_mm\""});
  refuse("[bearing]\nname = 'shfps'\n", {"my.toml:2:8", "did you mean \"shfps-225\""});
  refuse("[bearing]\nfile = 'gone.toml'\n", {"my.toml:2:8", "gone.toml", "no such file"});
  refuse("[reduced]\nmu_fast = 0.05\nmu_slow = 0.1\n", {"my.toml:3", "0.1", "0.05"});
  refuse("[reduced]\nmu_fast = 0.1\nmu_slow = 0.05\n", {"reduced.rate_s_per_m 0", "0.05"});
  refuse("[reduced]\nrestitution = 1.2\n", {"1.2", "<= 1"});
  refuse("[excitation]\nkind = 'record'\n", {"excitation.x"});
  refuse("[excitation]\nkind = 'cyclic'\namplitude_m = 0.7\n",
         {"my.toml:3", "excitation.amplitude_m", "0.7", "0.5625"});
  refuse("[excitation]\nkind = 'free'\ndisplacement_m = [0.5, 0]\n", {"my.toml:3", "0.5", "0.4"});
  refuse("[excitation]\nkind = 'record'\nx = 'builtin:near-falt-x'\n", {"my.toml:3", "did you mean"});
  refuse("[reduced]\nmu = 0.05\n", {"my.toml:2:1", "unknown key \"mu\" in [reduced]", "mu_fast, mu_slow"});
  refuse("[load]\nqqqqqq = 1\n", {"known: gravity_m_per_s2, mass_kg, vertical_kN"});
  refuse("[load]\nvertical_kN = 2000,5\n", {"my.toml:2:", "decimals follow a point: 2000.5"});
  refuse("bearing = 'own.toml'\n", {"my.toml:1:11", "the line [bearing] and under it the line file = \"own.toml\""});
  refuse("[rim]\nheight_mm = 60\n",
         {"my.toml:1", "a bearing file", "where a scene is wanted", "file = \"my.toml\"", "rimpact main"});
  refuse("[excitation]\nkind = 'ricker'\n[rim]\nheight_mm = 60\n", {"my.toml:3", "it is bearing.rim"});
  refuse("[bearing.material.steel]\ntangent_modulus_MPa = inf\n",
         {"my.toml:2", "tangent_modulus_MPa inf", "below E_MPa 200000"});
}

TEST(SceneToml, OverrideErrorsNameTheOverride) {
  const auto refuse = [](const char *assignment, std::initializer_list<const char *> words) {
    SCOPED_TRACE(assignment);
    expect_error<InputError>([&] { load_scene("rim-push", {assignment}); }, words);
  };
  refuse("load.mass_kg=-3", {"--set load.mass_kg=-3:", "> 0"});
  refuse("load.mas_kg=3", {"--set load.mas_kg=3:", "did you mean \"mass_kg\""});
  refuse("lod.mass_kg=3", {"--set lod.mass_kg=3:", "did you mean \"load\""});
  refuse("load.mass_kg=0.5g", {"--set load.mass_kg=0.5g:", "\"0.5g\""});
  refuse("bearing.rim.height_mm=5", {"--set bearing.rim.height_mm=5:", "92", "100"});
  refuse("load", {"KEY=VALUE"});
  refuse("=3", {"KEY"});
  refuse("load..x=3", {"KEY"});
  refuse("excitation.kind.deep=3", {"kind is not a table"});
  refuse("load.vertical_kN=2000,5", {"--set load.vertical_kN=2000,5:", "decimals follow a point: 2000.5"});
  refuse("rim.height_mm=70", {"--set rim.height_mm=70", "it is bearing.rim"});
}

TEST(SceneToml, OverridesAreTomlValuesOrBareWords) {
  const Scene s = load_scene("impact-window", {"excitation.with=[\"friction\"]", "reduced.impact_law=printed",
                                               "excitation.speed_m_per_s=1", "excitation.scale = 0.5 "});
  EXPECT_TRUE(s.excitation.with_friction);
  EXPECT_EQ(s.reduced.impact_law->name, "printed");
  EXPECT_DOUBLE_EQ(s.excitation.impact_speed(), 0.5);
}

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
  expect_error<DataError>([] { load_scene("sylmar-bidirectional"); }, {"RSN1086_NORTHR_SYL360.AT2", "--set"});
}

const char *const table_text = "[surface]\nkind = 'table'\nfile = 'dish.csv'\n";

TEST(SceneToml, TableOfRevolutionFromAFileIsWrittenOut) {
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

TEST(SceneToml, RefusesTablesWithTheirPlace) {
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
