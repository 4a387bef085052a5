#include "expect_error.h"
#include "scene/bearing.h"
#include "scene/bearing_catalogue.h"
#include "scene/scene.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

TEST(Bearing, DefaultIsTheThesisDevice) {
  const Bearing b;
  EXPECT_DOUBLE_EQ(b.lateral_capacity(), 0.400);
  EXPECT_NEAR(853e3 / b.pad_area(), 60e6, 0.05e6);
  EXPECT_NEAR(b.slider.bottom + lift(b, b.lateral_capacity()), 0.100, 1e-5);
  EXPECT_NEAR(tilt(b, 0.42) * 180 / M_PI, 15.6, 0.1);
  EXPECT_NEAR(std::tan(tilt(b, 0.40)), 0.253, 5e-4);
}

TEST(Bearing, BuiltInsAreBuildable) {
  for (const auto &name : builtin_bearing_names()) {
    const Bearing b = builtin_bearing(name);
    EXPECT_EQ(b.name, name);
    EXPECT_NO_THROW(b.double_concave() ? b.validate_rim() : b.validate());
    if (name.find("-225") != std::string::npos) {
      EXPECT_DOUBLE_EQ(b.lateral_capacity(), 0.400) << name;
    }
  }
  expect_error<InputError>([] { builtin_bearing("shfps225"); }, {"shfps225", "did you mean \"shfps-225\""});
}

/// The reading of the thesis's bearing whose stack meets the rim under Sylmar x 0.86: the pad's radius is the least
/// that 853 kN at 60 MPa leave, the cap passes close above its seat, the pad is shaped to the dish at the capacity; all
/// else is shfps-225's.
TEST(Bearing, ASecondReadingHasTheShortestArmThatThePadLeaves) {
  const Bearing given = builtin_bearing("shfps-225");
  Bearing b = builtin_bearing("shfps-225-b");
  EXPECT_NEAR(b.pad.outer_radius, std::sqrt(853e3 / 60e6 / M_PI), 1e-5);
  EXPECT_LT(b.foot.cap_radius, 1.05 * b.pad.outer_radius);
  const double a = b.surface.a, z0 = a * a / b.surface.R0, u = 1 - std::pow(b.lateral_capacity() / a, 2),
               slope = z0 * b.lateral_capacity() / (a * a * std::sqrt(u)), curvature = z0 / (a * a) * std::pow(u, -1.5);
  EXPECT_NEAR(b.pad.shape_radius, std::pow(1 + slope * slope, 1.5) / curvature, 5e-4);
  b.name = given.name, b.pad = given.pad, b.foot = given.foot;
  EXPECT_EQ(b, given);
}

/// Appendix A: the dish the test had, half the travel of 180 mm, 60 MPa on the pad's ring.
TEST(Bearing, AppendixAIsOneOfTwoDishes) {
  const Bearing b = builtin_bearing("shfps-appendix-a");
  EXPECT_NEAR(make_surface(b.surface)->at(0.09, 0).z, 0.0432 * (1 - std::sqrt(1 - 0.25)), 1e-12);
  EXPECT_GT(b.lateral_capacity(), 0.090);
  EXPECT_NEAR(90e3 / b.pad_area(), 60e6, 0.5e6);
}

/// A scene is checked for what its model uses: the dish under a superstructure or on a slow path, nothing of [bearing]
/// where the isolator has two dishes; a bearing with a rim too low for its slider is refused wherever that is pressed.
TEST(Bearing, OnlyWhatTheModelUsesIsChecked) {
  const std::vector<std::string> low_rim{"bearing.rim.height_mm=5"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), low_rim.begin(), low_rim.end());
    return more;
  };
  EXPECT_THROW(load_scene("ricker-0.78g-1.0s", low_rim), InputError);
  EXPECT_THROW(load_scene("static-unidirectional", low_rim), InputError);
  EXPECT_NO_THROW(load_scene("static-unidirectional", with({"model.rung=\"rim\""})));
  EXPECT_NO_THROW(load_scene("frame-four-dof", low_rim));
  EXPECT_THROW(load_scene("frame-four-dof", with({"reduced.finite_pad=true"})), InputError);
  EXPECT_NO_THROW(load_scene("lir-dcfp-stages", low_rim));
  EXPECT_THROW(load_scene("frame-four-dof", {"bearing.surface.planar_radius_mm=600"}), InputError);
  EXPECT_NO_THROW(load_scene("lir-dcfp-stages", {"bearing.surface.planar_radius_mm=600"}));
}

struct Refused {
  const char *what;
  void (*change)(Bearing &);
  std::initializer_list<const char *> words;
};
const double nan_value = std::numeric_limits<double>::quiet_NaN();

