// A slider between two like dishes: capacity, tilt and mass against searches and sums of their own; keys; refusals.
#include "expect_error.h"
#include "scene/bearing_catalogue.h"
#include "scene/isolator_catalogue.h"
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include "scene/triple_pendulum.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

Bearing two_dishes() {
  return builtin_bearing("dcfp-155");
}

/// The slider's lower outline in its own section: sliding face, rounding, side. From the dish's centre: out, down [m].
std::vector<Eigen::Vector2d> outline(const Bearing &b) {
  const double R = b.surface.R0, radius = b.slider.diameter / 2, e = b.slider.edge_radius, middle = radius - e,
               begins = std::asin(middle / (R - e)), depth = (R - e) * std::cos(begins); // tangent to the face
  std::vector<Eigen::Vector2d> points;
  constexpr int n = 20000;
  for (int i = 0; i <= n; ++i) {
    const double x = R * std::sin(begins) * i / n, angle = (std::numbers::pi / 2 - begins) * i / n;
    points.emplace_back(x, std::sqrt(R * R - x * x));
    points.emplace_back(middle + e * std::cos(angle), depth + e * std::sin(angle));
    points.emplace_back(radius, depth - 0.02 * i / n);
  }
  return points;
}

/// Farthest from the bearing's axis, of a slider tilted by theta about the dish's centre.
double reach(const std::vector<Eigen::Vector2d> &outline, double theta) {
  double farthest = 0;
  for (const auto &p : outline) farthest = std::max(farthest, p[0] * std::cos(theta) + p[1] * std::sin(theta));
  return farthest;
}

TEST(TwoDishes, TheEdgeMeetsTheWallAtTheCapacity) {
  for (const double edge : {0.0005, 0.002, 0.006})
    for (const double ledge : {0.0, 0.01}) {
      Bearing b = two_dishes();
      b.slider.edge_radius = edge, b.rim.ledge = ledge;
      const double C = b.lateral_capacity(), theta = tilt(b, C);
      EXPECT_NEAR(reach(outline(b), theta), b.wall_radius(), 1e-8) << edge << " " << ledge;
      EXPECT_NEAR(C, (2 * b.surface.R0 - b.slider.height) * std::sin(theta), 1e-12);
    }
  EXPECT_NEAR(two_dishes().lateral_capacity(), 0.300, 1e-5) << "the thesis's C_t";
}

/// As solids the rims of two faces of a triple pendulum are touched where its rigid bodies touch them.
TEST(TwoDishes, TheStopsOfATriplePendulumAreTouchedAtItsFacesTravel) {
  const auto faces = triple_faces(builtin_isolator("tfp-kim-2023"));
  for (const auto &[name, face] : {std::pair{"tfp-kim-2023-outer", faces[0]}, {"tfp-kim-2023-inner", faces[1]}}) {
    const Bearing b = builtin_bearing(name);
    EXPECT_NEAR(b.lateral_capacity(), 2 * face.effective_radius() * face.travel / face.radius, 3e-6) << name;
    EXPECT_NEAR(reach(outline(b), face.tilt()), b.wall_radius(), 1e-6) << name;
    EXPECT_EQ(b.assumed.keys.count("surface.R0_m"), 1u) << name;
    EXPECT_EQ(b.assumed.keys.count("rim.thickness_mm"), 1u) << name;
  }
  const Bearing inner = builtin_bearing("tfp-kim-2023-inner");
  EXPECT_LT(inner.wall_radius() + inner.rim.thickness, builtin_isolator("tfp-kim-2023").slider_diameter / 2);
}

TEST(TwoDishes, RimsThatLieInOneAnotherAtRestAreRefused) {
  Bearing b = two_dishes();
  b.rim.height = 0.0205;
  EXPECT_NO_THROW(b.validate_rim());
  b.rim.height = 0.022;
  expect_error<InputError>([&] { b.validate_rim(); },
                           {"rim.height_mm 22 mm", "in one another by 3.95 mm", "103.95 mm or more"});
  b.slider.height = 0.104;
  EXPECT_NO_THROW(b.validate_rim());
}

