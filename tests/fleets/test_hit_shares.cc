// Which share of a fleet's hits lies where the models are not known to hold.
#include "../scene/expect_error.h"
#include "../scene/temporary_folder.h"
#include "io/files/table_csv.h"
#include "studies/fleets/fleet.h"
#include "studies/fleets/fractiles.h"
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::fleets;

namespace {

using Columns = std::map<std::string, double>;

void add(HitShares &shares, const Columns &row) {
  shares.add([&](const char *column) {
    const auto found = row.find(column);
    return found == row.end() ? std::nullopt : std::optional(found->second);
  });
}

double number_in(const Table &table, std::size_t row, const std::string &column) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i] == column) {
      const auto *value = std::get_if<double>(&table.rows[row][i]);
      return value ? *value : std::nan("");
    }
  ADD_FAILURE() << column;
  return 0;
}

} // namespace

TEST(HitShares, AreOfHitsAndTheUnknownIsNull) {
  HitShares shares;
  EXPECT_TRUE(shares.json()["share_beyond_fit"].is_null());
  add(shares, {{"n_impacts", 0}, {"hits_beyond_fit", 0}});
  EXPECT_TRUE(shares.json()["share_beyond_fit"].is_null()) << "no hit at all";
  add(shares, {{"n_impacts", 3},
               {"hits_beyond_fit", 2},
               {"slowest_approach_speed_m_s", 0.1},
               {"fastest_approach_speed_m_s", 1.8},
               {"known_from_m_s", 0.05},
               {"known_to_m_s", 0.2}});
  add(shares, {{"n_impacts", 5}}); // its element has no known range
  add(shares, {});                 // refused
  const auto json = shares.json();
  EXPECT_EQ(json["n_runs"], 3);
  EXPECT_EQ(json["n_runs_with_impact"], 2);
  EXPECT_EQ(json["n_hits"], 8);
  EXPECT_NEAR(json["share_beyond_fit"].get<double>(), 2.0 / 3, 1e-15);
  for (const char *unknown : {"share_beyond_pair", "share_beyond_rim", "share_beyond_steel", "hits_beyond_rim"})
    EXPECT_TRUE(json[unknown].is_null()) << unknown;
  ASSERT_EQ(shares.doubts().size(), 1u);
  for (const char *words : {"67 % of the hits", "(2 of 3)", "0.05 to 0.2 m/s", "0.1 to 1.8 m/s", "above 5 %"})
    EXPECT_NE(shares.doubts()[0].find(words), std::string::npos) << shares.doubts()[0];
}

TEST(HitShares, TheBoundIsStatedAndHeld) {
  for (const double beyond : {5.0, 6.0}) {
    HitShares shares;
    add(shares, {{"n_impacts", 100}, {"hits_beyond_pair", beyond}, {"known_to_m_s", 0.27}});
    EXPECT_EQ(shares.doubts().size(), beyond > 5 ? 1u : 0u);
  }
  HitShares rim;
  add(rim, {{"n_impacts", 100}, {"hits_beyond_rim", 1}});
  EXPECT_EQ(rim.doubts().size(), 1u) << "a rim pressed through is one at any share";
}

// A median ductility of 27 that no run calls a collapse.
TEST(HitShares, FramesBeyondWhatTheirLawStandsForAreDoubted) {
  HitShares none, within, beyond;
  add(none, {{"n_impacts", 0}});
  EXPECT_TRUE(none.json()["runs_beyond_frame"].is_null());
  add(within, {{"n_impacts", 0}, {"ductility", 9.9}, {"peak_drift_m", 0.149}});
  EXPECT_EQ(within.json()["runs_beyond_frame"], 0);
  EXPECT_TRUE(within.doubts().empty());
  for (const double ductility : {2.0, 27.0}) add(beyond, {{"n_impacts", 0}, {"ductility", ductility}});
  add(beyond, {{"n_impacts", 0}, {"ductility", 8}, {"peak_drift_m", 0.93}});
  beyond.add(within);
  ASSERT_EQ(beyond.doubts().size(), 1u);
  EXPECT_NE(
      beyond.doubts()[0].find("2 of 4 runs: the frame reaches a ductility of 27 (doubted above 10) and a drift of "
                              "0.93 m (above 0.15 m)"),
      std::string::npos)
      << beyond.doubts()[0];
}

