// The rim's law from a calibration folder, in the place of a scene's own.
#include "expect_error.h"
#include "scene/bearing_catalogue.h"
#include "scene/case_description.h"
#include "scene/doubts.h"
#include "scene/element_doubts.h"
#include "scene/fitted_plates.h"
#include "scene/rim_identity.h"
#include "scene/scene.h"
#include "scene/stack_terms.h"
#include "scene/toml_writer.h"
#include "temporary_folder.h"
#include <algorithm>
#include <fmt/format.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

const char *const element = R"({"lateral_capacity_m": 0.4003, "reference_speed_m_per_s": 0.5,
  "k_i": {"value": 986665.0, "unit": "kN/m"}, "yield_force": {"value": 814.07, "unit": "kN"}, "hardening": {"value": 0.0997, "unit": "-"},
  "unloading_gain": {"value": 0.15, "unit": "-"}, "hardening_exponent": {"value": 0.7, "unit": "-"},
  "unloading_exponent": {"value": 0.4, "unit": "-"}, "dent_spread": {"value": 2.5, "unit": "-"}})";

std::string answer(const std::string &law, const std::string &parameters, const std::string &belongs_to,
                   const std::string &rim) {
  return fmt::format(
      R"({{"answer": {{"bearing": "mine", "rim_identity": "{}", "mass_kg": 86952.0, "law": {{"name": "{}", "belongs_to": "{}",
    "element": {}, "fitted_from_m_s": 0.05, "fitted_to_m_s": 1.0}}}}}})",
      rim, law, belongs_to, parameters);
}

/// A folder with a calibration in `cal`.
struct Folder : TemporaryFolder {
  explicit Folder(const std::string &json) {
    std::filesystem::create_directory(*this / "cal");
    write("cal/calibration.json", json);
  }
  std::string cal() const { return "reduced.calibration=\"" + *this / "cal" + "\""; }
};

std::string thesis_rim() {
  return rim_identity(builtin_bearing("shfps-225"));
}

TEST(CalibratedElement, TakesTheAnswersLawAndNumbers) {
  const Folder folder(answer("elastoplastic", element, "rim", thesis_rim()));
  const auto path =
      folder.write("scene.toml", "[excitation]\nkind = 'window'\n[reduced]\ncalibration = 'cal'\nmu_fast = 0.05\n");
  const Scene s = load_scene(path);
  EXPECT_EQ(s.reduced.impact_law->name, "elastoplastic");
  EXPECT_DOUBLE_EQ(s.reduced.k_i, 986665e3);
  EXPECT_DOUBLE_EQ(s.reduced.yield_force, 814.07e3);
  EXPECT_DOUBLE_EQ(s.reduced.unloading_exponent, 0.4);
  EXPECT_NEAR(s.reduced.capacity_offset, 0.3e-3, 1e-12);
  EXPECT_EQ(s.reduced.fitted_from, 0.05);
  EXPECT_EQ(s.reduced.fitted_to, 1.0);
  EXPECT_FALSE(s.reduced.fitted_mass.has_value());
  EXPECT_EQ(s.reduced.fitted_rim, thesis_rim());
  EXPECT_EQ(s.reduced.calibration, folder / "cal");
  EXPECT_TRUE(doubts_of_element(s).empty());
}

/// Where the joint at the rim's foot goes comes with the law, and goes with it.
TEST(CalibratedElement, BringsWhereTheRimsFootGoes) {
  std::string json = answer("elastoplastic", element, "rim", thesis_rim());
  json.insert(json.size() - 2, R"(, "rim_foot": {"joint": "welds", "goes_at_force_kN": 812.5})");
  const Folder folder(json);
  const Scene s = load_scene("impact-window", {folder.cal()});
  EXPECT_EQ(s.reduced.foot_joint, "welds");
  EXPECT_DOUBLE_EQ(*s.reduced.foot_force, 812.5e3);
  const Scene again = parse_scene(to_toml(s), "again.toml");
  EXPECT_EQ(again.reduced.foot_joint, "welds");
  EXPECT_DOUBLE_EQ(*again.reduced.foot_force, 812.5e3);
  const Scene own = load_scene("impact-window", {folder.cal(), "reduced.k_i_kN_per_m=1e5"});
  EXPECT_TRUE(own.reduced.foot_joint.empty() && !own.reduced.foot_force) << "another law's numbers";
}

