// What is an assumption is said by the bearing's file, and kept on the way through resolving.
#include "expect_error.h"
#include "io/files/toml_comments.h"
#include "scene/assumptions.h"
#include "scene/bearing_catalogue.h"
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include "temporary_folder.h"
#include <algorithm>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

/// The value of an assumed key, "given" where it is none.
std::string value(const Bearing &bearing, const std::string &key) {
  for (const auto &a : assumptions(bearing))
    if (a.key == key) return a.value;
  return "given";
}

Bearing read(const std::string &text) {
  const TemporaryFolder folder;
  return load_bearing(folder.write("own.toml", text));
}

TEST(Assumptions, BuiltInsHaveTheCatalogues) {
  const Bearing b = builtin_bearing("shfps-225");
  EXPECT_EQ(value(b, "rim.height_mm"), "60");
  EXPECT_EQ(value(b, "slider.bottom_mm"), "58.25");
  EXPECT_EQ(value(b, "pad.outer_radius_mm"), "70.19");
  EXPECT_EQ(value(b, "material.steel.strain_limit"), "0.2");
  EXPECT_EQ(value(b, "material.ertalyte.density_kg_per_m3"), "1390");
  EXPECT_EQ(value(b, "slider.diameter_mm"), "given") << "the thesis gives it";
  EXPECT_EQ(value(b, "material.steel.yield_MPa"), "given");
}

TEST(Assumptions, WhatAUserGivesIsTheUsers) {
  const Bearing b = read("[rim]\nheight_mm = 70 # above the edge, no assumption any more\nthickness_mm = 50 # "
                         "assumption: from a photograph\n"
                         "ledge_mm = 0 # Assumed\n");
  EXPECT_EQ(value(b, "rim.height_mm"), "given");
  EXPECT_EQ(value(b, "rim.thickness_mm"), "50");
  EXPECT_EQ(value(b, "rim.ledge_mm"), "0");
  EXPECT_EQ(value(b, "slider.diameter_mm"), "240") << "left to our default, whatever it is";
}

TEST(Assumptions, AMarkMayStandOnAHeaderOrInAList) {
  const Bearing b = read("assumed = ['material.steel.yield_MPa']\n[rim] # assumption, but for nothing\nheight_mm = "
                         "70\n[slider]\ndiameter_mm = 240\n"
                         "[material.steel]\nyield_MPa = 355\n");
  EXPECT_EQ(value(b, "rim.height_mm"), "70");
  EXPECT_EQ(value(b, "slider.diameter_mm"), "given") << "the next table";
  EXPECT_EQ(value(b, "material.steel.yield_MPa"), "355");
  expect_error<InputError>([] { read("assumed = ['rim.hieght_mm']\n"); },
                           {"own.toml:1", "assumed", "did you mean \"rim.height_mm\""});
  expect_error<InputError>([] { read("assumed = 'rim.height_mm'\n"); }, {"own.toml:1", "array"});
}

TEST(Assumptions, DottedKeysAndInlineTablesAreMarkedByTheirLine) {
  const Bearing b = read("rim.height_mm = 70 # assumption\nrim.thickness_mm = 50\nslider = { diameter_mm = 240, top_mm "
                         "= 158.25 } # assumption\n");
  EXPECT_EQ(value(b, "rim.height_mm"), "70");
  EXPECT_EQ(value(b, "rim.thickness_mm"), "given") << "the line of another key is no header";
  EXPECT_EQ(value(b, "slider.top_mm"), "158.25");
}

TEST(Assumptions, StringsWithASignAreNoComments) {
  const auto comments = toml_comments("a = \"x # assumption\"\nb = 'y # no' # one\nc = \"\"\"\n# two \\\n\"\"\" # "
                                      "three\n[t] # four\nd = \"\\\"# no\"\n");
  EXPECT_EQ(comments.by_line, (std::map<std::size_t, std::string>{{2, "one"}, {5, "three"}, {6, "four"}}));
  EXPECT_EQ(comments.headers, std::set<std::size_t>{6});
}