TEST(TwoDishes, ASharpEdgeGivesTheRigidModelsRim) {
  Bearing b = two_dishes();
  b.slider.edge_radius = 1e-9;
  Isolator rigid;
  rigid.radius = b.surface.R0, rigid.slider_diameter = b.slider.diameter;
  rigid.top_height = rigid.bottom_height = b.slider.height / 2;
  rigid.capacity = b.lateral_capacity();
  EXPECT_NEAR(rigid.bottom_rim_radius(), b.wall_radius(), 1e-8);
  EXPECT_NEAR(rigid.effective_radius(), b.ridden_surface().R0, 1e-12);
}

TEST(TwoDishes, TheTiltIsTheRiddenSpheresSlope) {
  const Bearing b = two_dishes();
  for (const double travel : {0.05, 0.15, 0.3})
    EXPECT_NEAR(tilt(b, travel), std::asin(travel / (2 * b.surface.R0 - b.slider.height)), 1e-12);
  // What is carried rises twice as far as the slider's middle, which turns about the dish's centre.
  const double arm = b.surface.R0 - b.slider.height / 2, theta = tilt(b, 0.3);
  EXPECT_NEAR(lift(b, 0.3), 2 * arm * (1 - std::cos(theta)), 1e-12);
}

TEST(TwoDishes, TheEdgesHeightAtTouchIsThatOfItsLowestPoint) {
  const Bearing b = two_dishes();
  const double theta = tilt(b, b.lateral_capacity()), R = b.surface.R0, e = b.slider.edge_radius;
  double lowest = 1;
  for (int i = 0; i <= 20000; ++i) { // the rounding as a whole circle: its lowest point may lie on the face's side
    const double angle = 2 * std::numbers::pi * i / 20000, out = b.slider.diameter / 2 - e + e * std::cos(angle),
                 face = b.slider.diameter / 2 - e,
                 down = std::sqrt((R - e) * (R - e) - face * face) + e * std::sin(angle);
    lowest = std::min(lowest, R - (down * std::cos(theta) - out * std::sin(theta)));
  }
  EXPECT_NEAR(edge_at_touch(b), lowest, 1e-9);
  EXPECT_GT(rim_top(b), edge_at_touch(b) + e);
}

TEST(TwoDishes, TheSlidersMassIsASumOfItsRings) {
  const Bearing b = two_dishes();
  const double R = b.surface.R0, radius = b.slider.diameter / 2;
  double volume = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double r = radius * (i + 0.5) / n, rise = R - std::sqrt(R * R - r * r);
    volume += 2 * std::numbers::pi * r * radius / n * (b.slider.height - 2 * rise);
  }
  EXPECT_NEAR(slider_mass(b) / (b.steel.density * volume), 1, 1e-6);
}

TEST(TwoDishes, AFileIsReadBackAsItWasWritten) {
  const Bearing b = two_dishes();
  const std::string text = to_toml(b);
  EXPECT_NE(text.find("concave = \"double\""), std::string::npos) << text;
  EXPECT_NE(text.find("height_mm = 100"), std::string::npos);
  for (const char *of_one_dish : {"[pad]", "[foot]", "bottom_mm", "ertalyte]"})
    EXPECT_EQ(text.find(of_one_dish), std::string::npos) << of_one_dish;
  const Scene written = load_scene("impact-window", {"bearing.name=dcfp-155"});
  EXPECT_TRUE(written.bearing == b);
  const Scene again = parse_scene(to_toml(written), "again");
  EXPECT_EQ(to_toml(again), to_toml(written));
  EXPECT_NEAR(again.lateral_capacity(), b.lateral_capacity(), 1e-9);
}