std::string with_stack(std::string json) {
  const std::string stack =
      R"({"answer": {"stack": {"finite_pad": true, "socket_friction": true, "friction": "park-wen",
    "elastic_slip_mm": 0.14, "elastic_slip_from": "bearing"}, )";
  return json.replace(0, std::string(R"({"answer": {)").size(), stack);
}

/// Pad and socket come with the law of a bearing that has them.
TEST(CalibratedElement, BringsPadAndSocket) {
  const Folder folder(with_stack(answer("elastoplastic", element, "rim", thesis_rim())));
  const Scene s = load_scene("ricker-0.78g-1.0s", {folder.cal()});
  EXPECT_TRUE(s.reduced.finite_pad && s.reduced.socket_friction);
  EXPECT_EQ(s.reduced.friction, Friction::park_wen);
  EXPECT_DOUBLE_EQ(s.reduced.elastic_slip, pad_elastic_slip(s.bearing, s.load.vertical, s.reduced.mu_fast));
  EXPECT_NEAR(s.reduced.elastic_slip, 0.14e-3, 0.5e-5);
  const Scene heavier = load_scene("ricker-0.78g-1.0s", {folder.cal(), "load.mass_kg=173904", "load.vertical_kN=1706"});
  EXPECT_NEAR(heavier.reduced.elastic_slip, 2 * s.reduced.elastic_slip, 1e-9);
  const Scene typed =
      load_scene("ricker-0.78g-1.0s", {folder.cal(), "reduced.finite_pad=false", "reduced.elastic_slip_mm=0.3"});
  EXPECT_FALSE(typed.reduced.finite_pad);
  EXPECT_TRUE(typed.reduced.socket_friction);
  EXPECT_DOUBLE_EQ(typed.reduced.elastic_slip, 0.3e-3);
  const auto own = folder.write("own.toml", "[reduced]\ncalibration = 'cal'\nfriction = 'coulomb'\n");
  EXPECT_EQ(load_scene(own).reduced.friction, Friction::coulomb) << "what the file says beside it stays";
  const auto before = folder.write("before.toml", "[reduced]\nfriction = 'coulomb'\nfinite_pad = false\n");
  const Scene replaced = load_scene(before, {folder.cal()});
  EXPECT_TRUE(replaced.reduced.finite_pad);
  EXPECT_EQ(replaced.reduced.friction, Friction::park_wen);
  const auto told = [&](const char *words) {
    return std::any_of(replaced.remarks.begin(), replaced.remarks.end(),
                       [&](const std::string &remark) { return remark.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(told("in place of the scene's own finite_pad, friction")) << replaced.remarks.front();
  const Scene odd = load_scene("ricker-0.78g-1.0s", {folder.cal(), "bearing.pad.outer_radius_mm=400"});
  EXPECT_FALSE(odd.reduced.finite_pad);
  ASSERT_FALSE(odd.remarks.empty());
  EXPECT_NE(odd.remarks.back().find("socket's friction are left out"), std::string::npos) << odd.remarks.back();
  const Scene between = load_scene("ricker-0.78g-1.0s", {folder.cal(), "bearing.name=dcfp-155"});
  EXPECT_FALSE(between.reduced.finite_pad || between.reduced.socket_friction);
  EXPECT_TRUE(std::any_of(between.remarks.begin(), between.remarks.end(), [](const std::string &remark) {
    return remark.find("left out: a slider between two dishes has neither") != std::string::npos;
  }));
}

/// Of a triple pendulum the law of its plates' rims and another one of its inner rims, each of one rim.
TEST(CalibratedElement, InnerRimsTakeACalibrationOfTheirOwn) {
  std::string json = answer("elastoplastic", element, "rim", "");
  json.insert(json.size() - 2, R"(, "rims_in_series": 2)");
  const Folder folder(json);
  const std::string inner = "isolator.inner.rims.calibration=\"" + folder / "cal" + "\"";
  const Scene s = load_scene("tfp-pulse", {inner});
  EXPECT_TRUE(s.isolator.inner.own_rims);
  const ImpactElement &rims = s.inner_element();
  EXPECT_EQ(rims.impact_law->name, "elastoplastic");
  EXPECT_DOUBLE_EQ(rims.k_i, 2 * 986665e3);
  EXPECT_EQ(rims.calibration, folder / "cal");
  EXPECT_EQ(rims.fitted_to, 1.0);
  EXPECT_EQ(s.reduced.impact_law->name, "hunt-crossley") << "that of the plates' rims stays";
  EXPECT_NE(describe_case(s).find("of the inner rims: elastoplastic, k_i = 1.97333e+06 kN/m"), std::string::npos)
      << describe_case(s);
  const Scene again = parse_scene(to_toml(s), "again.toml");
  EXPECT_EQ(again.isolator, s.isolator);
  const Scene both = load_scene("tfp-pulse", {folder.cal(), inner});
  EXPECT_EQ(both.reduced.k_i, both.inner_element().k_i);
  const Scene typed = load_scene("tfp-pulse", {inner, "isolator.inner.rims.k_i_kN_per_m=1e5"});
  EXPECT_DOUBLE_EQ(typed.inner_element().k_i, 1e8);
  EXPECT_TRUE(typed.inner_element().calibration.empty() && !typed.inner_element().fitted_to);
  EXPECT_NE(typed.remarks.back().find("isolator.inner.rims.k_i_kN_per_m is given beside"), std::string::npos)
      << typed.remarks.back();
  const Scene off = load_scene("tfp-pulse", {inner, "isolator.inner.own_rims=false"});
  EXPECT_EQ(&off.inner_element(), &off.reduced);
  expect_error<InputError>([&] { load_scene("lir-dcfp-stages", {inner}); },
                           {"reduced.model \"tfp\", not \"lir-dcfp\""});
  expect_error<InputError>(
      [&] {
        load_scene("tfp-pulse", {"isolator.inner.own_rims=true", "isolator.inner.rims.impact_law=curve",
                                 "isolator.inner.rims.k_i_kN_per_m=1e5"});
      },
      {"isolator.inner.rims.impact_law \"curve\""});
  expect_error<InputError>([] { load_scene("tfp-pulse", {"isolator.inner.own_rims=true"}); },
                           {"isolator.inner.own_rims needs isolator.inner.rims.k_i_kN_per_m"});
  const std::string file = "[reduced]\nmodel = 'tfp'\n[isolator.inner]\nown_rims = false\n";
  const auto apart = folder.write("apart.toml", file + "[isolator.inner.rims]\ncalibration = 'cal'\n");
  expect_error<InputError>([&] { load_scene(apart); }, {"own_rims = false stands beside", "strike one of the two"});
  EXPECT_TRUE(load_scene(folder.write("typed.toml", file), {inner}).isolator.inner.own_rims) << "what is typed wins";
  const Scene signed_law =
      load_scene("tfp-pulse", {"isolator.inner.own_rims=true", "isolator.inner.rims.k_i_kN_per_m=1e5",
                               "isolator.inner.rims.yield_force_kN=500"});
  EXPECT_NE(signed_law.remarks.back().find("isolator.inner.rims.impact_law \"signed\""), std::string::npos)
      << signed_law.remarks.back();
  const Scene alone = load_scene("tfp-pulse", {"isolator.inner.rims.k_i_kN_per_m=1e5"});
  EXPECT_NE(alone.remarks.back().find("isolator.inner.rims.k_i_kN_per_m is not read"), std::string::npos);
}

TEST(CalibratedElement, AResolvedSceneNeedsTheFolderNoMore) {
  std::string resolved;
  Scene s;
  {
    const Folder folder(answer("elastoplastic", element, "rim", thesis_rim()));
    s = load_scene("impact-window", {folder.cal()});
    resolved = to_toml(s);
    EXPECT_NE(resolved.find("taken_from = "), std::string::npos);
    EXPECT_EQ(resolved.find("\ncalibration = "), std::string::npos);
  }
  const Scene again = parse_scene(resolved, "scene.toml");
  EXPECT_EQ(to_toml(again), resolved);
  EXPECT_EQ(again.reduced.k_i, s.reduced.k_i);
}

TEST(CalibratedElement, AnElementsKeyInTheSameFileIsRefused) {
  const Folder folder(answer("signed", R"({"k_i": {"value": 3e5, "unit": "kN/m"}, "e": {"value": 0.5, "unit": "-"}})",
                             "mass", thesis_rim()));
  const auto path = folder.write("scene.toml", "[reduced]\ncalibration = 'cal'\nk_i_kN_per_m = 4e5\n");
  expect_error<InputError>([&] { load_scene(path); },
                           {"scene.toml:3:", "reduced.k_i_kN_per_m", "scene.toml:2:", "reduced.calibration"});
}

TEST(CalibratedElement, WhatIsTypedWins) {
  const Folder folder(answer("signed", R"({"k_i": {"value": 3e5, "unit": "kN/m"}, "e": {"value": 0.5, "unit": "-"}})",
                             "mass", thesis_rim()));
  for (const auto &overrides : {std::vector<std::string>{folder.cal(), "reduced.k_i_kN_per_m=4e5"},
                                {"reduced.k_i_kN_per_m=4e5", folder.cal()}}) {
    const Scene s = load_scene("impact-window", overrides);
    EXPECT_DOUBLE_EQ(s.reduced.k_i, 4e8);
    EXPECT_DOUBLE_EQ(s.reduced.restitution, 0.5);
    EXPECT_FALSE(s.reduced.fitted_from || s.reduced.fitted_mass) << "no longer the fitted element";
    ASSERT_EQ(s.remarks.size(), 1u);
    EXPECT_NE(s.remarks[0].find("reduced.k_i_kN_per_m is given beside the calibration"), std::string::npos)
        << s.remarks[0];
  }
  const auto path = folder.write("own.toml", "[excitation]\nkind = 'window'\n[reduced]\nk_i_kN_per_m = 4e5\nimpact_law "
                                             "= 'hunt-crossley'\nimpact_exponent = 1.2\n");
  const Scene s = load_scene(path, {folder.cal()}); // the command line is above the file
  EXPECT_DOUBLE_EQ(s.reduced.k_i, 3e8);
  EXPECT_EQ(s.reduced.impact_law->name, "signed");
  EXPECT_DOUBLE_EQ(s.reduced.impact_exponent, ReducedSettings{}.impact_exponent);
  ASSERT_EQ(s.remarks.size(), 1u);
  EXPECT_NE(s.remarks[0].find("take the place of the scene's own"), std::string::npos) << s.remarks[0];
  const Scene changed =
      parse_scene(to_toml(load_scene("impact-window", {folder.cal()})), "resolved.toml", {"reduced.restitution=0.6"});
  EXPECT_TRUE(changed.reduced.calibration.empty() && !changed.reduced.fitted_to) << "a replay changed by hand";
}

TEST(CalibratedElement, AnotherRimOrMassIsDoubted) {
  const std::string pair =
      R"({"lateral_capacity_m": 0.5, "k_i": {"value": 3e5, "unit": "kN/m"}, "e": {"value": 0.5, "unit": "-"}})";
  const Folder folder(answer("no-tension", pair, "mass", "0123456789abcdef"));
  const Scene other = load_scene("impact-window", {folder.cal(), "load.mass_kg=88000", "load.vertical_kN=853"});
  EXPECT_EQ(other.reduced.capacity_offset, 0) << "where another rim's element began says nothing of this one";
  auto sentences = doubts_of_element(other);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_NE(sentences[0].find("fitted to another rim: "), std::string::npos) << sentences[0];
  EXPECT_EQ(sentences[0].find("0123456789abcdef"), std::string::npos) << "a code tells a reader nothing";
  EXPECT_NE(sentences[1].find("86952 kg they were fitted with"), std::string::npos) << sentences[1];
  EXPECT_EQ(doubts_of_element(load_scene("impact-window", {folder.cal(), "load.mass_kg=87500", "load.vertical_kN=853"}))
                .size(),
            1u);
}

/// As a calibration of two dishes writes it.
std::string of_two_rims(const std::string &law, const std::string &numbers) {
  std::string json = answer(law, numbers, "rim", "");
  json.insert(json.find("\"bearing\""), "\"rims_in_series\": 2, ");
  return json;
}

TEST(CalibratedElement, OfTwoRimsInSeriesARigidBodyModelTakesOne) {
  const Folder folder(of_two_rims("elastoplastic", element));
  const Scene both = load_scene("impact-window", {folder.cal(), "bearing.name=dcfp-155"});
  EXPECT_DOUBLE_EQ(both.reduced.k_i, 986665e3);
  const Scene one = load_scene("lir-dcfp-specimen", {folder.cal(), "reduced.model=dcfp"});
  EXPECT_DOUBLE_EQ(one.reduced.k_i, 2 * 986665e3);
  EXPECT_DOUBLE_EQ(one.reduced.yield_force, 814.07e3);
  // The same force, each rim pressed half as deep.
  const auto pair = both.reduced.element(1e5), rim = one.reduced.element(1e5);
  EXPECT_NEAR(rim.trial({.d = 3e-3, .rate = 0.1, .deepest = 2e-3}) /
                  pair.trial({.d = 6e-3, .rate = 0.2, .deepest = 4e-3}),
              1, 1e-12);
}

/// The rims of the specimen's [isolator] as a bearing of [bearing] says them, but for its radius [m].
std::string between_its_plates(double radius) {
  std::string json = of_two_rims("elastoplastic", element);
  json.insert(json.find("\"bearing\""),
              fmt::format(R"("plates": {{"radius_m": {}, "slider_height_mm": 85.02, "slider_diameter_mm": 140,
    "rim_height_mm": 20, "lateral_capacity_m": 0.1752}}, )",
                          radius));
  return json;
}