// One reader for sweeps and studies: bounds of the user's own, counted over a fleet's runs.
TEST(Plausible, RunsBeyondASweepsBoundsAreCountedAndDoubted) {
  const std::string runs = "[grid]\nexcitation.scale = [0.2, 1.1, 1.4]\n[plausible]\n";
  expect_error<InputError>([&] { parse_sweep(runs + "ductilty = 3\n", "s.toml"); }, {"s.toml:4", "ductility"});
  expect_error<InputError>([&] { parse_sweep(runs + "ductility = 0\n", "s.toml"); }, {"s.toml:4", "ductility", "0"});
  const TemporaryFolder folder;
  const auto sweep = parse_sweep(runs + "peak_displacement_m = 0.3\npeak_drift_m = 1\n", "s.toml");
  FleetOptions options;
  options.folder = folder.path(), options.n_threads = 1;
  const auto result = run_fleet("ricker-0.78g-1.0s", {}, sweep, options);
  const auto json = result.implausible.json();
  const Table table = read_table(folder / "table.csv");
  std::size_t beyond = 0;
  double largest = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const double peak = number_in(table, i, "peak_displacement_m");
    beyond += peak > 0.3, largest = std::max(largest, peak);
  }
  EXPECT_EQ(beyond, 2u) << "the weak pulse stays below the bound";
  EXPECT_EQ(json["peak_displacement_m"]["n_runs_beyond"], beyond);
  EXPECT_EQ(json["peak_displacement_m"]["largest"], largest);
  EXPECT_TRUE(json["peak_drift_m"]["largest"].is_null()) << "no frame, no drift";
  EXPECT_TRUE(result.implausible.bound_the_frame());
  std::ifstream file(folder / "limits.json");
  const auto written = nlohmann::json::parse(file);
  EXPECT_EQ(written["plausible"], nlohmann::json(json));
  EXPECT_NE(written["doubts"].dump().find("2 runs have a peak_displacement_m beyond 0.3"), std::string::npos)
      << written["doubts"];
}

// The pulse on the published pair, and with a range that its hits leave.
TEST(HitShares, AFleetWritesThemAndItsFractilesLeaveTheUnknownEmpty) {
  const TemporaryFolder folder;
  const auto run = [&](const char *name, std::vector<std::string> settings) {
    const auto sweep =
        parse_sweep("[grid]\nexcitation.scale = [1.1, 1.4]\n[fractiles]\nalong = 'excitation.scale'\n", "s.toml");
    FleetOptions options;
    options.folder = folder / name, options.n_threads = 1;
    const auto result = run_fleet("ricker-0.78g-1.0s", settings, sweep, options);
    std::ifstream file(options.folder + "/limits.json");
    const auto written = nlohmann::json::parse(file);
    EXPECT_EQ(written["n_hits"], result.hits.json()["n_hits"]);
    EXPECT_EQ(written["doubts"].size(), result.hits.doubts().size());
    return std::pair(result, read_table(options.folder + "/fractiles.csv"));
  };
  const auto [pair, of_pair] = run("pair", {});
  EXPECT_FALSE(pair.beyond_fit) << "no range is known";
  EXPECT_EQ(pair.beyond_rim, 0u);
  EXPECT_GT(pair.hits.n_hits(), 0u);
  EXPECT_TRUE(std::isnan(number_in(of_pair, 1, "n_beyond_fit")));
  EXPECT_TRUE(std::isnan(number_in(of_pair, 1, "share_beyond_fit")));
  EXPECT_TRUE(std::isnan(number_in(of_pair, 1, "share_beyond_steel")));
  EXPECT_EQ(number_in(of_pair, 1, "share_beyond_rim"), 0);
  EXPECT_GT(number_in(of_pair, 1, "share_beyond_pair"), 0) << "scale 1.4 is faster than the pair is known for";
  ASSERT_FALSE(pair.hits.doubts().empty());
  EXPECT_NE(pair.hits.doubts()[0].find("thesis's pair is known for"), std::string::npos) << pair.hits.doubts()[0];
  const auto [fit, of_fit] = run("fit", {"reduced.k_i_kN_per_m=4e5", "reduced.fitted_to_m_per_s=0.01"});
  EXPECT_EQ(fit.beyond_fit, 2u);
  EXPECT_EQ(number_in(of_fit, 0, "share_beyond_fit"), 1);
  EXPECT_TRUE(std::isnan(number_in(of_fit, 0, "share_beyond_pair")));
}
