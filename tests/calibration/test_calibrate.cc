#include "calibration/answer/calibration_json.h"
#include "calibration/answer/calibration_text.h"
#include "io/files/error.h"
#include "reduced_models/simulate.h"
#include "responses/run_folder.h"
#include "synthetic.h"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

nlohmann::json read_json(const std::string &path) {
  return nlohmann::json::parse(std::ifstream(path));
}

TEST(Calibrate, RunFoldersToCalibrationJson) {
  TemporaryFolder folder;
  std::vector<std::string> runs = {folder.write(ricker(1.05)), folder.write(ricker(1.1)), folder.write(window(0.1)),
                                   folder.write(window(0.5))};
  CalibrationOptions options;
  options.laws = {"no-tension", "signed"};
  options.predict = {folder.write(ricker(1.2)), folder.write(ricker(0.5))};
  const auto c = calibrate(runs, options);
  EXPECT_NO_THROW(check_gate(c));
  EXPECT_EQ(c.fitted_on, FittedOn::histories);
  EXPECT_NEAR(c.result.parameters.at("k_i").value / 3e5, 1, 1e-6);
  EXPECT_NEAR(c.result.parameters.at("e").value / 0.4, 1, 1e-6);
  write_calibration(c, folder.at("calibration"));

  EXPECT_EQ(read_json(folder.at("calibration/curves.json"))["law"], "signed"); // the law that leaves least unexplained
  const auto json = read_json(folder.at("calibration/calibration.json"));
  for (const char *key : {"value", "unit", "standard_error", "interval_95", "identifiable"})
    for (const char *name : {"k_i", "e"}) EXPECT_TRUE(json["parameters"][name].contains(key)) << name << key;
  EXPECT_EQ(json["parameters"]["k_i"]["unit"], "kN/m");
  EXPECT_TRUE(json["correlation"]["k_i"].contains("e"));
  EXPECT_GT(json["condition"].get<double>(), 1);
  EXPECT_EQ(json["derived"]["law"], "signed");
  EXPECT_NEAR(json["derived"]["c_i"]["value"].get<double>(),
              2 * json["derived"]["xi"].get<double>() * std::sqrt(3e8 * 86952.0) / 1e3, 0.1);
  ASSERT_TRUE(json["fit"].contains(runs[0]));
  for (const char *key :
       {"peak_force_error", "peak_displacement_error", "rebound_error", "nrmse_displacement", "nrmse_force"}) {
    EXPECT_NEAR(json["fit"][runs[0]][key].get<double>(), 0, 1e-3) << key;
    EXPECT_NEAR(json["prediction"][options.predict[0]][key].get<double>(), 0, 1e-3) << key;
  }
  EXPECT_TRUE(json["prediction"][options.predict[1]]["peak_force_error"].is_null());
  EXPECT_EQ(json["windows"]["rows"].size(), 2u);
  EXPECT_FALSE(json["windows"]["sentence"].get<std::string>().empty());
  EXPECT_EQ(json["published"]["k_i"]["value"], 4.5e5);
  EXPECT_EQ(json["laws"]["rows"][0]["law"], "signed");            // which made them
  EXPECT_EQ(json["laws"]["rows"][0]["leave_one_out"].size(), 5u); // each run, and the pulse with both scales
  EXPECT_TRUE(json["profiles"].contains("e"));
  ASSERT_EQ(json["critical_amplitudes"].size(), 1u);
  // thesis notes, 1: 0.1-0.2 % below the printed amplitude
  EXPECT_NEAR(json["critical_amplitudes"][0]["critical_amplitude_g"].get<double>(), 0.78 * 0.9985, 0.78 * 0.001);

  // the fragment is a scene's [reduced]
  std::ifstream file(folder.at("calibration/calibration.toml"));
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const auto scene = scene::parse_scene(text, "calibration.toml");
  EXPECT_NEAR(scene.reduced.k_i / 3e8, 1, 1e-6);
  EXPECT_NEAR(scene.reduced.restitution, 0.4, 1e-6);
  EXPECT_NE(describe(c).find("k_i"), std::string::npos);
}

TEST(Calibrate, WindowsAloneGiveTheConstantPair) {
  TemporaryFolder folder;
  const auto c = calibrate({folder.write(window(0.1)), folder.write(window(0.3))});
  EXPECT_EQ(c.fitted_on, FittedOn::windows);
  EXPECT_NEAR(c.result.parameters.at("k_i").value / 3e5, 1, 1e-6);
  EXPECT_NEAR(c.windows->valid_from.value(), 0.1, 1e-6);
  EXPECT_NEAR(c.windows->valid_to.value(), 0.3, 1e-6);
}