bool doubts_the_plates(const Scene &scene) {
  for (const auto &doubt : doubts_of_element(scene))
    if (doubt.find("between other plates") != std::string::npos) return true;
  return false;
}

TEST(CalibratedElement, OfARigidBodyModelsRimIsDoubtedBetweenOtherPlates) {
  const Folder its(between_its_plates(0.75)), other(between_its_plates(0.8));
  EXPECT_FALSE(doubts_the_plates(load_scene("lir-dcfp-specimen", {its.cal()}))) << "0.02 and 0.2 mm are rounding";
  for (const std::string set :
       {"isolator.radius_m=0.76", "isolator.top_radius_m=0.7", "isolator.slider_diameter_mm=142",
        "isolator.rim_height_mm=15", "isolator.capacity_m=0.173", "isolator.top_capacity_m=0.165"}) {
    const Scene apart = load_scene("lir-dcfp-specimen", {its.cal(), set});
    EXPECT_TRUE(doubts_the_plates(apart)) << set;
    EXPECT_NE(doubts_of_element(apart).front().find(set.substr(0, set.find('='))), std::string::npos) << set;
  }
  EXPECT_TRUE(doubts_the_plates(load_scene("lir-dcfp-specimen", {its.cal(), "isolator.bottom_height_mm=38"})));
  const Scene scene = load_scene("lir-dcfp-specimen", {other.cal()});
  EXPECT_TRUE(doubts_the_plates(scene));
  const std::string text = doubts_of_element(scene).front();
  EXPECT_NE(text.find("isolator.radius_m 0.75 (0.8 there);"), std::string::npos) << text;
  EXPECT_TRUE(doubts_the_plates(parse_scene(to_toml(scene), "again"))) << "a run's own file keeps it";
  EXPECT_FALSE(doubts_the_plates(load_scene("tfp-pulse", {other.cal()}))) << "its rims are of other faces";
  EXPECT_FALSE(doubts_the_plates(load_scene("lir-dcfp-specimen", {other.cal(), "reduced.k_i_kN_per_m=5e5"})))
      << "an element changed by hand is of no calibration";
}