TEST(TwoDishes, ASliderOfTwoHalvesIsReadBackToo) {
  const Bearing b = builtin_bearing("lir-dcfp-155");
  EXPECT_TRUE(b.has_interface());
  const std::string text = to_toml(b);
  for (const char *key : {"mu_interface = 0.15", "interface_gap_mm = 30"})
    EXPECT_NE(text.find(key), std::string::npos) << key << " in: " << text;
  EXPECT_EQ(to_toml(two_dishes()).find("interface"), std::string::npos);
  const Scene written = load_scene("impact-window", {"bearing.name=lir-dcfp-155", "model.rung=rigid-dish"});
  EXPECT_TRUE(written.bearing == b);
  EXPECT_EQ(to_toml(parse_scene(to_toml(written), "again")), to_toml(written));
  EXPECT_FALSE(load_scene("impact-window", {"bearing.name=lir-dcfp-155", "bearing.slider.mu_interface=inf"})
                   .bearing.has_interface());
}

std::string refusal_of(const std::vector<std::string> &assignments) {
  std::vector<std::string> all{"bearing.name=dcfp-155"};
  all.insert(all.end(), assignments.begin(), assignments.end());
  try {
    load_scene("impact-window", all);
  } catch (const InputError &error) {
    return error.what();
  }
  return "";
}

TEST(TwoDishes, WhatCannotBeBuiltIsRefusedWithBothNumbers) {
  const auto names = [](const std::string &sentence, std::initializer_list<const char *> words) {
    EXPECT_FALSE(sentence.empty());
    for (const char *word : words) EXPECT_NE(sentence.find(word), std::string::npos) << word << " in: " << sentence;
  };
  names(refusal_of({"bearing.slider.height_mm=18"}), {"slider.height_mm 18 mm", "18.5"});
  names(refusal_of({"bearing.slider.height_mm=3100"}), {"slider.height_mm 3100 mm", "3100"});
  names(refusal_of({"bearing.slider.diameter_mm=620"}), {"slider.diameter_mm 620 mm", "303.35"});
  names(refusal_of({"bearing.slider.edge_radius_mm=150"}), {"slider.edge_radius_mm 150 mm"});
  names(refusal_of({"bearing.rim.height_mm=1.5"}), {"rim.height_mm 1.5 mm"});
  names(refusal_of({"bearing.slider.mu_interface=0.1", "bearing.slider.interface_gap_mm=150"}),
        {"slider.interface_gap_mm 150 mm", "150 mm"});
  EXPECT_EQ(refusal_of({"bearing.slider.mu_interface=0.1", "bearing.slider.interface_gap_mm=149"}), "");
  names(refusal_of({"bearing.surface.kind=cone"}), {"surface.concave \"double\"", "\"sphere\"", "\"cone\""});
  for (const std::string key : {"finite_pad", "socket_friction"})
    names(refusal_of({"reduced." + key + "=true"}), {("reduced." + key).c_str(), "neither pad nor socket"});
  EXPECT_EQ(refusal_of({"model.rung=rigid-dish"}), "");
  EXPECT_EQ(refusal_of({}), "");
}

TEST(TwoDishes, KeysOfTheOtherKindOfSliderAreNamed) {
  const auto remarked = [](const std::vector<std::string> &assignments) {
    std::string all;
    for (const auto &remark : load_scene("impact-window", assignments).remarks) all += remark + "\n";
    return all;
  };
  EXPECT_NE(remarked({"bearing.slider.mu_interface=0.1"}).find("bearing.slider.mu_interface is not read"),
            std::string::npos);
  EXPECT_NE(remarked({"bearing.name=lir-dcfp-155"}).find("the slider is one piece"), std::string::npos);
  EXPECT_NE(remarked({"bearing.slider.height_mm=90"}).find("bearing.slider.height_mm is not read"), std::string::npos);
  const std::string of_two =
      remarked({"bearing.name=dcfp-155", "bearing.slider.top_mm=150", "bearing.pad.thickness_mm=30",
                "bearing.foot.radius_mm=80", "bearing.material.ertalyte.E_MPa=3000"});
  for (const char *key : {"bearing.slider.top_mm", "bearing.pad.thickness_mm", "bearing.foot.radius_mm",
                          "bearing.material.ertalyte.E_MPa"})
    EXPECT_NE(of_two.find(key), std::string::npos) << key << " in: " << of_two;
}

} // namespace