const Refused refused[] = {
    {"negative radius", [](Bearing &b) { b.surface.R0 = -2.25; }, {"surface.R0_m", "-2.25", "> 0"}},
    {"zero height", [](Bearing &b) { b.rim.height = 0; }, {"rim.height_mm", "> 0"}},
    {"NaN", [](Bearing &b) { b.foot.radius = nan_value; }, {"foot.radius_mm", "nan"}},
    {"infinite", [](Bearing &b) { b.plate.base = INFINITY; }, {"plate.base_mm", "inf"}},
    {"low rim", [](Bearing &b) { b.rim.height = 0.005; }, {"rim.height_mm 5 mm", "92", "100"}},
    {"rim at the rounding", [](Bearing &b) { b.rim.height = 0.0141; }, {"rim.height_mm", "rounded edge"}},
    {"beyond the ellipse", [](Bearing &b) { b.surface.planar_radius = 0.6; }, {"600", "562.5", "planar_radius_mm"}},
    {"beyond the sphere",
     [](Bearing &b) { b.surface = {.kind = SurfaceKind::sphere, .R0 = 0.5, .a = 0.5, .planar_radius = 0.6}; },
     {"600", "500", "sphere"}},
    {"beyond the table",
     [](Bearing &b) {
       b.surface.kind = SurfaceKind::table;
       b.surface.table_radius = {0, 0.1, 0.3, 0.5}, b.surface.table_height = {0, 0.002, 0.02, 0.06};
     },
     {"surface.planar_radius_mm 520", "table", "500"}},
    {"falling polynomial",
     [](Bearing &b) {
       b.surface.kind = SurfaceKind::polynomial, b.surface.coefficients = {0.2, 0, -0.5, 0, 0};
     },
     {"surface.planar_radius_mm", "448.5", "polynomial", "rises outwards"}},
    {"steep cone",
     [](Bearing &b) { b.surface.kind = SurfaceKind::cone, b.surface.slope = 1.5; },
     {"surface.slope", "1.5"}},
    {"no capacity", [](Bearing &b) { b.slider.diameter = 1.1; }, {"1100", "520", "L_c = -30"}},
    {"wide foot", [](Bearing &b) { b.foot.radius = 0.090; }, {"foot.radius_mm 90", "cap_radius_mm 90"}},
    {"foot inside its cap", [](Bearing &b) { b.foot.radius = 0.080; }, {"foot.radius_mm 80", "83.7"}},
    {"socket wider than the slider", [](Bearing &b) { b.slider.diameter = 0.13; }, {"slider.diameter_mm 130", "137"}},
    {"apex through the top", [](Bearing &b) { b.slider.top = 0.085; }, {"slider.top_mm 85", "90"}},
    {"upside down", [](Bearing &b) { b.slider.top = 0.05; }, {"slider.top_mm 50", "58.25"}},
    {"no socket", [](Bearing &b) { b.slider.bottom = 0.095; }, {"cap_radius_mm 90", "95"}},
    {"edge radius", [](Bearing &b) { b.slider.edge_radius = 0.06; }, {"slider.edge_radius_mm 60", "51.3"}},
    {"pad wider than foot", [](Bearing &b) { b.pad.outer_radius = 0.0861; }, {"86.1", "86", "wider"}},
    {"pad inside out", [](Bearing &b) { b.pad.inner_radius = 0.08; }, {"80", "70.19"}},
    {"recess through the pad", [](Bearing &b) { b.pad.recess = 0.040; }, {"recess_mm 40", "thickness_mm 40"}},
    {"pad off the vertex", [](Bearing &b) { b.foot.bottom = 0.021; }, {"foot.bottom_mm 21", "20"}},
    {"seat through the cap",
     [](Bearing &b) { b.pad.thickness = 0.06, b.pad.recess = 0.04; },
     {"recess_mm 40", "92.3", "90"}},
    {"pad face", [](Bearing &b) { b.pad.shape_radius = 0.07; }, {"shape_radius_mm 70", "70.19"}},
    {"slider in the dish", [](Bearing &b) { b.slider.bottom = 0.035, b.foot.shoulder = 0.0345; }, {"meets the"}},
    {"shoulder in the slider", [](Bearing &b) { b.foot.shoulder = 0.045; }, {"foot.shoulder_mm 45", "deg", "58.25"}},
    {"foot in the dish",
     [](Bearing &b) {
       b.pad.thickness = 0.026, b.pad.recess = 0.0245, b.foot.bottom = 0.0015, b.pad.shape_radius = 10;
     },
     {"foot.bottom_mm 1.5", "dish"}},
    {"pad over the edge",
     [](Bearing &b) {
       b.slider.diameter = 0.15, b.foot.shoulder = 0.028, b.slider.edge_radius = 0.001, b.rim.ledge = 0.03;
     },
     {"past the dish's edge"}},
    {"nu", [](Bearing &b) { b.ertalyte.nu = 0.5; }, {"material.ertalyte.nu", "0.5"}},
    {"E", [](Bearing &b) { b.steel.E = 0; }, {"material.steel.E_MPa", "> 0"}},
    {"negative tangent", [](Bearing &b) { b.steel.tangent_modulus = -1e6; }, {"tangent_modulus_MPa", "-1", ">= 0"}},
    {"steep tangent", [](Bearing &b) { b.steel.tangent_modulus = 200e9; }, {"tangent_modulus_MPa 200000", "below"}},
    {"tangent without yield", [](Bearing &b) { b.steel.yield.reset(); }, {"tangent_modulus_MPa", "yield_MPa"}},
    {"friction", [](Bearing &b) { b.contact.steel_steel = -0.1; }, {"contact.steel_steel", "-0.1"}},
    {"friction at rest",
     [](Bearing &b) { b.contact.rim_slow = 0.2, b.contact.rate = 20; },
     {"contact.rim_slow 0.2 exceeds contact.rim 0"}},
    {"friction over speed without a rate",
     [](Bearing &b) { b.contact.steel_ertalyte_slow = 0.04; },
     {"contact.rate_s_per_m 0 must be > 0", "steel_ertalyte_slow 0.04"}},
};