TEST(CalibratedElement, PlatesOutOfRangeAreAnErrorOfTheFile) {
  const Folder folder(between_its_plates(-1));
  expect_error<DataError>([&] { load_scene("lir-dcfp-specimen", {folder.cal()}); }, {"fitted_radius_m", "-1"});
}

TEST(FittedPlates, OfTheCataloguesBearingAreTheIsolatorsThatItIs) {
  const Bearing bearing = builtin_bearing("dcfp-155");
  scene::Isolator same;
  same.radius = bearing.surface.R0, same.slider_diameter = bearing.slider.diameter;
  same.bottom_height = 0.4 * bearing.slider.height, same.top_height = 0.6 * bearing.slider.height;
  same.rim_height = bearing.rim.height, same.capacity = bearing.lateral_capacity();
  EXPECT_EQ(plate_differences(plates_of(bearing), same), "");
}

TEST(CalibratedElement, ALawThatOneRimHasNotIsRefused) {
  const Folder folder(
      of_two_rims("hunt-crossley", R"({"reference_speed_m_per_s": 0.5, "k_i": {"value": 9e5, "unit": "kN/m"},
    "e": {"value": 0.5, "unit": "-"}, "exponent": {"value": 1.5, "unit": "-"}})"));
  expect_error<InputError>([&] { load_scene("lir-dcfp-specimen", {folder.cal()}); },
                           {"two rims in series", "hunt-crossley"});
}

