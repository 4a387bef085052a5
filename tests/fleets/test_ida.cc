// Incremental dynamic analysis: a folder of records, levels of intensity, fractiles.
#include "../scene/expect_error.h"
#include "../scene/temporary_folder.h"
#include "io/files/table_csv.h"
#include "io/records/record.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "studies/fleets/fleet.h"
#include "studies/fleets/fractiles.h"
#include "studies/fleets/record_intensity.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::fleets;

namespace {

/// Two seconds of a half wave of `peak_g`, and rest.
std::string at2(double peak_g) {
  std::string text = "PEER\nMADE UP\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 201, DT= .0100 SEC\n";
  for (int i = 0; i < 201; ++i)
    text += std::to_string(i < 100 ? peak_g * std::sin(i * std::acos(-1.0) / 50) : 0.0) + (i % 5 == 4 ? "\n" : " ");
  return text + "\n";
}
void write_station(const TemporaryFolder &folder) {
  folder.write("RSN1_HILL-UP.AT2", at2(0.1));
  folder.write("RSN1_HILL000.AT2", at2(0.2));
  folder.write("RSN1_HILL090.at2", at2(0.4));
  folder.write("RSN2_E04230.AT2", at2(0.3));
  folder.write("MANIFEST.md", "not a record");
}
const Cell &at(const Table &t, std::size_t row, const std::string &name) {
  const auto i = std::find(t.columns.begin(), t.columns.end(), name) - t.columns.begin();
  return t.rows.at(row).at(static_cast<std::size_t>(i));
}
double number(const Table &t, std::size_t row, const std::string &name) {
  return std::get<double>(at(t, row, name));
}
Sweep ida_sweep(const TemporaryFolder &folder, const std::string &components, const std::string &levels) {
  return parse_sweep("[records]\nfolder = '.'\ncomponents = '" + components + "'\n[grid]\nvariable.pga_g = " + levels +
                         "\n[linked]\nexcitation.scale = { product = ['variable.pga_g'], over = "
                         "'variable.record_pga_g' }\n[fractiles]\nalong = 'variable.pga_g'\n",
                     folder / "ida.toml");
}

} // namespace

TEST(RecordIntensity, IsTheLargerComponents) {
  const TemporaryFolder folder;
  write_station(folder);
  const std::vector<std::string> both{folder / "RSN1_HILL000.AT2", folder / "RSN1_HILL090.at2"};
  // sine of 1 s period: its peak velocity is a T / pi from rest
  const auto peak = intensity(both);
  EXPECT_NEAR(peak.pga_g, 0.4, 1e-6);
  EXPECT_NEAR(peak.pgv, 0.4 * standard_gravity / std::acos(-1.0), 1e-3);
  EXPECT_EQ(peak.sa_g, 0); // not asked for
  // so stiff that it rides along, but for the small overshoot of its free vibration
  EXPECT_NEAR(intensity(both, 0.01).sa_g, 0.4, 0.02);
}

TEST(RecordFolder, ComponentsThatAMotionHas) {
  const TemporaryFolder folder;
  write_station(folder);
  const Sweep single = ida_sweep(folder, "x", "[0.1, 0.6]");
  EXPECT_EQ(single.runs.size(), 6u); // three horizontal files, two levels
  EXPECT_TRUE(single.left_out.empty());
  const Sweep three = ida_sweep(folder, "xyz", "[0.1, 0.6]");
  ASSERT_EQ(three.runs.size(), 2u);
  ASSERT_EQ(three.left_out.size(), 1u);
  EXPECT_NE(three.left_out[0].find("RSN2_E04"), std::string::npos);
  const auto all = three.assignments(1);
  const auto has = [&](const std::string &text) { return std::find(all.begin(), all.end(), text) != all.end(); };
  EXPECT_TRUE(has("excitation.kind=\"record\""));
  EXPECT_TRUE(has("excitation.y=\"" + (folder / "RSN1_HILL090.at2") + "\""));
  EXPECT_TRUE(has("excitation.z=\"" + (folder / "RSN1_HILL-UP.AT2") + "\""));
  const auto scale = std::find(three.keys.begin(), three.keys.end(), "excitation.scale") - three.keys.begin();
  EXPECT_NEAR(std::get<double>(three.runs[1][static_cast<std::size_t>(scale)].cell), 1.5, 1e-5);
}