TEST(Assumptions, AreKeptThroughResolving) {
  const TemporaryFolder folder;
  folder.write("own.toml", "[rim]\nheight_mm = 70\nthickness_mm = 50 # assumption\n");
  const auto path = folder.write(
      "scene.toml",
      "[bearing]\nfile = 'own.toml'\n[bearing.pad]\nrecess_mm = 20\n[bearing.foot]\nradius_mm = 86 # assumption\n");
  const Scene scene = load_scene(path, {"bearing.slider.top_mm=160", "bearing.rim.ledge_mm=0 # assumption"});
  for (const Bearing &b :
       {scene.bearing, parse_scene(to_toml(scene), "resolved.toml").bearing, read(to_toml(scene.bearing))}) {
    EXPECT_EQ(value(b, "rim.height_mm"), "given");
    EXPECT_EQ(value(b, "rim.thickness_mm"), "50");
    EXPECT_EQ(value(b, "pad.recess_mm"), "given") << "overridden in the scene";
    EXPECT_EQ(value(b, "foot.radius_mm"), "86");
    EXPECT_EQ(value(b, "slider.top_mm"), "given") << "--set is the user's";
    EXPECT_EQ(value(b, "rim.ledge_mm"), "0") << "unless it says otherwise";
    EXPECT_EQ(value(b, "slider.diameter_mm"), "240");
  }
  const Scene builtin = load_scene("impact-window", {"bearing.rim.height_mm=70"});
  EXPECT_EQ(value(builtin.bearing, "rim.height_mm"), "given");
  EXPECT_EQ(value(builtin.bearing, "rim.thickness_mm"), "40");
  EXPECT_EQ(parse_scene(to_toml(builtin), "resolved.toml").bearing.assumed.keys, builtin.bearing.assumed.keys);
}

/// That nobody gave the load is known of the resolved scene too; one of its two keys is enough to give it.
TEST(Assumptions, TheLoadIsOneWhereNobodyGivesIt) {
  const auto assumed = [](const std::string &text, const std::vector<std::string> &set = {}) {
    const Scene scene = parse_scene(text, "a.toml", set);
    EXPECT_EQ(load_is_assumed(parse_scene(to_toml(scene), "resolved.toml")), load_is_assumed(scene)) << text;
    return load_is_assumed(scene);
  };
  const std::string window = "[excitation]\nkind = \"window\"\n";
  EXPECT_TRUE(assumed(window));
  EXPECT_FALSE(assumed(window + "[load]\nvertical_kN = 853\n"));
  EXPECT_FALSE(assumed(window + "[load]\nmass_kg = 86952 # assumption\nvertical_kN = 853\n"));
  EXPECT_TRUE(assumed(window + "[load]\nmass_kg = 86952 # assumption\n"));
  EXPECT_FALSE(assumed(window, {"load.mass_kg=86952"}));
  EXPECT_FALSE(load_is_assumed(parse_scene(to_toml(parse_scene(window, "a.toml")), "b.toml", {"load.mass_kg=9e4"})));
}

TEST(Assumptions, TheBuiltInPadOfAnotherBearing) {
  EXPECT_FALSE(has_default_pad(builtin_bearing("shfps-225")));
  const std::string other = "[surface]\nkind = \"sphere\"\nR0_m = 3\nplanar_radius_mm = 600\n[slider]\n"
                            "diameter_mm = 300\n";
  EXPECT_TRUE(has_default_pad(read(other)));
  EXPECT_FALSE(has_default_pad(read(other + "[pad]\nouter_radius_mm = 120\nthickness_mm = 30\n")));
  EXPECT_FALSE(has_default_pad(read("[slider]\ndiameter_mm = 240 # a copy\n")));
}

} // namespace
