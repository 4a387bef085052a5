// A small study from its file to its tables.
#include "../scene/expect_error.h"
#include "io/files/folder_lock.h"
#include "io/files/table_csv.h"
#include "made_up.h"
#include "studies/risk/campaign.h"
#include "studies/risk/collect.h"
#include "studies/risk/plan.h"
#include "studies/risk/study_reader.h"
#include <algorithm>
#include <filesystem>
#include <set>

using namespace rimpact;
using namespace rimpact::risk;

namespace {

struct Small {
  TemporaryFolder folder;
  Study study;
  Systems systems;
  Motions motions;
  Small() {
    made_up::write_records(folder);
    study = parse_study(std::string(made_up::head) + made_up::systems, folder / "s.toml");
    systems = systems_of(study), motions = motions_of(study, {});
  }
  CampaignResult run(int shard = 1, int n_shards = 1) const {
    return run_campaign(study, systems, motions, {.folder = folder / "out", .shard = shard, .n_shards = n_shards});
  }
  Results results() const { return evaluate_study(study, systems, motions, folder / "out", nullptr); }
};

} // namespace

TEST(Campaign, PartsCoverEverythingOnce) {
  for (const int n_shards : {1, 2, 3, 7, 20}) {
    std::set<std::pair<std::size_t, int>> seen;
    int n_parts = 0;
    for (int shard = 1; shard <= n_shards; ++shard)
      for (const auto &part : parts_of_shard(7, shard, n_shards)) {
        EXPECT_TRUE(seen.emplace(part.system, part.part).second);
        n_parts = part.n_parts;
      }
    EXPECT_EQ(seen.size(), 7u * static_cast<unsigned>(n_parts));
  }
}

/// After a resumption most systems are kept, and the one at hand in part: they do not shorten what is to go.
TEST(Campaign, KeptRunsDoNotCountInThePace) {
  Pace pace;
  for (int system = 0; system < 200; ++system) pace.add({.total = 155, .kept = 155, .seconds = 0.2});
  EXPECT_NEAR(pace.seconds_a_run({.done = 85, .total = 155, .failed = 0, .seconds = 0.5, .seconds_left = 7}), 0.1,
              1e-12);
  pace.add({.total = 155, .kept = 80, .seconds = 7.5});
  EXPECT_NEAR(pace.seconds_a_run({.done = 155, .total = 155, .failed = 0, .seconds = 1, .seconds_left = 0}), 0.1,
              1e-12);
}

TEST(Campaign, FromFileToTables) {
  const Small small;
  const auto done = small.run();
  EXPECT_EQ(done.runs, 2u * 2 * 3 * 3); // systems, levels, records, samples
  EXPECT_EQ(done.without_result, 0u);
  EXPECT_EQ(small.run().kept, done.runs);
  const auto results = small.results();
  EXPECT_EQ(results.tables.at("fragility").rows.size(), 2u * 2 * 3);
  EXPECT_EQ(results.tables.at("reliability").rows.size(), 2u * 3);
  EXPECT_EQ(results.tables.at("difference").rows.size(), 3u);
  EXPECT_EQ(results.tables.at("sensitivity").rows.size(), 2u * 3);
  EXPECT_EQ(results.tables.at("hits").rows.size(), 2u * 2);
  EXPECT_EQ(results.summary["hits"]["n_runs"], done.runs);
  EXPECT_TRUE(results.summary["hits"]["share_beyond_fit"].is_null()) << "its element has no known range";
  const auto doubts = results.summary["doubts"].dump();
  EXPECT_NE(doubts.find("100 % of the hits on the rim"), std::string::npos) << doubts;
  EXPECT_NE(doubts.find("the levels begin too high"), std::string::npos) << doubts;
  EXPECT_EQ(doubts.find("plausible"), std::string::npos) << doubts;
  Study bounded = small.study; // by [plausible] of the study
  bounded.parts.plausible["peak_displacement_m"] = 1e-4;
  const auto doubted =
      evaluate_study(bounded, small.systems, small.motions, small.folder / "out", nullptr).summary["doubts"].dump();
  EXPECT_NE(doubted.find("system 1: 18 runs have a peak_displacement_m beyond 0.0001"), std::string::npos) << doubted;
  write_results(results, small.folder / "out");
  EXPECT_TRUE(std::filesystem::exists(small.folder / "out/reliability.h5"));
  EXPECT_EQ(read_table(small.folder / "out/ida.csv").rows.size(), 4u);
}

// what came after a rim failed is no result: only the travel counts, and all is said
TEST(Campaign, RunsThroughTheirRimAreUnknown) {
  const Small small;
  small.run();
  const std::string path = folder_of_system(small.folder / "out", 0) + "/table.csv";
  Table table = read_table(path);
  const auto column = [&](const char *name) {
    return std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin();
  };
  for (const std::size_t row : {0, 4}) table.rows[row][column("beyond_rim")] = 1.0;
  table.rows[0][column("n_impacts")] = 1.0, table.rows[4][column("n_impacts")] = 0.0;
  write_csv(table, path);
  const auto set = collect(small.study, folder_of_system(small.folder / "out", 0), small.motions);
  EXPECT_EQ(set.n_through_rim, 1);
  EXPECT_EQ(set.n_past_wall, 1);
  ASSERT_EQ(set.levels[0].unfinished.size(), 1u);
  EXPECT_GT(set.levels[0].unfinished[0].values[0], 0);
  auto doubts = small.results().summary["doubts"].get<std::vector<std::string>>();
  std::erase_if(doubts, [](const std::string &doubt) { return !doubt.starts_with("system 1: "); });
  ASSERT_EQ(doubts.size(), 2u);
  EXPECT_NE(doubts[0].find("system 1: 1 runs pressed deeper into the rim"), std::string::npos) << doubts[0];
  EXPECT_NE(doubts[1].find("past the wall of a rim that they leave out"), std::string::npos) << doubts[1];
  Study forces = small.study;
  forces.limits = {{"peak_lateral_force_N", {1e5}}};
  const auto other = collect(forces, folder_of_system(small.folder / "out", 0), small.motions);
  EXPECT_TRUE(std::isnan(other.levels[0].unfinished[0].values[0]));
}

TEST(Campaign, ShardsAreGatheredAsOneCallWouldRunThem) {
  const Small whole, parts;
  whole.run();
  for (int shard = 1; shard <= 3; ++shard) parts.run(shard, 3); // more shards than systems
  const auto gathered = parts.run();
  EXPECT_EQ(gathered.kept, gathered.runs);
  const auto a = whole.results(), b = parts.results();
  EXPECT_EQ(a.tables.at("reliability").rows, b.tables.at("reliability").rows);
}

TEST(Campaign, ASystemAtWorkIsLeftToItsProcess) {
  const Small small;
  std::filesystem::create_directories(folder_of_system(small.folder / "out", 0));
  const FolderLock other(folder_of_system(small.folder / "out", 0));
  expect_error<IoError>([&] { small.run(); }, {"systems/0001"});
}

TEST(Campaign, PlanCountsItsRuns) {
  const Small small;
  const auto plan = plan_study(small.study, small.systems, small.motions, 2);
  EXPECT_EQ(plan.runs, 36u);
  EXPECT_GT(plan.seconds_a_run, 0);
  EXPECT_NEAR(plan.core_hours, 36 * plan.seconds_a_run / 3600, 1e-12);
  EXPECT_GT(plan.table_bytes, 36 * 200);
}