TEST(RecordFolder, SpectralAccelerationIsAVariable) {
  const TemporaryFolder folder;
  write_station(folder);
  const Sweep sweep = parse_sweep("[records]\nfolder = '.'\ncomponents = 'xy'\nsa_period_s = 1.0\n[grid]\n"
                                  "variable.sa_g = [0.5]\n[linked]\nexcitation.scale = { product = ['variable.sa_g'], "
                                  "over = 'variable.record_sa_g' }\n",
                                  folder / "ida.toml");
  ASSERT_EQ(sweep.runs.size(), 1u);
  const auto at = [&](const char *key) {
    const auto i = std::find(sweep.keys.begin(), sweep.keys.end(), key) - sweep.keys.begin();
    return std::get<double>(sweep.runs[0].at(static_cast<std::size_t>(i)).cell);
  };
  EXPECT_NEAR(at("excitation.scale"), 0.5 / at("variable.record_sa_g"), 1e-12);
  EXPECT_GT(at("variable.record_sa_g"), 0.8); // two thirds of the way to resonance in one cycle
  // Both components are one wave, 0.2 and 0.4 g: along their sum stands the root of five times the smaller.
  EXPECT_NEAR(at("variable.record_rotd100_g") / at("variable.record_sa_g"), std::sqrt(5.0) / 2, 1e-3);
  EXPECT_LT(at("variable.record_rotd50_g"), at("variable.record_rotd100_g"));
}

TEST(RecordFolder, ErrorsNameFolderAndKey) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string &text, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { parse_sweep(text, folder / "s.toml"); }, words);
  };
  refused("[records]\nfolder = '.'\ncomponents = 'x'\n", {"s.toml:2:", "records.folder", "holds no record"});
  refused("[records]\nfolder = 'nowhere'\ncomponents = 'x'\n", {"s.toml:2:", "nowhere"});
  folder.write("A000.AT2", at2(0.2));
  refused("[records]\nfolder = '.'\ncomponents = 'xz'\n", {"s.toml:3:", "components", "xz", "xyz"});
  refused("[records]\nfolder = '.'\ncomponents = 'xy'\n", {"s.toml:2:", "no station", "xy"});
  refused("[records]\nfolder = '.'\n", {"s.toml:1:", "records.components"});
  refused("[records]\ncomponents = 'x'\n", {"s.toml:1:", "[records] needs records.folder"});
  refused("[records]\nfolder = 3\ncomponents = 'x'\n", {"s.toml:2:", "records.folder must be a string, got 3"});
  refused("[records]\nfolder = '.'\ncomponents = 'x'\nperiod_s = 1\n", {"s.toml:4:", "unknown key \"period_s\""});
  refused("[records]\nfolder = '.'\ncomponents = 'x'\nsa_period_s = 0\n",
          {"s.toml:4:", "records.sa_period_s 0 must be >= 0.01 and <= 100"});
  refused("[grid]\nexcitation.scale = [1]\n[fractiles]\nalong = 'excitation.scal'\n", {"s.toml:4:", "excitation.scal"});
  refused("[grid]\nvariable.a = [1]\nvariable.b = [0]\n[linked]\nexcitation.scale = { product = "
          "['variable.a'], over = "
          "'variable.b' }\n",
          {"s.toml:5:", "excitation.scale", "variable.b is 0"});
  folder.write("A000.AT2", "PEER\ncut short\n");
  expect_error<DataError>([&] { parse_sweep("[records]\nfolder = '.'\ncomponents = 'x'\n", folder / "s.toml"); },
                          {"A000.AT2"});
}

