// The parts of an answer's errors: all named, none silently zero, each with where it is from or the command that tells
// it.
#include "answer_runs.h"
#include "calibration/answer/answer_json.h"
#include "calibration/answer/answer_text.h"
#include "calibration/answer/kept_errors.h"
#include "scene/bearing_catalogue.h"
#include "scene/rim_identity.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace rimpact::calibration {
namespace {
using namespace testing;

/// Of the rim's averaged strain from mesh 1 to 2, in the kept table.
double largest_kept_change_of_strain() {
  std::ifstream file(RIMPACT_REFERENCES "/../../tests/verification/steel_places.txt");
  EXPECT_TRUE(file);
  double largest = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    double speed, at_point, averaged, change;
    int mesh;
    std::string place;
    if (cells >> speed >> mesh >> place >> at_point >> averaged >> change && mesh == 1 && place != "slider_edge")
      largest = std::max(largest, std::abs(change) / 100);
  }
  EXPECT_GT(largest, 0);
  return largest;
}

/// Windows of a bearing at 0.1 to 0.3 m/s, as finite elements of rung rim leave them.
std::vector<std::string> solid_windows(const TemporaryFolder &folder, const scene::Bearing &bearing) {
  std::vector<std::string> runs;
  for (int i = 0; i < 3; ++i) {
    auto scene = window(0.1 * (i + 1));
    scene.bearing = bearing;
    runs.push_back(folder.write(scene));
    amend(runs[i], {{"max_plastic_strain", 0.1 * i}, {"rung", "rim"}, {"mesh", 1}, {"wall_time_s", 120}});
  }
  return runs;
}

AnswerError part_of(const Answer &answer, Erring quantity, ErrorSource source) {
  std::vector<AnswerError> found;
  std::copy_if(answer.errors.begin(), answer.errors.end(), std::back_inserter(found),
               [&](const AnswerError &error) { return error.quantity == quantity && error.source == source; });
  EXPECT_EQ(found.size(), 1u) << word(quantity) << " " << word(source);
  return found.empty() ? AnswerError{quantity, source, {}, Known::unknown, "missing"} : found.front();
}

/// Every number that leaves has every part, each stands once, and none is silently zero.
TEST(AnswerErrors, EveryPartOfTheErrorIsNamed) {
  TemporaryFolder folder;
  const Answer answer = *calibrate(solid_windows(folder, scene::builtin_bearing("shfps-225")), quick({})).answer;
  ASSERT_TRUE(answer.strain);
  for (const auto &quantity : choices(Erring()))
    for (const auto &source : choices(ErrorSource())) {
      const AnswerError part = part_of(answer, quantity.value, source.value);
      const std::string name = quantity.word + std::string(" ") + source.word;
      EXPECT_EQ(part.value.has_value(), part.how != Known::unknown) << name;
      EXPECT_FALSE(part.from.empty()) << name;
      EXPECT_GE(part.value.value_or(0), 0) << name;
      EXPECT_EQ(part.find.has_value(), !part.value) << name << ": what is not known has a command";
    }
  const double kept = largest_kept_change_of_strain();
  EXPECT_GE(part_of(answer, Erring::strain, ErrorSource::mesh).value.value(), kept);
  EXPECT_LE(part_of(answer, Erring::strain, ErrorSource::mesh).value.value(), kept + 0.01);
  EXPECT_EQ(part_of(answer, Erring::strain, ErrorSource::law).value, 0.0) << "no law is in the runs' own strain";
  const double of_force = part_of(answer, Erring::peak_force, ErrorSource::steel).value.value();
  EXPECT_DOUBLE_EQ(part_of(answer, Erring::depth, ErrorSource::steel).value.value(), of_force);
  EXPECT_DOUBLE_EQ(part_of(answer, Erring::k_i, ErrorSource::steel).value.value(), 2 * of_force);
  const Estimate &k = answer.law.result.parameters.at("k_i");
  constexpr double rounding = 1e-12;
  EXPECT_GE(part_of(answer, Erring::k_i, ErrorSource::law).value.value(), k.interval_high / k.value - 1 - rounding);
  EXPECT_EQ(sentences(answer.errors).size(), 6u) << "one of each quantity";
  double squares = 0;
  for (const AnswerError &error : answer.errors)
    if (error.quantity == Erring::peak_force) squares += std::pow(error.value.value_or(0), 2);
  const ErrorSum sum = sum_of(answer.errors, Erring::peak_force);
  EXPECT_NEAR(sum.known.value(), std::sqrt(squares), 1e-12);
  EXPECT_EQ(sum.open, std::vector{ErrorSource::geometry});
  EXPECT_NE(sentence(answer.errors, Erring::peak_force).find("Not known: geometry."), std::string::npos);
  const auto other = calibrate({folder.write(window(0.4)), folder.write(window(0.35))}, quick({})).answer->errors;
  for (const AnswerError &error : other) EXPECT_EQ(error.source, ErrorSource::law) << "the reduced model has no steel";
}