TEST(CalibratedElement, WithoutAnAnswerTheFragmentIsRead) {
  const Folder folder("{\"parameters\": {}}");
  folder.write("cal/calibration.toml", "# fitted\n[reduced]\nmodel = \"physical\"\nk_i_kN_per_m = 2.5e5\nrestitution = "
                                       "0.4\nimpact_law = \"no-tension\"\nmu_fast = 0.5\n");
  const Scene s = load_scene("impact-window", {folder.cal()});
  EXPECT_DOUBLE_EQ(s.reduced.k_i, 2.5e8);
  EXPECT_EQ(s.reduced.impact_law->name, "no-tension");
  EXPECT_DOUBLE_EQ(s.reduced.mu_fast, 0.07) << "no part of the element";
}

TEST(CalibratedElement, RefusesWhatCannotBeRead) {
  const auto refuse = [](const std::string &json, std::initializer_list<const char *> words) {
    SCOPED_TRACE(json);
    const Folder folder(json);
    expect_error<DataError>([&] { load_scene("impact-window", {folder.cal()}); }, words);
  };
  const std::string e = R"("e": {"value": 0.5, "unit": "-"})", k = R"("k_i": {"value": 3e5, "unit": "kN/m"})";
  refuse("{", {"calibration.json", "JSON"});
  refuse("{}", {"calibration.toml", "no such file"});
  refuse(R"({"answer": 3})", {"calibration.json: answer is not a JSON object"});
  refuse(answer("signed", "{" + e + "}", "rim", ""), {"law signed without k_i_kN_per_m"});
  refuse(answer("elastoplastic", "{" + k + "}", "rim", ""), {"elastoplastic without yield_force_kN"});
  refuse(answer("signed", R"({"k_i": {"value": 3e8, "unit": "N/m"},)" + e + "}", "rim", ""),
         {"calibration.json: answer.law.element.k_i.unit is \"N/m\", not \"kN/m\""});
  refuse(answer("signed", R"({"k_i": {"value": "3e5", "unit": "kN/m"},)" + e + "}", "rim", ""),
         {"answer.law.element.k_i.value is not a number"});
  refuse(answer("signed", R"({"k_j": {"value": 3e5, "unit": "kN/m"},)" + e + "}", "rim", ""),
         {"answer.law.element.k_j is no parameter that this version knows"});
  refuse(answer("signd", "{" + k + "," + e + "}", "rim", ""), {"did you mean \"signed\""});
  refuse(answer("signed", "{" + k + R"(, "e": {"value": 1.5, "unit": "-"}})", "rim", ""), {"restitution 1.5", "<= 1"});
  expect_error<DataError>([] { load_scene("impact-window", {"reduced.calibration=/nowhere"}); },
                          {"/nowhere/calibration.json", "no such file"});
  expect_error<InputError>([] { load_scene("impact-window", {"reduced.calibration=3"}); },
                           {"reduced.calibration", "must be a string"});
}

TEST(CalibratedElement, AChangedFolderIsReadAgain) {
  const Folder folder(
      answer("signed", R"({"k_i": {"value": 3e5, "unit": "kN/m"}, "e": {"value": 0.5, "unit": "-"}})", "rim", ""));
  EXPECT_DOUBLE_EQ(load_scene("impact-window", {folder.cal()}).reduced.k_i, 3e8);
  folder.write(
      "cal/calibration.json",
      answer("signed", R"({"k_i": {"value": 2e5, "unit": "kN/m"}, "e": {"value": 0.5, "unit": "-"}})", "rim", ""));
  std::filesystem::last_write_time(folder / "cal/calibration.json",
                                   std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2));
  EXPECT_DOUBLE_EQ(load_scene("impact-window", {folder.cal()}).reduced.k_i, 2e8);
}

} // namespace