TEST(Fractiles, OfKnownValues) {
  Table runs;
  runs.columns = {
      "level", "status", "reason", "n_impacts", "peak_displacement_m", "peak_lateral_force_N", "peak_impact_force_N"};
  const auto run = [&](double level, const char *status, const char *reason, double value) {
    runs.rows.push_back({level, std::string(status), std::string(reason), value > 50 ? 1.0 : 0.0, value, 2 * value,
                         value > 50 ? Cell(value) : Cell{}});
  };
  for (int i = 100; i >= 0; --i) run(0.2, "done", "", i); // 0 to 100: the fractile is its share in percent
  run(0.2, "refused", "no scene", 1e9);
  run(0.2, "stopped", "the steps became too small", 1e9);
  for (int i = 0; i < 4; ++i) run(0.1, "done", "", i); // 0, 1, 2, 3 and one that fell off
  run(0.1, "stopped", "the slider left the dish at t = 3 s", 0.0);
  const Table t = fractiles(runs, "level");
  ASSERT_EQ(t.rows.size(), 2u);
  EXPECT_EQ(number(t, 0, "level"), 0.1);
  EXPECT_EQ(number(t, 0, "n_runs"), 5);
  EXPECT_EQ(number(t, 0, "n_stopped"), 1);
  EXPECT_NEAR(number(t, 0, "p16_peak_displacement_m"), 0.64, 1e-14);
  EXPECT_EQ(number(t, 0, "p50_peak_displacement_m"), 2);
  EXPECT_EQ(at(t, 0, "p84_peak_displacement_m"), Cell{}); // between 3 and beyond
  EXPECT_EQ(number(t, 1, "n_runs"), 101);
  EXPECT_EQ(number(t, 1, "n_without_result"), 2);
  EXPECT_EQ(number(t, 1, "n_with_impact"), 50);
  EXPECT_NEAR(number(t, 1, "p16_peak_displacement_m"), 16, 1e-12);
  EXPECT_NEAR(number(t, 1, "p84_peak_lateral_force_N"), 168, 1e-12);
  EXPECT_NEAR(number(t, 1, "p50_peak_impact_force_N"), 75.5, 1e-12); // of 51 to 100
  EXPECT_THROW(fractiles(runs, "reason"), std::logic_error);
  EXPECT_THROW(fractiles(runs, "nothing"), std::logic_error);
}

// A run of the table touches the rim exactly when its scale is above the one that bisection finds.
TEST(Ida, RealRecordsTouchWhereBisectionSays) {
  const char *given = std::getenv("RIMPACT_RECORDS");
  const std::string folder = given ? given : RIMPACT_SHARED_RECORDS;
  const std::string files[] = {"RSN1086_NORTHR_SYL360.AT2", "RSN1063_NORTHR_RRS228.AT2"};
  for (const auto &file : files)
    if (!std::filesystem::exists(folder + "/" + file))
      GTEST_SKIP() << "no records in " << folder << " (set RIMPACT_RECORDS)";
  const std::vector<std::string> overrides{"excitation.duration_s=20"};
  for (const auto &file : files) {
    const TemporaryFolder one;
    std::filesystem::create_symlink(std::filesystem::absolute(folder + "/" + file), one / file);
    const auto base = scene::load_scene("ricker-0.78g-1.0s", {"excitation.kind=\"record\"", "excitation.duration_s=20",
                                                              "excitation.x=\"" + (one / file) + "\""});
    const auto critical = reduced::critical_scale(base, 0.2, 4);
    ASSERT_TRUE(critical.has_value()) << file;
    const double pga_g = intensity({one / file}).pga_g;
    const double levels[] = {0.5 * *critical * pga_g, 0.999 * *critical * pga_g, 1.001 * *critical * pga_g};
    const Sweep sweep = ida_sweep(one, "x",
                                  "[" + std::to_string(levels[0]) + ", " + std::to_string(levels[1]) + ", " +
                                      std::to_string(levels[2]) + "]");
    FleetOptions options;
    options.folder = one / "ida", options.n_threads = 2;
    EXPECT_EQ(run_fleet("ricker-0.78g-1.0s", overrides, sweep, options).done, 3u);
    const Table t = read_table(one / "ida/table.csv");
    EXPECT_EQ(number(t, 0, "n_impacts"), 0);
    EXPECT_EQ(number(t, 1, "n_impacts"), 0);
    EXPECT_GE(number(t, 2, "n_impacts"), 1);
    const Table curves = read_table(one / "ida/fractiles.csv");
    ASSERT_EQ(curves.rows.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) // one record: all fractiles are its value
      EXPECT_EQ(number(curves, i, "p84_peak_displacement_m"), number(t, i, "peak_displacement_m"));
  }
}