/// What is not known has the command that tells it, with its minutes; what a kept table says is what the file says.
TEST(AnswerErrors, WhatIsNotKnownHasItsCommandAndItsMinutes) {
  TemporaryFolder folder;
  auto bearing = scene::builtin_bearing("shfps-225");
  bearing.rim.thickness = 0.05; // no study knows it
  const auto runs = solid_windows(folder, bearing);
  for (const auto &run : runs) amend(run, {{"rung", "rigid-dish"}});
  const Answer answer = *calibrate(runs, quick({})).answer;
  EXPECT_EQ(part_of(answer, Erring::depth, ErrorSource::step).find->command,
            fmt::format("rimpact study {}/scene.toml --axes step --steps 1,0.5 -o {}/study-step-window-0.3", runs[2],
                        std::filesystem::path(runs[2]).parent_path().string()));
  EXPECT_NEAR(part_of(answer, Erring::depth, ErrorSource::step).find->minutes, 3 * 2, 1e-9);
  EXPECT_EQ(
      part_of(answer, Erring::k_i, ErrorSource::geometry).find->command,
      fmt::format("rimpact geometry {}/scene.toml --vary rim.height_mm=54:66 --at speed=0.3 --set load.mass_kg=86952",
                  runs[2]));
  const auto said = finding_sentences(answer.errors);
  ASSERT_EQ(said.size(), 2u) << "step and geometry, each once";
  EXPECT_NE(said[0].find("What is not known of step: rimpact study "), std::string::npos) << said[0];
  EXPECT_TRUE(said[0].ends_with("tells it (about 6 min).")) << said[0];
  const auto json = to_json(answer);
  EXPECT_EQ(json["finding_sentences"], said);
  for (const auto &part : json["errors"]) {
    const bool has_command =
        !part["value"].is_null() || part["source"] == "mesh" || part["find"]["command"].is_string();
    EXPECT_TRUE(has_command) << part;
  }
  EXPECT_NE(describe(answer).find(said[1]), std::string::npos);
}

/// A study of the step that the user made beside the runs, as the command above does, is read.
TEST(AnswerErrors, AStepThatWasStudiedBesideTheRunsIsKnown) {
  TemporaryFolder folder;
  const auto bearing = scene::builtin_bearing("shfps-225");
  const auto runs = solid_windows(folder, bearing);
  const std::string study = folder.at("study-step-window-0.3");
  std::filesystem::create_directories(study);
  const auto row = [](double step, double force, double rebound) {
    return nlohmann::json{{"rung", "rim"},
                          {"mesh", 1},
                          {"step_s", step},
                          {"peak_force_error", force},
                          {"rebound_error", rebound},
                          {"error", force},
                          {"reference", step < 1e-3}};
  };
  scene::Scene scene = window(0.3);
  scene.bearing = bearing;
  std::ofstream(study + "/study.json") << nlohmann::json{
      {"scene", {{"name", "window-0.3"}, {"rim_identity", scene::rim_identity(bearing)}, {"approach_speed_m_s", 0.3}}},
      {"rows", {row(1e-3, 0.011, -0.02), row(5e-4, 0, 0)}}};
  const Answer answer = *calibrate(runs, quick({})).answer;
  EXPECT_EQ(part_of(answer, Erring::peak_force, ErrorSource::mesh).from.find("study-step"), std::string::npos)
      << "a shorter step is no finer mesh";
  const AnswerError part = part_of(answer, Erring::peak_force, ErrorSource::step);
  EXPECT_NEAR(part.value.value(), 0.011, 1e-12);
  EXPECT_EQ(part.how, Known::measured);
  EXPECT_EQ(part.from, "study study-step-window-0.3");
}

