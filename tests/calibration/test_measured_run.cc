#include "calibration/answer/calibration.h"
#include "calibration/data/force_factor.h"
#include "calibration/data/measured_run.h"
#include "io/files/error.h"
#include "reduced_models/simulate.h"
#include "scene/toml_writer.h"
#include "synthetic.h"
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

constexpr const char *columns = R"([columns.time]
column = "t"
unit = "ms"
[columns.displacement_x]
column = "LVDT 1"
unit = "mm"
factor = -1.0
zero = 3.0
[columns.impact_x]
column = "cell"
unit = "kN"
)";

/// A table as a laboratory writes it: ms, mm with an offset and the sign turned, kN, a name line, a column
/// more.
std::string write_test(const TemporaryFolder &folder, const scene::Scene &s, double force_factor = 1) {
  const auto r = reduced::simulate(s).response;
  std::ofstream table(folder.at("test.csv"));
  table << "Impact test 7\nt;room;LVDT 1;cell\n";
  for (std::size_t i = 0; i < r.size(); ++i)
    if (i == 0 || r.series("time")[i] > r.series("time")[i - 1])
      table << fmt::format("{};21.5;{};{}\n", 1e3 * r.series("time")[i], 3 - 1e3 * r.series("displacement_x")[i],
                           1e-3 * force_factor * r.series("impact_x")[i]);
  std::ofstream(folder.at("scene.toml")) << scene::to_toml(s);
  return folder.at("test.toml");
}

std::string head(const std::string &more = "") {
  return "scene = \"scene.toml\"\nfile = \"test.csv\"\nskip_lines = 1\n" + more;
}

TEST(MeasuredRun, IsCalibratedLikeAnyOther) {
  TemporaryFolder folder;
  const auto path = write_test(folder, window(0.3));
  std::ofstream(path) << head("set = [\"reduced.k_i_kN_per_m=4.5e5\"]\n") + columns + "[uncertainty]\nforce = 0.03\n";
  const auto run = read_run(path, {});
  ASSERT_EQ(run.impacts.size(), 1u);
  EXPECT_DOUBLE_EQ(run.uncertainty->force, 0.03);
  EXPECT_NEAR(run.impacts[0].impact.approach_speed, 0.3, 3e-3);
  const auto c = calibrate({path});
  EXPECT_NEAR(c.result.parameters.at("k_i").value / 3e5, 1, 0.01);
  EXPECT_NEAR(c.result.parameters.at("e").value, 0.4, 0.01);
}

