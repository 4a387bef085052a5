// [isolator]: what cannot be built is refused with its place, its value and its bound.
#include "expect_error.h"
#include "io/files/key_list.h"
#include "scene/isolator_catalogue.h"
#include "scene/keys.h"
#include "scene/scene.h"
#include "scene/scene_keys.h"
#include "scene/toml_writer.h"
#include <algorithm>
#include <cmath>

namespace {
using namespace rimpact;

struct Case {
  const char *name, *lines; ///< of [isolator]; the last line is at fault
  std::initializer_list<const char *> words;
};

const Case cases[] = {
    {"negative_radius", "radius_m = -1.6", {"isolator.radius_m -1.6", "must be > 0"}},
    {"nan", "capacity_m = nan", {"isolator.capacity_m", "nan"}},
    {"capacity_beyond_the_sphere", "capacity_m = 5", {"isolator.capacity_m 5 must be below R_eff = 3 m"}},
    {"slider_as_wide_as_the_sphere", "slider_diameter_mm = 4000", {"slider_diameter_mm 4000 must be below 2 R"}},
    {"slider_flatter_than_its_face", "top_height_mm = 1", {"top_height_mm 1 must exceed", "depth of its curved face"}},
    {"no_gap",
     "top_wall_mm = 20\nbottom_wall_mm = 60",
     {"bottom_wall_mm 60 exceeds isolator.top_wall_mm 20", "no gap"}},
    {"wall_fills_the_slider", "top_wall_mm = 900", {"top_wall_mm 900 leaves no interface"}},
    {"top_friction_the_wrong_way",
     "top_mu_fast = 0.05\ntop_mu_slow = 0.08",
     {"isolator.top_mu_slow 0.08 exceeds isolator.top_mu_fast 0.05"}},
    {"friction_out_of_range", "mu_interface = 3", {"isolator.mu_interface 3 must be >= 0 and <= 2"}},
    {"restitution_above_one", "contact_restitution = 1.2", {"isolator.contact_restitution 1.2"}},
    {"plate_without_mass", "damped_mass = \"bearing\"\nplate_mass_kg = 0", {"isolator.plate_mass_kg 0", "must be > 0"}},
    {"unknown_mass", "damped_mass = \"slider\"", {"isolator.damped_mass \"slider\"", "supported", "bearing"}},
    {"too_few_points", "space = \"spatial\"\npoints = 2", {"isolator.points 2 must be at least 3 in space"}},
    {"one_point", "points = 1", {"isolator.points 1 must be between 2 and 64"}},
    {"plate_turns_in_the_plane", "space = \"planar\"\nplate_rotation = \"free\"", {"plate_rotation"}},
    {"wrong_type", "radius_m = \"two\"", {"isolator.radius_m", "number"}},
    {"unknown_key", "capasity_m = 0.3", {"unknown key \"capasity_m\"", "did you mean \"capacity_m\"?"}},
    {"unknown_word", "space = \"planer\"", {"isolator.space \"planer\"", "did you mean \"planar\"?"}},
};

void PrintTo(const Case &c, std::ostream *out) {
  *out << c.name;
}

class Isolator : public testing::TestWithParam<Case> {};

TEST_P(Isolator, IsRefusedWithPlaceValueAndBound) {
  const std::string text =
      std::string("[excitation]\nkind = \"ricker\"\n[reduced]\nmodel = \"lir-dcfp\"\n[isolator]\n") + GetParam().lines;
  const int line = 5 + std::count(text.begin() + text.find("[isolator]"), text.end(), '\n');
  const std::string place = "my.toml:" + std::to_string(line) + ":";
  expect_error<InputError>([&] { scene::parse_scene(text, "my.toml", {}); }, GetParam().words);
  expect_error<InputError>([&] { scene::parse_scene(text, "my.toml", {}); }, {place.c_str()});
}

INSTANTIATE_TEST_SUITE_P(Input, Isolator, testing::ValuesIn(cases),
                         [](const auto &info) { return std::string(info.param.name); });

const Case triples[] = {
    {"unknown_name", "name = \"tfp-fens-2008\"", {"isolator \"tfp-fens-2008\"", "did you mean \"tfp-fenz-2008\""}},
    {"slide_plate_without_thickness", "bottom_height_mm = 20", {"isolator.bottom_height_mm 20 must exceed", "inner"}},
    {"inner_rim_outside", "slider_diameter_mm = 60", {"inner.travel_mm 19 puts the inner rim", "outside"}},
    {"travel_beyond_the_sphere", "travel_mm = 500", {"isolator.travel_mm 500 must be below R = 473 mm"}},
    {"unknown_reading", "mu_of = \"points\"", {"isolator.mu_of \"points\"", "faces", "loops"}},
    {"inner_slider_flatter_than_its_face",
     "[isolator.inner]\nbottom_height_mm = 4",
     {"isolator.inner.bottom_height_mm 4 must exceed", "depth of its curved face"}},
    {"friction_the_wrong_way",
     "[isolator.inner]\nmu_fast = 0.02\nmu_slow = 0.03",
     {"isolator.inner.mu_slow 0.03 exceeds isolator.inner.mu_fast 0.02"}},
    {"friction_of_the_upper_face_the_wrong_way",
     "[isolator.inner]\nmu_fast = 0.02\ntop_mu_slow = 0.03",
     {"isolator.inner.top_mu_slow 0.03 exceeds isolator.inner.mu_fast 0.02"}},
    {"upper_travel_beyond_the_sphere",
     "[isolator.inner]\ntop_travel_mm = 80",
     {"isolator.inner.top_travel_mm 80 must be below R = 76 mm"}},
    {"upper_sphere_smaller_than_its_height",
     "top_radius_m = 0.08\ntop_travel_mm = 5",
     {"isolator.top_radius_m 0.08 less its height must exceed 0.053 m"}},
};

class Triple : public testing::TestWithParam<Case> {};

TEST_P(Triple, IsRefusedWithValueAndBound) {
  const std::string text = std::string("[excitation]\nkind = \"ricker\"\n[reduced]\nmodel = \"tfp\"\n[isolator]\n");
  EXPECT_NO_THROW(scene::parse_scene(text, "my.toml", {}));
  expect_error<InputError>([&] { scene::parse_scene(text + GetParam().lines, "my.toml", {}); }, GetParam().words);
  expect_error<InputError>([&] { scene::parse_scene(text + GetParam().lines, "my.toml", {}); }, {"my.toml:"});
}

INSTANTIATE_TEST_SUITE_P(Input, Triple, testing::ValuesIn(triples),
                         [](const auto &info) { return std::string(info.param.name); });

TEST(TripleOfTheCatalogue, IsWrittenOutAndReadAgain) {
  for (const auto &name : scene::builtin_isolator_names()) {
    const auto s = scene::load_scene("tfp-stages", {"isolator.name=\"" + name + "\""});
    EXPECT_TRUE(s.isolator == scene::builtin_isolator(name)) << name;
    const auto again = scene::parse_scene(scene::to_toml(s), "scene.toml");
    EXPECT_TRUE(again.isolator == s.isolator) << name;
    EXPECT_TRUE(again.remarks.empty()) << again.remarks.front();
  }
}

/// Below zero and without a value: refused by key and value, and where it stands.
TEST(TripleOfTheCatalogue, EveryNumberOfItHasABound) {
  scene::Scene s = scene::load_scene("tfp-stages");
  KeyList list("", true);
  visit_settings(list, s);
  int asked = 0;
  for (const auto &entry : list.entries) {
    const std::string key = entry.path();
    if (!key.starts_with("isolator.") || !entry.is_number) continue;
    ++asked;
    expect_error<InputError>([&] { scene::load_scene("tfp-stages", {key + "=-1"}); },
                             {(key + " -1 must be ").c_str(), "--set"});
    expect_error<InputError>([&] { scene::load_scene("tfp-stages", {key + "=nan"}); },
                             {(key + " must be a finite number, got nan").c_str(), "--set"});
  }
  EXPECT_GT(asked, 30);
}

TEST(TripleOfTheCatalogue, OfBadShapeIsSaidBeforeItsStart) {
  expect_error<InputError>(
      [] {
        scene::load_scene("tfp-pulse", {"excitation.kind=\"free\"", "isolator.travel_mm=5000"});
      },
      {"isolator.travel_mm 5000 must be below R = 3962.4 mm"});
}

TEST(TripleOfTheCatalogue, FrictionBySpeedOfOneFaceNeedsARate) {
  const std::vector<std::string> no_rate{"reduced.rate_s_per_m=0", "isolator.inner.top_mu_slow=0.005"};
  expect_error<InputError>([&] { scene::load_scene("tfp-pulse", no_rate); },
                           {"reduced.rate_s_per_m 0 must be > 0", "isolator.inner.top_mu_slow 0.005"});
  const auto s = scene::load_scene("tfp-pulse", {"reduced.rate_s_per_m=50", "isolator.inner.top_mu_slow=0.005"});
  EXPECT_TRUE(s.remarks.empty()) << s.remarks.front(); // the rate is read
}

/// The displacement capacity of the tested specimen: its four pivots' travels, but for the turns.
TEST(TripleOfTheCatalogue, ReachesTheSumOfItsTravels) {
  const auto b = scene::builtin_isolator("tfp-fenz-2008");
  const double sum = 2 * (64e-3 * 435 / 473 + 19e-3 * 53 / 76);
  EXPECT_NEAR(scene::triple_capacity(b), sum, 0.01 * sum);
}

TEST(IsolatorOfTheThesis, ItsRimsStandByTheApproximateFormulaAMillimetreOrTwoFartherOut) {
  scene::Isolator b; // the bearings of thesis 3.5: R_eff = 3 m, C = 0.30 m, D_s = 300 mm, H_s = 100 mm
  const double exact = b.bottom_rim_radius();
  EXPECT_NEAR(exact, 1.55 * std::sin(std::asin(0.1) + std::asin(0.15 / 1.55)), 1e-15);
  b.rim_place = scene::RimPlace::approximate;
  EXPECT_NEAR(b.bottom_rim_radius(), (0.30 + 0.30 + 0.10 * 0.1) / 2, 1e-15);
  EXPECT_EQ(b.top_rim_radius(), b.bottom_rim_radius());
  EXPECT_NEAR(b.bottom_rim_radius() - exact, 1.4e-3, 0.1e-3);
}

TEST(IsolatorWithUnequalPlates, ItsTopKeysAreReadWrittenAndDefaultToTheBottoms) {
  const std::string head =
      "[excitation]\nkind = \"ricker\"\n[reduced]\nmodel = \"dcfp\"\nrate_s_per_m = 50\n[isolator]\n";
  const auto alike = scene::parse_scene(head + "radius_m = 1.2\ncapacity_m = 0.2\n", "my.toml", {});
  EXPECT_EQ(alike.isolator.upper_radius(), 1.2);
  EXPECT_EQ(alike.isolator.lateral_capacity(), 0.2);
  EXPECT_EQ(to_toml(alike).find("top_radius"), std::string::npos);
  const auto apart = scene::parse_scene(
      head + "radius_m = 1.2\ntop_radius_m = 2.0\ntop_capacity_m = 0.25\ntop_mu_fast = 0.1\ntop_mu_slow = 0.08\n",
      "my.toml", {});
  EXPECT_NEAR(apart.isolator.effective_radius(), 3.1, 1e-15);
  EXPECT_EQ(apart.isolator.lateral_capacity(), 0.25); // the bottom's 0.30 comes later
  EXPECT_EQ(scene::parse_scene(to_toml(apart), "again.toml", {}).isolator, apart.isolator);
  expect_error<InputError>([&] { scene::parse_scene(head + "top_radius_m = -1\n", "my.toml", {}); },
                           {"isolator.top_radius_m -1", "my.toml:7"});
  expect_error<InputError>([&] { scene::parse_scene(head + "top_capacity_m = 9\n", "my.toml", {}); },
                           {"isolator.top_capacity_m 9 must be below R_eff"});
  expect_error<InputError>([&] { scene::parse_scene(head + "top_mu_fast = 3\n", "my.toml", {}); },
                           {"isolator.top_mu_fast 3"});
}

TEST(IsolatorOfAPlane, MovesAlongXOnly) {
  expect_error<InputError>(
      [] {
        scene::parse_scene("[excitation]\nkind = \"figure-eight\"\n[reduced]\nmodel = "
                           "\"dcfp\"\n[isolator]\nspace = \"planar\"\n",
                           "my.toml", {});
      },
      {"my.toml", "isolator.space \"planar\" moves along x only"});
}

} // namespace