/// Force [kN], depth [mm] and rebound by speed and rung, of the kept windows of tests/verification.
std::map<std::pair<double, std::string>, std::array<double, 3>> kept_windows(const std::string &name) {
  std::ifstream table(RIMPACT_REFERENCES "/../../tests/verification/" + name);
  std::map<std::pair<double, std::string>, std::array<double, 3>> rows;
  for (std::string line; std::getline(table, line);) {
    std::istringstream cells(line);
    std::string rung;
    double speed, dofs, steps, newton, seconds, memory, peak, error, press, rebound;
    if (cells >> rung >> speed >> dofs >> steps >> newton >> seconds >> memory >> peak >> error >> press >> rebound)
      rows[{speed, rung}] = {peak, press, rebound};
  }
  return rows;
}

ErrorAt at_load(const AnswerError &part, const std::string &load, double speed) {
  const auto row = std::find_if(part.by.begin(), part.by.end(), [&](const ErrorAt &each) {
    return each.load == load && std::abs(each.speed - speed) < 0.01;
  });
  EXPECT_NE(row, part.by.end()) << load << " " << speed;
  return row == part.by.end() ? ErrorAt{"", 0, {}, 0} : *row;
}

/// The constants beside the fit are those of the table that they stand for: one dish says nothing of two.
TEST(AnswerErrors, KeptWindowsTellTheRung) {
  for (const auto &[bearing, table] :
       {std::pair{"shfps-225", "windows_of_rungs.txt"}, {"dcfp-155", "windows_of_rungs_dcfp.txt"}}) {
    TemporaryFolder folder;
    const Answer answer = *calibrate(solid_windows(folder, scene::builtin_bearing(bearing)), quick({})).answer;
    const auto rows = kept_windows(table);
    for (const double speed : {0.1, 0.5}) {
      const auto &rim = rows.at({speed, "rim"}), &full = rows.at({speed, "full"});
      int column = 0;
      for (const Erring quantity : {Erring::peak_force, Erring::depth, Erring::rebound}) {
        const ErrorAt row =
            at_load(part_of(answer, quantity, ErrorSource::rung), "window with weight and friction", speed);
        EXPECT_NEAR(row.value, std::abs(rim[column] / full[column] - 1), 1e-9) << bearing << " " << word(quantity);
        EXPECT_NEAR(row.depth.value(), 1e-3 * rim[1], 1e-9);
        ++column;
      }
    }
  }
}

TEST(AnswerErrors, KeptStudiesTellTheRungByLoadAndDepth) {
  TemporaryFolder folder;
  const Answer answer = *calibrate(solid_windows(folder, scene::builtin_bearing("shfps-225")), quick({})).answer;
  const AnswerError force = part_of(answer, Erring::peak_force, ErrorSource::rung);
  EXPECT_GT(force.value.value(), 0.11) << "a kept pulse in two directions";
  EXPECT_EQ(force.from, "study rungs-pulse-bidirectional");
  EXPECT_NEAR(at_load(force, "impact-window", 0.5).value, 0.02904, 1e-5) << "mesh 2 of study rungs-window-0.50";
  EXPECT_EQ(part_of(answer, Erring::peak_force, ErrorSource::law).by.size(), 3u) << "one a run left out";
  const auto json = to_json(answer)["errors"];
  EXPECT_TRUE(std::any_of(json.begin(), json.end(), [](const auto &part) {
    return part["source"] == "energy" && part["by"].size() == 3 && part["by"][0]["penetration_mm"].is_number();
  }));
}