template <class E> void expect_unread(const std::string &path, const std::string &words) {
  try {
    read_run(path, {});
    ADD_FAILURE() << "accepted: " << words;
  } catch (const E &error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

std::string replaced(std::string text, const std::string &from, const std::string &to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(MeasuredRun, RefusesAMappingThatIsWrong) {
  TemporaryFolder folder;
  const auto path = write_test(folder, window(0.3));
  const auto write = [&](const std::string &text) { std::ofstream(path) << text; };
  write(head() + replaced(columns, "unit = \"mm\"", "unit = \"kN\""));
  expect_unread<InputError>(path, "columns.displacement_x.unit \"kN\" is no unit of displacement_x; it is stored in "
                                  "m, and may be given in m, cm, mm");
  write(head() + replaced(columns, "unit = \"kN\"", "unit = \"Nm\""));
  expect_unread<InputError>(path, "may be given in N, kN, MN");
  write(head() + replaced(columns, "columns.impact_x", "columns.impakt_x"));
  expect_unread<InputError>(path, "did you mean \"impact_x\"");
  write(head() + replaced(columns, "\"cell\"", "\"cell 2\""));
  expect_unread<DataError>(
      path,
      "no column \"cell 2\" (impact_x); the header, after skip_lines = 1, names \"t\", \"room\", \"LVDT 1\", \"cell\"");
  write(head("colour = 1\n") + columns);
  expect_unread<InputError>(path, "unknown key \"colour\"");
  write("file = \"test.csv\"\n" + std::string(columns));
  expect_unread<InputError>(path, "scene is missing");
}

TEST(MeasuredRun, RefusesFiguresThatContradictEachOther) {
  TemporaryFolder folder;
  const auto path = write_test(folder, window(0.3));
  const auto write = [&](const std::string &text) { std::ofstream(path) << text; };
  write(head() + replaced(columns, "unit = \"kN\"", "unit = \"N\""));
  expect_unread<DataError>(path, "times the change of momentum");
  write(head() + replaced(columns, "factor = -1.0", "factor = -25.4"));
  expect_unread<DataError>(path, "is the displacement's unit right?");
  write(head() + replaced(columns, "unit = \"kN\"", "unit = \"kN\"\nfactor = -1.0"));
  expect_unread<DataError>(path, "is its sign right?");
  write_test(folder, window(0.3), 0);
  write(head() + columns);
  EXPECT_TRUE(read_run(path, {}).impacts.empty());
}

/// A straight impact at 0.3 m/s with a flight [s] before its touch, and with or without one after its release.
void write_impact(const TemporaryFolder &folder, double before, bool flies_on, double force_factor) {
  const auto s = window(0.3);
  const auto r = reduced::simulate(s).response;
  const auto &t = r.series("time"), &u = r.series("displacement_x"), &force = r.series("impact_x");
  std::ofstream table(folder.at("test.csv"));
  table << "Impact test 7\nt;room;LVDT 1;cell\n";
  const auto row = [&](double time, double travel, double cell) {
    table << fmt::format("{};21.5;{};{}\n", 1e3 * (time + before), 3 - 1e3 * travel, 1e-3 * force_factor * cell);
  };
  constexpr double step = 1e-3;
  for (double at = -before; at < -step / 2; at += step) row(at, u[0] + 0.3 * at, 0);
  std::size_t last = r.size() - 1;
  while (!flies_on && last > 0 && force[last] == 0) --last;
  for (std::size_t i = 0; i <= std::min(last + 1, r.size() - 1); ++i)
    if (i == 0 || t[i] > t[i - 1]) row(t[i], u[i], force[i]);
  std::ofstream(folder.at("scene.toml")) << scene::to_toml(s);
}

// However long a record flies before its touch, and whether it holds a flight after its release or not: without one the
// rebound is made from the impulse, which would agree in any unit.
TEST(MeasuredRun, RefusesAForceThatDoesNotMoveTheMassAsTheDisplacementSays) {
  TemporaryFolder folder;
  const auto path = folder.at("test.toml");
  const auto write = [&](const std::string &text) { std::ofstream(path) << text; };
  for (const double before : {0.0, 0.015, 0.060})
    for (const bool flies_on : {true, false}) {
      SCOPED_TRACE(fmt::format("{} s before, {} after", before, flies_on));
      write_impact(folder, before, flies_on, 1);
      write(head() + columns);
      const auto right = read_run(path, {});
      ASSERT_EQ(right.impacts.size(), 1u);
      const auto factor = force_factor(right.impacts[0], right.scene.load.mass);
      ASSERT_TRUE(factor);
      EXPECT_NEAR(factor->value, 1, 0.02);
      for (const std::string unit : {"N", "MN", "kgf", "tf", "lbf", "kip"}) {
        write(head() + replaced(columns, "unit = \"kN\"", fmt::format("unit = \"{}\"", unit)));
        if (unit == "MN") { // would throw the mass out of its bearing
          expect_unread<DataError>(path, "are the units of time and force right?");
        } else {
          expect_unread<DataError>(path, "times the change of momentum");
          expect_unread<DataError>(path, "A column in kN declared as " + unit);
        }
      }
      write(head() + columns);
      write_impact(folder, before, flies_on, 1e3 / 4448.2216152605);
      expect_unread<DataError>(path, "test.toml: at");
      expect_unread<DataError>(path, "A column in kip declared as kN gives 0.225");
      write_impact(folder, before, flies_on, -1);
      expect_unread<DataError>(path, "is its sign right?");
    }
}

// The scene of a mapping says 0.1 m/s, its curve comes at 0.3 m/s: what is compared with it flies at the curve's own.
TEST(MeasuredRun, TakesItsOwnSpeedAndSaysSo) {
  TemporaryFolder folder;
  const auto path = folder.at("test.toml");
  const auto at = [&](double stated) {
    write_impact(folder, 0.015, true, 1);
    auto s = window(stated);
    s.excitation.scale = 0.5, s.excitation.speed *= 2;
    std::ofstream(folder.at("scene.toml")) << scene::to_toml(s);
    std::ofstream(path) << head() + columns;
    return read_run(path, {});
  };
  for (const double stated : {0.1, 0.35, 1.2}) {
    const auto run = at(stated);
    EXPECT_NEAR(run.scene.excitation.impact_speed(), 0.3, 1e-3);
    ASSERT_FALSE(run.doubts.empty()) << stated;
    EXPECT_NE(run.doubts.back().find(fmt::format("its scene says {} m/s, the record comes to the rim at 0.3", stated)),
              std::string::npos)
        << run.doubts.back();
    const auto flown = reduced::simulate(run.scene); // what the table of errors compares with the record
    EXPECT_NEAR(flown.summary.impacts.at(0).approach_speed, 0.3, 1e-3);
  }
  const auto right = at(0.299);
  EXPECT_EQ(right.scene.excitation.impact_speed(), 0.299) << "alike";
  for (const auto &doubt : right.doubts) EXPECT_EQ(doubt.find("its scene says"), std::string::npos) << doubt;
}

TEST(MeasuredRun, RefusesAClockAThousandTimesTooSlow) {
  TemporaryFolder folder;
  const auto path = write_test(folder, window(0.3));
  std::ofstream(path) << head() + replaced(columns, "unit = \"ms\"", "unit = \"s\"");
  expect_unread<DataError>(path, "are the units of time and force right?");
}

/// The rim stands where the bearing says: a zero that is wrong shows in where it is first touched.
TEST(MeasuredRun, DoubtsAZeroThatPutsTheRimElsewhere) {
  TemporaryFolder folder;
  auto s = window(0.3);
  s.excitation.kind = scene::ExcitationKind::free; // flies before it touches
  s.excitation.initial_displacement = {s.bearing.lateral_capacity() - 0.03, 0};
  s.excitation.initial_velocity = {0.5, 0};
  const auto path = write_test(folder, s);
  for (const double off : {0.0, 0.9, -2.5, 2.5, -6.0, 6.0}) { // [mm] of travel
    std::ofstream(path) << head() + replaced(columns, "zero = 3.0", fmt::format("zero = {}", 3.0 + off));
    const auto run = read_run(path, {});
    ASSERT_EQ(run.doubts.size(), off == 0 ? 0u : 1u) << off;
    if (off == 0) continue;
    EXPECT_NE(run.doubts[0].find(off > 0 ? "beyond" : "before"), std::string::npos) << run.doubts[0];
    EXPECT_NE(run.doubts[0].find("which a stiffness feels: is the displacement's zero right?"), std::string::npos);
  }
}

TEST(MeasuredRun, LeavesOutAnImpactTheRecordEndsIn) {
  TemporaryFolder folder;
  const auto s = window(0.3);
  const auto path = write_test(folder, s);
  const auto impact = reduced::simulate(s).summary.impacts.at(0);
  std::ofstream(path) << head() + columns;
  std::ifstream in(folder.at("test.csv"));
  std::string kept;
  int n = 0;
  for (std::string line; std::getline(in, line); ++n)
    if (n < 2 || std::stod(line) < 1e3 * (0.4 * impact.touch_time + 0.6 * impact.release_time)) kept += line + "\n";
  std::ofstream(folder.at("test.csv")) << kept;
  const auto run = read_run(path, {});
  EXPECT_TRUE(run.impacts.empty());
  EXPECT_NE(run.notes.at(0).find("still bears"), std::string::npos) << run.notes[0];
}

TEST(MeasuredRun, NoiseOnTheForceIsNoImpact) {
  TemporaryFolder folder;
  const auto s = window(0.3);
  const auto path = write_test(folder, s);
  std::ofstream(path) << head("force_noise = 0.02\n") + columns;
  // a cell that reads a little all the time
  std::ifstream in(folder.at("test.csv"));
  std::string text((std::istreambuf_iterator<char>(in)), {}), noisy;
  int n = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line); ++n)
    noisy += n > 1 && line.size() > 2 && line.substr(line.size() - 2) == ";0" ? line + (n % 2 ? ".5\n" : ".7\n")
                                                                              : line + "\n";
  std::ofstream(folder.at("test.csv")) << noisy;
  EXPECT_EQ(read_run(path, {}).impacts.size(), 1u);
}

} // namespace
} // namespace rimpact::calibration