template <typename Error> void expect_refusal(const std::vector<std::string> &runs, const std::string &words) {
  try {
    calibrate(runs);
    ADD_FAILURE() << "accepted: " << words;
  } catch (const Error &error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

/// The parameters of the runs' own law are fitted where none are named, whichever it is.
TEST(Calibrate, FitsWhatTheRunsOwnLawReads) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  for (const double speed : {0.1, 0.3, 0.5}) {
    auto s = window(speed, 6e8);
    s.reduced.impact_law = &laws::impact_law("elastoplastic");
    runs.push_back(folder.write(s));
  }
  CalibrationOptions options;
  options.fit.parameters.clear();
  options.profiles = false;
  EXPECT_EQ(calibrate(runs, options).result.names, laws::impact_law("elastoplastic").parameters);
  options.fit.fixed["k_i"] = 6e5;
  const auto held = calibrate(runs, options).result.names;
  EXPECT_EQ(std::count(held.begin(), held.end(), "k_i"), 0);
}

TEST(Calibrate, LeavesOutWhatIsNoResult) {
  TemporaryFolder folder;
  auto failed = window(0.4);
  failed.name = "failed";
  const auto run = reduced::simulate(failed);
  auto summary = run.summary;
  summary.extra["beyond_rim"] = true;
  write_run_folder(folder.at(failed.name), failed, run.response, summary);
  auto cut = window(0.3); // ends on the rim
  cut.name = "cut";
  cut.excitation.duration = 0.6 * reduced::simulate(cut).summary.impacts.at(0).release_time;
  const auto c = calibrate({folder.write(window(0.2)), folder.at(failed.name)});
  EXPECT_EQ(c.result.n_impacts, 1);
  EXPECT_NE(c.doubts.at(0).find("says itself is no result"), std::string::npos) << c.doubts[0];
  try {
    calibrate({folder.write(cut)});
    ADD_FAILURE() << "fitted";
  } catch (const DataError &error) {
    EXPECT_NE(std::string(error.what()).find("still bears"), std::string::npos) << error.what();
  }
}

TEST(Calibrate, RefusesWithTheReason) {
  TemporaryFolder folder;
  expect_refusal<InputError>({}, "no run folder");
  expect_refusal<DataError>({folder.at("absent")}, "not a run folder");
  expect_refusal<DataError>({folder.write(ricker(0.5))}, "never touched");
  auto push = window(0.2);
  push.name = "push";
  push.excitation.kind = scene::ExcitationKind::push;
  expect_refusal<DataError>({folder.write(push)}, "quasi-static");
  auto coarse = window(0.2);
  coarse.name = "coarse";
  const auto fine = reduced::simulate(coarse).response;
  const auto &force = fine.series("impact_x");
  const std::size_t pressed = force.size() - std::count(force.begin(), force.end(), 0.0), stride = pressed / 5;
  Response few; // about five samples on the rim
  for (const auto &[name, values] : fine.all())
    for (std::size_t i = 0; i < values.size(); i += stride) few.append(name, values[i]);
  write_run_folder(folder.at(coarse.name), coarse, few, {});
  expect_refusal<DataError>({folder.at(coarse.name)}, "samples carry rim force, 8 are needed");
  auto copy = window(0.2);
  copy.name = "copy";
  expect_refusal<InputError>({folder.write(window(0.2)), folder.write(copy)}, "sample by sample");
  auto heavier = window(0.2);
  heavier.name = "heavier";
  heavier.load.mass = 90000;
  expect_refusal<InputError>({folder.write(window(0.2)), folder.write(heavier)}, "load.mass_kg 86952 and 90000");
  auto other = window(0.2);
  other.name = "other";
  other.bearing.rim.height = 0.05;
  expect_refusal<InputError>({folder.write(window(0.2)), folder.write(other)}, "different dimensions");
}

TEST(Calibrate, AFitThatDidNotConvergeIsAGate) {
  TemporaryFolder folder;
  CalibrationOptions options;
  options.fit.max_iterations = 1;
  options.fit.n_starts = 1;
  const auto c = calibrate({folder.write(window(0.2))}, options);
  EXPECT_THROW(check_gate(c), GateError);
  EXPECT_NO_THROW(write_calibration(c, folder.at("out"))); // results are kept all the same
}

TEST(Calibrate, WritesAPurePowerOfSpeedWithoutADash) {
  Calibration c;
  c.speed_laws = {{"k_i", "kN/m", 9.7e4, -0.8, 0.2, 0.05, 1.0}, {"e", "-", 0.19, -0.54, 0.08, 0.05, 1.0}};
  EXPECT_NE(describe(c).find("k_i = 9.7e+04 kN/m (v / 1 m/s)^-0.800"), std::string::npos) << describe(c);
  EXPECT_NE(describe(c).find("e = 0.19 (v / 1 m/s)^-0.540"), std::string::npos) << describe(c);
}

TEST(Calibrate, ReadsALaboratoryCsvWithoutVelocities) {
  TemporaryFolder folder;
  const auto scene = window(0.3);
  const auto run = folder.write(scene);
  std::filesystem::remove(run + "/response.h5");
  const auto c = calibrate({run});
  EXPECT_NEAR(c.result.parameters.at("k_i").value / 3e5, 1, 0.01);
  EXPECT_NEAR(c.result.parameters.at("e").value, 0.4, 0.01);
}

} // namespace
} // namespace rimpact::calibration
