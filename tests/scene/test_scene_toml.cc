// Keys, defaults and overrides of a scene, and the errors that name their place.
#include "expect_error.h"
#include "scene_text.h"

namespace {
using namespace rimpact;
using namespace rimpact::scene;

TEST(SceneToml, InterfacesExampleIsUnderstood) {
  const Scene s = scene_of(R"(
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
  const Scene long_pulse = scene_of("[excitation]\nperiod_s = 1.5\n");
  EXPECT_DOUBLE_EQ(long_pulse.excitation.centre, 3.0);
  EXPECT_DOUBLE_EQ(long_pulse.excitation.duration, 9.0);
  const Scene window = scene_of("[excitation]\nkind = 'window'\n");
  EXPECT_DOUBLE_EQ(window.excitation.duration, 0.2);
  EXPECT_FALSE(window.excitation.with_weight || window.excitation.with_friction || window.excitation.with_ground);
  EXPECT_TRUE(scene_of("[excitation]\nkind = 'window'\nwith = ['weight', 'ground']").excitation.with_ground);
  EXPECT_DOUBLE_EQ(scene_of("[excitation]\nkind = 'figure-eight'\n").excitation.amplitude, 0.31);
  EXPECT_DOUBLE_EQ(scene_of("[bearing.contact]\nsteel_ertalyte = 0.05\n").reduced.mu_slow, 0.05);
  EXPECT_DOUBLE_EQ(scene_of("[excitation]\nkind='record'\nx='builtin:near-fault-x'\n").excitation.duration, 6.0);
}

TEST(SceneToml, ErrorsNameFileLineColumnAndBound) {
  const auto refuse = [](const std::string &text, std::initializer_list<const char *> words) {
    SCOPED_TRACE(text);
    expect_error<InputError>([&] { scene_of(text); }, words);
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
  refuse("[reduced]\nmu = 0.05\n", {"my.toml:2:1", "unknown key \"mu\" in [reduced]", "mu_fast", "mu_slow"});
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
  refuse("load.vertical_kN=2,000",
         {"--set load.vertical_kN=2,000:", "; 2.000 with its decimals behind a point, or 2000 without"});
  refuse("load.vertical_kN=2000,5", {"--set load.vertical_kN=2000,5:", "decimals follow a point: 2000.5"});
  refuse("reduced.k_i_kN_per_m=1e13", {"of a magnitude of 1e+12 at most"});
  refuse("reduced.restitution=1e13", {"> 0 and <= 1"});
  expect_error<InputError>([&] { load_scene("static-unidirectional", {"excitation.cycles=9999"}); },
                           {"9999 cycles would store 2e+07 instants; at most 2000 cycles"});
  refuse("rim.height_mm=70", {"--set rim.height_mm=70", "it is bearing.rim"});
}

TEST(SceneToml, OverridesAreTomlValuesOrBareWords) {
  const Scene s = load_scene("impact-window", {"excitation.with=[\"friction\"]", "reduced.impact_law=printed",
                                               "excitation.speed_m_per_s=1", "excitation.scale = 0.5 "});
  EXPECT_TRUE(s.excitation.with_friction);
  EXPECT_EQ(s.reduced.impact_law->name, "printed");
  EXPECT_DOUBLE_EQ(s.excitation.impact_speed(), 0.5);
}

} // namespace