/// The step halved, from the table that the constants stand for.
TEST(AnswerErrors, TheStepIsThatOfTheKeptTable) {
  std::ifstream table(RIMPACT_REFERENCES "/../../tests/verification/rim_window_refinement.txt");
  std::map<std::pair<double, double>, std::pair<double, double>> rows;
  std::string line;
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    double speed, mesh, step, dofs, steps, newton, seconds, peak, error, rebound;
    if (cells >> speed >> mesh >> step >> dofs >> steps >> newton >> seconds >> peak >> error >> rebound && mesh == 1)
      rows[{speed, step}] = {peak, rebound};
  }
  double force = 0, rebound = 0;
  for (const double speed : {0.1, 0.5}) {
    force = std::max(force, std::abs(rows.at({speed, 1.0}).first / rows.at({speed, 0.5}).first - 1));
    rebound = std::max(rebound, std::abs(rows.at({speed, 1.0}).second / rows.at({speed, 0.5}).second - 1));
  }
  EXPECT_LE(force, step_halved_force);
  EXPECT_GT(force, step_halved_force - 2e-4);
  EXPECT_LE(rebound, step_halved_rebound);
  EXPECT_GT(rebound, step_halved_rebound - 2e-4);
}

/// Static and fast windows of this rim tell what the steel's rate does; without them mild steel's on another rim does.
TEST(AnswerErrors, ABandOfTheSteelTakesThePlaceOfAnothersRate) {
  TemporaryFolder folder;
  std::vector<std::string> runs;
  for (const double speed : {0.1, 0.3}) {
    auto scene = window(speed);
    scene.bearing = scene::builtin_bearing("shfps-225");
    runs.push_back(folder.write(scene));
    amend(runs.back(), {{"rung", "rim"}, {"mesh", 1}});
  }
  const auto hit = [](double force, double depth, double rebound) {
    return Impact{0, 0.05, 0, 0.3, rebound, force, depth};
  };
  CalibrationOptions options = quick({});
  options.steel_band = {
      .rate = {.model = scene::RateModel::cowper_symonds},
      .assumed = true,
      .twins = {{.speed = 0.1, .static_steel = hit(1e6, 2e-3, 0.10), .fast = hit(1.12e6, 1.8e-3, 0.11)},
                {.speed = 0.3, .static_steel = hit(2e6, 8e-3, 0.10), .fast = hit(2.4e6, 6e-3, 0.12)}},
      .calibration = "fast"};
  const Answer answer = *calibrate(runs, options).answer;
  const auto of = [&](Erring quantity) {
    std::vector<AnswerError> found;
    std::copy_if(answer.errors.begin(), answer.errors.end(), std::back_inserter(found), [&](const AnswerError &error) {
      return error.quantity == quantity && error.source == ErrorSource::steel;
    });
    EXPECT_EQ(found.size(), 1u) << word(quantity);
    return found.front();
  };
  EXPECT_NEAR(of(Erring::peak_force).value.value(), 0.20, 1e-12);
  EXPECT_NEAR(of(Erring::depth).value.value(), 0.25, 1e-12);
  EXPECT_NEAR(of(Erring::rebound).value.value(), 0.20, 1e-12);
  EXPECT_NEAR(of(Erring::k_i).value.value(), 0.40, 1e-12);
  EXPECT_EQ(of(Erring::peak_force).how, Known::transferred) << "its constants are mild steel's";
  const auto said = sentences(*answer.steel_band);
  EXPECT_EQ(said.front(),
            "Steel that knows its strain rate raises the peak force by 12 to 20 % and lowers the depth by "
            "10 to 25 %, from 0.1 to 0.3 m/s.");
  const auto json = to_json(answer)["steel_band"];
  EXPECT_EQ(json["law_is_of"], "static");
  EXPECT_EQ(json["rows"][1]["fast"]["penetration_mm"], 6.0);
  options.steel_band->assumed = false;
  const Answer known = *calibrate(runs, options).answer;
  EXPECT_TRUE(std::any_of(known.errors.begin(), known.errors.end(), [](const AnswerError &error) {
    return error.source == ErrorSource::steel && error.how == Known::measured;
  }));
}

} // namespace
} // namespace rimpact::calibration