TEST(Bearing, RefusesWhatCannotBeBuilt) {
  for (const auto &entry : refused) {
    SCOPED_TRACE(entry.what);
    Bearing b;
    entry.change(b);
    expect_error<InputError>([&] { b.validate(); }, entry.words);
  }
}

TEST(Bearing, LeavesRoomForStudies) {
  for (const double height : {0.02, 0.04, 0.08, 0.12}) {
    Bearing b;
    b.rim.height = height;
    EXPECT_NO_THROW(b.validate()) << height;
  }
  for (const double diameter : {0.20, 0.22, 0.26, 0.28}) {
    Bearing b;
    b.slider.diameter = diameter;
    EXPECT_NO_THROW(b.validate()) << diameter;
  }
  Bearing elastic;
  elastic.steel.yield.reset(), elastic.steel.tangent_modulus.reset();
  EXPECT_NO_THROW(elastic.validate());
  Bearing perfect;
  perfect.steel.tangent_modulus = 0.0;
  EXPECT_NO_THROW(perfect.validate());
}

/// A rim of one's own without a word of pad and foot.
TEST(Bearing, RungRimNeedsNoPadAndFoot) {
  Bearing b;
  b.foot.radius = 0.095, b.pad.outer_radius = 0.5, b.foot.shoulder = 0.2;
  EXPECT_THROW(b.validate(), InputError);
  EXPECT_NO_THROW(b.validate_rim());
  b.rim.height = 0.005;
  expect_error<InputError>([&] { b.validate_rim(); }, {"rim.height_mm 5 mm"});
}

TEST(Bearing, AFootAsWideAsItsCapIsNoneTooNarrow) {
  Bearing b;
  b.foot.cap_radius = 0.130, b.foot.shoulder = 0.050,
  b.foot.radius = 0.120; // a triangle of whole numbers, but for rounding
  b.slider.bottom = 0.100, b.slider.top = 0.220, b.slider.diameter = 0.3;
  try {
    b.validate();
  } catch (const InputError &error) {
    EXPECT_EQ(std::string(error.what()).find("narrower than its cap"), std::string::npos) << error.what();
  }
  b.foot.radius = 0.1199998;
  expect_error<InputError>([&] { b.validate(); }, {"foot.radius_mm 119.9998 mm", "its cap, 120 mm"});
}

TEST(Bearing, SlidersMassIsACylinderLessItsSocket) {
  Bearing b;
  b.foot.cap_radius = b.slider.bottom; // no socket
  EXPECT_NEAR(slider_mass(b), 7850 * M_PI * 0.12 * 0.12 * 0.1, 1e-9);
  b.foot.cap_radius = 0.090;
  double socket = 0; // slices of the sphere
  for (int i = 0; i < 1000; ++i) {
    const double z = 0.05825 + (i + 0.5) * (0.090 - 0.05825) / 1000;
    socket += M_PI * (0.09 * 0.09 - z * z) * (0.090 - 0.05825) / 1000;
  }
  EXPECT_NEAR(slider_mass(b), 7850 * (M_PI * 0.12 * 0.12 * 0.1 - socket), 1e-4);
}

} // namespace
