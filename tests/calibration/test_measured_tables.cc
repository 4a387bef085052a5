// Tables as laboratories hand them over: what each form holds must be read as the plain table is, to the last digit
// where no clock differs.
#include "calibration/answer/calibration.h"
#include "calibration/data/channels.h"
#include "calibration/data/force_clock.h"
#include "calibration/data/measured_name.h"
#include "calibration/data/measured_run.h"
#include "calibration/data/measured_table.h"
#include "io/files/character_set.h"
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include "measured_synthetic.h"
#include "reduced_models/simulate.h"
#include "scene/toml_writer.h"
#include <fstream>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {
using namespace testing;

constexpr Instruments quiet{.rate = 4000, .displacement = 1e-6, .force = 0.001, .before = 0.02, .after = 0.03};

Response record_at(double speed, const Instruments &with = quiet) {
  auto s = window(speed);
  s.reduced.output_step = 1e-4;
  return sampled(s, reduced::simulate(s).response, with, 3);
}

/// ms, mm and kN of one record, a line a sample, `lead` before each.
std::string rows(const Response &r, const std::string &lead = "", double start_ms = 0) {
  std::string text;
  for (std::size_t i = 0; i < r.size(); ++i)
    text += fmt::format("{}{};{};{}\n", lead, start_ms + 1e3 * r.series("time")[i], 1e3 * r.series("displacement_x")[i],
                        1e-3 * r.series("impact_x")[i]);
  return text;
}

class Laboratory : public ::testing::Test {
protected:
  void SetUp() override { write("scene.toml", scene::to_toml(window(0.3))); }
  void write(const std::string &name, const std::string &text) { std::ofstream(folder_.at(name)) << text; }
  /// A mapping of columns t, u, F with or without units, `more` at its top.
  std::string mapping(const std::string &more = "", bool units = true, const std::string &u = "u",
                      const std::string &of_force = "", const std::string &tests = "") {
    const auto unit = [&](const char *name) { return units ? fmt::format("unit = \"{}\"\n", name) : ""; };
    write("test.toml", "scene = \"scene.toml\"\nfile = \"test.csv\"\n" + more + "[columns.time]\ncolumn = \"t\"\n" +
                           unit("ms") + "[columns.displacement_x]\ncolumn = \"" + u + "\"\n" + unit("mm") +
                           "[columns.impact_x]\ncolumn = \"F\"\n" + unit("kN") + of_force + tests);
    return folder_.at("test.toml");
  }
  static std::string refused(const std::string &path) {
    try {
      read_run(path, {});
    } catch (const Error &error) {
      return error.what();
    }
    return "accepted";
  }
  static void expect_alike(const StoredRun &run, const StoredRun &plain) {
    for (const char *signal : {"time", "displacement_x", "impact_x"})
      EXPECT_EQ(run.response.series(signal), plain.response.series(signal)) << signal;
  }
  static bool says(const std::vector<std::string> &notes, const std::string &words) {
    return std::any_of(notes.begin(), notes.end(), [&](const auto &n) { return n.find(words) != n.npos; });
  }
  TemporaryFolder folder_;
};

TEST_F(Laboratory, ReadsUnitsWhereverTheyStand) {
  const auto text = rows(record_at(0.3));
  write("test.csv", "t;u;F\n" + text);
  const auto plain = read_run(mapping(), {});
  ASSERT_EQ(plain.impacts.size(), 1u);
  EXPECT_NE(refused(mapping("", false)).find("columns.time.unit is missing, and "), std::string::npos);
  write("test.csv", "t;u;F\n[ms];(mm);kN\n" + text);
  const auto by_row = read_run(mapping("", false), {});
  expect_alike(by_row, plain);
  EXPECT_TRUE(says(by_row.noise, "test.csv:2: a row of units"));
  expect_alike(read_run(mapping(), {}), plain); // stated and found alike
  write("test.csv", "t;u;F\ns;mm;kN\n" + text);
  EXPECT_NE(refused(mapping()).find("\"t\" is in s by the table itself, in ms by"), std::string::npos);
  write("test.csv", "t;u;F\nsaniye;santim;kuvvet\n" + text);
  const auto words = read_run(mapping(), {});
  expect_alike(words, plain);
  EXPECT_TRUE(says(words.noise, "no row of numbers below the names: it is left out"));
  write("test.csv", "t;u [mm];F\n" + text);
  EXPECT_NE(refused(mapping("", false, "u [mm]")).find("columns."), std::string::npos); // t and F have none
  EXPECT_EQ(unit_as_mapped(" [mm/s] "), "mm_per_s");
}

