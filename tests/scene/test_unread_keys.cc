#include "scene/scene.h"
#include "scene/scene_catalogue.h"
#include "scene/toml_writer.h"
#include <gtest/gtest.h>

namespace {
using namespace rimpact::scene;

std::vector<std::string> remarks(const std::string &text, const std::vector<std::string> &set = {}) {
  return parse_scene("[load]\nvertical_kN = 853\n" + text, "a.toml", set).remarks;
}

TEST(UnreadKeys, OfAnotherKindAreNamed) {
  const auto said = remarks("[excitation]\nkind = \"ricker\"\nspeed_m_per_s = 0.7\ntravel_mm = 9\n");
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(
      said[0].find("excitation.speed_m_per_s, excitation.travel_mm are not read by this scene: excitation.kind is "
                   "\"ricker\""),
      0u)
      << said[0];
  EXPECT_EQ(remarks("[excitation]\nkind = \"ricker\"\n[reduced]\nyield_force_kN = 500\n").size(), 1u);
  EXPECT_EQ(remarks("[excitation]\nkind = \"ricker\"\n[isolator]\nradius_m = 1.5\n").size(), 1u);
  EXPECT_EQ(remarks("[excitation]\nkind = \"ricker\"\n", {"excitation.speed_m_per_s=0.7"}).size(), 1u);
}

/// A building reads them for its dishes: they stand apart, and a scene written out keeps them.
TEST(UnreadKeys, OfTheSpringsBesideADishStandApartAndAreKept) {
  const auto scene = parse_scene("[load]\nvertical_kN = 853\n[excitation]\nkind = \"ricker\"\n", "a.toml",
                                 {"isolator.contact_stiffness_kN_per_m=5e5", "isolator.capacity_m=0.25"});
  EXPECT_EQ(scene.springs_remark.find("isolator.contact_stiffness_kN_per_m is not read by this scene"), 0u);
  EXPECT_EQ(scene.isolator_remark.find("isolator.capacity_m is not read by this scene"), 0u);
  ASSERT_EQ(scene.remarks.size(), 2u);
  const auto again = parse_scene(to_toml(scene), "b.toml");
  EXPECT_EQ(again.isolator, scene.isolator);
  EXPECT_EQ(to_toml(parse_scene("[load]\nvertical_kN = 853\n", "a.toml")).find("[isolator]"), std::string::npos);
}

TEST(UnreadKeys, OfTheBearingAndOfMeshesToo) {
  const std::string ricker = "[excitation]\nkind = \"ricker\"\n";
  const auto said = [&](const std::string &set) {
    const auto sentences = remarks(ricker, {set});
    return sentences.size() == 1 ? sentences[0] : "";
  };
  const auto says = [&](const std::string &set, const std::string &choice) {
    const std::string key = set.substr(0, set.find('=')), sentence = said(set);
    EXPECT_EQ(sentence.find(key + " is not read by this scene"), 0u) << set << ": " << sentence;
    EXPECT_NE(sentence.find(choice), std::string::npos) << sentence;
  };
  says("bearing.surface.slope=0.2", "bearing.surface.kind \"ellipse\"");
  says("bearing.surface.radius_mm=[0, 100, 600]", "bearing.surface.kind \"ellipse\"");
  says("bearing.material.ertalyte.tangent_modulus_MPa=100", "bearing.material.ertalyte.yield_MPa inf");
  says("bearing.contact.rate_s_per_m=20", "bearing.contact.rim_slow");
  says("bearing.contact.pad_clearance_mm=1", "bearing.contact.pad_foot \"tied\"");
  says("model.own_mesh.unit=mm", "model.own_mesh.file");
  // written out with every scene, and of no effect
  says("reduced.elastic_slip_mm=3", "reduced.friction \"coulomb\"");
  says("reduced.rate_s_per_m=20", "reduced.mu_slow 0.07");
  EXPECT_EQ(said("bearing.rim.height_mm=70"), "");
  EXPECT_TRUE(remarks(ricker, {"reduced.elastic_slip_mm=3", "reduced.friction=park-wen"}).empty());
  EXPECT_TRUE(remarks(ricker, {"reduced.rate_s_per_m=20", "reduced.mu_slow=0.03"}).empty());
  EXPECT_TRUE(remarks(ricker, {"bearing.surface.slope=0.2", "bearing.surface.kind=cone"}).empty());
}

TEST(UnreadKeys, WhatIsReadOrLeftAtItsDefaultIsNoSlip) {
  EXPECT_TRUE(remarks("[excitation]\nkind = \"window\"\nspeed_m_per_s = 0.7\n").empty());
  EXPECT_TRUE(remarks("[excitation]\nkind = \"ricker\"\nspeed_m_per_s = 0.1\n").empty()); // the default
  EXPECT_TRUE(remarks("[excitation]\nkind = \"ricker\"\n[reduced]\ncapacity_offset_mm = 0\n").empty());
  // --set takes another kind: what the file says for its own is no slip
  EXPECT_TRUE(remarks("[excitation]\nkind = \"ricker\"\namplitude_g = 0.5\n", {"excitation.kind=free"}).empty());
  for (const auto &name : builtin_scene_names()) {
    if (!find_builtin_scene(name)->needs.empty()) continue; // a record that is not here
    for (const auto &remark : load_scene(name).remarks)
      EXPECT_EQ(remark.find("not read"), std::string::npos) << name << ": " << remark;
  }
}

TEST(UnreadOfThePad, FrictionOfTheReducedModelBesideASolidPadAndALossThatNothingReads) {
  const auto said = [](std::vector<std::string> more) {
    std::string all;
    for (const auto &remark : load_scene("ricker-0.78g-1.0s", more).remarks) all += remark + "\n";
    return all;
  };
  EXPECT_NE(said({"model.rung=full", "reduced.mu_fast=0.08"}).find("reduced.mu_fast 0.08 is not read by rung `full`"),
            std::string::npos);
  EXPECT_EQ(said({"model.rung=full"}).find("mu_fast"), std::string::npos);
  EXPECT_EQ(said({"model.rung=full", "bearing.contact.steel_ertalyte=0.08"}).find("mu_fast"), std::string::npos);
  EXPECT_EQ(said({"reduced.mu_fast=0.08"}).find("mu_fast"), std::string::npos); // rung rim slides by it
  const std::string loss = "bearing.pad.loss_factor=0.02";
  EXPECT_NE(said({loss}).find("bearing.pad.loss_factor 0.02 is not read"), std::string::npos);
  EXPECT_EQ(said({loss, "model.rung=rigid-dish"}).find("loss_factor"), std::string::npos);
  EXPECT_EQ(said({loss, "reduced.normal_force=pad", "reduced.friction=park-wen"}).find("loss_factor"),
            std::string::npos);
}

} // namespace