TEST_F(Laboratory, LeavesOutWhatStandsBelowTheTableAndSaysSo) {
  const auto text = rows(record_at(0.3));
  write("test.csv", "t;u;F\n" + text);
  const auto plain = read_run(mapping(), {});
  write("test.csv", "Test 7;;\nBearing A;;\nt;u;F\n" + text + "\nMaximum;341,0;880\nEnd of file;;\n");
  const auto run = read_run(mapping(), {});
  expect_alike(run, plain);
  EXPECT_TRUE(says(run.noise, "2 lines below the table left out, from \"Maximum\" on")) << run.noise.front();
  write("test.csv", "t;u;F\n" + text + "broken;1;2\n" + rows(record_at(0.3), "", 1e3));
  EXPECT_NE(refused(mapping()).find("\"broken\" is not a finite number"), std::string::npos) << refused(mapping());
}

TEST_F(Laboratory, ReadsOtherCharacterSets) {
  const auto text = rows(record_at(0.3));
  write("test.csv", "t;u;F\n" + text);
  const auto plain = read_run(mapping(), {});
  const std::string turkish = "t;Yer de\xF0i\xFEtirme;F\n"; // windows-1254
  write("test.csv", "K\xFDzak;;\n" + turkish + text);
  const auto found = read_run(mapping("", true, "Yer değiştirme"), {});
  expect_alike(found, plain);
  EXPECT_TRUE(says(found.noise, "it is read as windows-1254"));
  expect_alike(read_run(mapping("encoding = \"windows-1254\"\n", true, "Yer değiştirme"), {}), plain);
  EXPECT_NE(refused(mapping("encoding = \"windows-1252\"\n", true, "Yer değiştirme")).find("Yer deðiþtirme"),
            std::string::npos);
  EXPECT_NE(refused(mapping("encoding = \"klingon\"\n", true, "Yer değiştirme")).find("\"klingon\" is not known"),
            std::string::npos);
  EXPECT_NE(refused(mapping("", true, "Verschiebung")).find("test.csv:1: byte 0xFD is no UTF-8"), std::string::npos);
  EXPECT_EQ(utf8_from("\x83\x58", "shift_jis", ""), "ス");
  EXPECT_FALSE(utf8_from("\x83", "shift_jis", ""));
  EXPECT_EQ(not_utf8("a\xC3\xA4\xFF"), 3u);
}

TEST_F(Laboratory, TakesSeveralTestsByColumnByBlockAndByTime) {
  const auto slow = record_at(0.3), fast = record_at(0.6);
  std::vector<StoredRun> plain;
  for (const auto *r : {&slow, &fast}) {
    write("test.csv", "t;u;F\n" + rows(*r));
    plain.push_back(read_run(mapping(), {}));
  }
  write("test.csv", "no;t;u;F\n" + rows(slow, "7;") + rows(fast, "8 b;"));
  const auto by_column = mapping("test_column = \"no\"\n");
  ASSERT_EQ(each_test({by_column, "elsewhere"}),
            (std::vector{by_column + "#7", by_column + "#8 b", std::string("elsewhere")}));
  expect_alike(read_run(by_column + "#7", {}), plain[0]);
  expect_alike(read_run(by_column + "#8 b", {}), plain[1]);
  EXPECT_NE(refused(by_column).find("holds 2 tests; name one: "), std::string::npos);
  EXPECT_NE(refused(by_column + "#9").find("test \"9\" is not known"), std::string::npos) << refused(by_column + "#9");
  EXPECT_NE(refused(mapping()).find("test_column, from_s and to_s, or block"), std::string::npos);

  write("test.csv", "t;u;F\n" + rows(slow) + "\nTest 8\nt;u;F\nms;mm;kN\n" + rows(fast) + "\nend\n");
  const auto by_block = mapping(
      "", true, "u", "", "[test.zeta]\nblock = 1\n[test.alpha]\nblock = 2\nset = [\"excitation.speed_m_per_s=0.6\"]\n");
  ASSERT_EQ(each_test({by_block}), (std::vector{by_block + "#zeta", by_block + "#alpha"})); // as the file lists them
  expect_alike(read_run(by_block + "#zeta", {}), plain[0]);
  expect_alike(read_run(by_block + "#alpha", {}), plain[1]);
  EXPECT_DOUBLE_EQ(read_run(by_block + "#alpha", {}).scene.excitation.impact_speed(), 0.6);
  EXPECT_NE(refused(mapping()).find("the names of the columns stand again"), std::string::npos);
  EXPECT_NE(refused(mapping("block = 3\n")).find("block 3 is asked for, but 2 lines have the columns"),
            std::string::npos);

  write("test.csv", "t;u;F\n" + rows(slow) + rows(fast, "", 1000));
  const auto by_time = mapping("", true, "u", "", "[test.7]\nto_s = 0.9\n[test.8]\nfrom_s = 1.0\n");
  const auto second = read_run(by_time + "#8", {});
  EXPECT_EQ(second.response.series("displacement_x"), plain[1].response.series("displacement_x"));
  EXPECT_EQ(read_run(by_time + "#7", {}).response.size(), slow.size());
  EXPECT_NE(refused(mapping("from_s = 7.0\n")).find("0 samples from 7 s to inf s; the table has 0 s to"),
            std::string::npos)
      << refused(mapping("from_s = 7.0\n"));
}

/// A force logger of another rate that begins earlier, in a table of its own; then in more rows of the same table.
TEST_F(Laboratory, BringsAForceOnItsOwnClockToThatOfTheTravel) {
  auto with = quiet;
  const auto travel = record_at(0.3, with);
  with.rate = 9000;
  const auto s = window(0.3);
  auto finer = s;
  finer.reduced.output_step = 1e-4;
  const auto force = sampled(finer, reduced::simulate(finer).response, with, 3); // the same phase, in shares of a step
  // `sampled` begins at a random share of its own step: the clocks differ by it, which is known
  std::mt19937 generator(3);
  const double share = std::uniform_real_distribution<double>()(generator), offset = share / 9000 - share / 4000;
  std::string own = "t2;F\ns;kN\n";
  for (std::size_t i = 0; i < force.size(); ++i)
    own += fmt::format("{};{}\n", force.series("time")[i] + offset, 1e-3 * force.series("impact_x")[i]);
  write(
      "test.csv", "t;u\n" + [&] {
        std::string text;
        for (std::size_t i = 0; i < travel.size(); ++i)
          text += fmt::format("{};{}\n", travel.series("time")[i], 1e3 * travel.series("displacement_x")[i]);
        return text;
      }());
  write("cell.csv", own);
  const auto path = mapping("", false, "u", "file = \"cell.csv\"\ntime_column = \"t2\"\n");
  std::ifstream in(path);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  text.replace(text.find("column = \"t\""), 12, "column = \"t\"\nunit = \"s\"");
  text.replace(text.find("column = \"u\""), 12, "column = \"u\"\nunit = \"mm\"");
  write("test.toml", text);
  const auto run = read_run(path, {});
  ASSERT_EQ(run.impacts.size(), 1u);
  EXPECT_TRUE(says(run.noise, "impact_x has a clock of its own"));
  write("test.csv", "t;u;F\n" + rows(travel));
  const auto plain = read_run(mapping(), {});
  EXPECT_NEAR(run.impacts[0].peak / plain.impacts[0].peak, 1, 0.005);
  EXPECT_NEAR(run.impacts[0].impact.rebound_speed, plain.impacts[0].impact.rebound_speed, 2e-3);
  EXPECT_TRUE(run.doubts.empty()) << run.doubts.front();

  write("test.csv", "t;u\n" + rows(travel)); // the mapping still wants F of the same table
  EXPECT_NE(refused(mapping("", true, "u", "file = \"cell.csv\"\n")).find("whose clock is needed: time_column"),
            std::string::npos);
}

// A channel d ms late, stated or found: the force stands where it stood.
TEST_F(Laboratory, TakesOffALagThatIsStatedOrFound) {
  const auto right = record_at(0.4);
  write("test.csv", "t;u;F\n" + rows(right));
  const auto plain = read_run(mapping(), {});
  for (const double late : {0.6, -0.4, 12.0}) { // [ms]; 12 ms: the slider has long left the rim
    SCOPED_TRACE(late);
    std::string text = "t;u;t2;F\n";
    for (std::size_t i = 0; i < right.size(); ++i)
      text += fmt::format("{0};{1};{2};{3}\n", 1e3 * right.series("time")[i], 1e3 * right.series("displacement_x")[i],
                          1e3 * right.series("time")[i] + late, 1e-3 * right.series("impact_x")[i]);
    write("test.csv", text);
    const std::string own_clock = "time_column = \"t2\"\n";
    const auto stated = read_run(mapping("", true, "u", own_clock + fmt::format("lag_ms = {}\n", late)), {});
    ASSERT_EQ(stated.impacts.size(), 1u);
    EXPECT_NEAR(stated.impacts[0].peak / plain.impacts[0].peak, 1, 1e-6);
    EXPECT_NEAR(stated.impacts[0].impact.touch_time, plain.impacts[0].impact.touch_time, 1e-6);
    EXPECT_NEAR(stated.impacts[0].impact.rebound_speed, plain.impacts[0].impact.rebound_speed, 1e-4);
    if (late > 5) // the impulse stands where the slider has long left the rim
      EXPECT_NE(refused(mapping("", true, "u", own_clock)).find("times the change of momentum"), std::string::npos);
    else
      EXPECT_TRUE(says(read_run(mapping("", true, "u", own_clock), {}).doubts, "the motion that it causes"));
    const auto found = read_run(mapping("", true, "u", own_clock + "estimate_lag = true\n"), {});
    ASSERT_EQ(found.impacts.size(), 1u);
    EXPECT_TRUE(says(found.noise, late > 0 ? "after the motion that it causes" : "before the motion that it causes"));
    EXPECT_NEAR(found.impacts[0].impact.touch_time, plain.impacts[0].impact.touch_time, 5e-5);
    EXPECT_FALSE(says(found.doubts, "the motion that it causes"));
  }
}

/// The force of a response by a clock that is late by `late` [s].
void delay_force(Response &r, double late) {
  const auto &time = r.series("time");
  std::vector<double> earlier;
  for (const double t : time) earlier.push_back(std::clamp(t - late, time.front(), time.back()));
  r.series("impact_x") = r.series("force_x") = on_clock(time, r.series("impact_x"), earlier);
}

TEST_F(Laboratory, TellsTheLagItFinds) {
  for (const double late : {0.8e-3, -0.5e-3}) {
    auto r = record_at(0.5);
    delay_force(r, late);
    WindowOptions options;
    options.measured = true;
    const auto clock = align_force("lagged", window(0.5), r, options);
    EXPECT_NEAR(clock.lag, late, std::max(3 * clock.unsure, 2e-5));
    EXPECT_LT(clock.unsure, 1e-4);
    EXPECT_EQ(clock.n_impacts, 1);
  }
}

/// A record at 0.5 m/s with its force late by `late` [s].
StoredRun with_late_force(scene::Scene s, double late, unsigned seed, bool found) {
  s.reduced.output_step = 1e-4;
  auto r = sampled(s, reduced::simulate(s).response, quiet, seed);
  delay_force(r, late);
  WindowOptions options;
  options.measured = true;
  const double error = found ? align_force("late", s, r, options).unsure : 0;
  auto run = make_run("late", s, r, options);
  run.clock_error = error;
  return run;
}

// A force later than the motion it causes makes a rim that yields too soft; a stated error of the clocks says by how
// much it may be so.
TEST(ForceClock, AStatedErrorOfTheClocksIsUsed) {
  auto s = window(0.5, 9e8);
  s.reduced.impact_law = &laws::impact_law("elastoplastic");
  s.reduced.yield_force = 6.5e5, s.reduced.hardening = 0.15, s.reduced.unloading_gain = 0.4;
  const auto run = with_late_force(s, 0.3e-3, 5, false);
  FitOptions options;
  options.law = "elastoplastic", options.parameters = {"k_i", "yield_force", "hardening", "unloading_gain"};
  const auto off_by = [&] { // in standard errors
    const auto k = fit({&run}, options).parameters.at("k_i");
    return std::abs(k.value - 9e5) / k.standard_error;
  };
  EXPECT_GT(off_by(), 10);
  options.uncertainty.time = 0.3e-3;
  EXPECT_LT(off_by(), 2.5);
}

// What is left of a lag that was found stands in the intervals: k_i is off by what they say.
TEST(ForceClock, TheErrorOfALagStandsInTheInterval) {
  constexpr int n = 12;
  double square = 0;
  for (unsigned seed = 1; seed <= n; ++seed) {
    const auto run = with_late_force(window(0.5), 0.4e-3, seed, true);
    const auto k = fit({&run}, {}).parameters.at("k_i");
    EXPECT_LT(std::abs(k.value / 3e5 - 1), 0.03) << seed;
    square += std::pow((k.value - 3e5) / k.standard_error, 2) / n;
  }
  EXPECT_LT(square, 2.2); // chi squared over 12: beyond it in one of a hundred
}

// What a mapping may not say.
TEST_F(Laboratory, RefusesKeysThatMeanNothing) {
  write("test.csv", "t;u;F\n" + rows(record_at(0.3)));
  EXPECT_NE(refused(mapping("", true, "u", "estimate_lag = true\nlag_ms = 1\n")).find("give one of them"),
            std::string::npos);
  EXPECT_NE(
      refused(mapping("", true, "u", "", "[columns.force_x]\ncolumn = \"F\"\nunit = \"kN\"\nestimate_lag = true\n"))
          .find("only the rim's force"),
      std::string::npos);
  EXPECT_NE(refused(mapping("", true, "u", "", "[test.\"a.b\"]\nblock = 1\n")).find("NAME without points"),
            std::string::npos);
  EXPECT_NE(refused(mapping() + "#7").find("is one test: nothing follows its name"), std::string::npos);
}

} // namespace
} // namespace rimpact::calibration
