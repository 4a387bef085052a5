// Fleets on a small sweep of a short scene.
#include "../scene/expect_error.h"
#include "../scene/temporary_folder.h"
#include "io/files/file.h"
#include "io/files/folder_lock.h"
#include "io/files/table_csv.h"
#include "reduced_models/bearings/physical_model.h"
#include "reduced_models/simulate.h"
#include "responses/identity.h"
#include "responses/physics_version.h"
#include "studies/fleets/fleet.h"
#include "studies/fleets/fleet_folder.h"
#include "studies/fleets/fleet_table.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

using namespace rimpact;
using namespace rimpact::fleets;
namespace fs = std::filesystem;

namespace {

const char *const pulses = "[grid]\nexcitation.scale = { from = 0.5, to = 1.4, count = 10 }\n"
                           "excitation.duration_s = [8.0]\nreduced.mu_fast = [0.03, 0.07]\n"
                           "[linked]\nreduced.mu_slow = { product = ['reduced.mu_fast'] }\n";

FleetOptions options(const std::string &folder) {
  FleetOptions o;
  o.folder = folder, o.n_threads = 2;
  return o;
}
FleetResult run(const std::string &folder, const std::string &sweep = pulses) {
  return run_fleet("ricker-0.78g-1.0s", {}, parse_sweep(sweep, "s.toml"), options(folder));
}
/// All but the time a run took.
Table timeless(const std::string &path) {
  Table t = read_table(path);
  const auto i = std::find(t.columns.begin(), t.columns.end(), "wall_time_s") - t.columns.begin();
  for (auto &row : t.rows) row.at(static_cast<std::size_t>(i)) = Cell{};
  return t;
}
Cell at(const Table &t, std::size_t row, const std::string &name) {
  const auto i = std::find(t.columns.begin(), t.columns.end(), name) - t.columns.begin();
  return t.rows.at(row).at(static_cast<std::size_t>(i));
}

} // namespace

TEST(Fleet, RowsAreThoseOfSingleRuns) {
  const TemporaryFolder folder;
  const auto result = run(folder / "f");
  EXPECT_EQ(result.total, 20u);
  EXPECT_EQ(result.done, 20u);
  const auto t = read_table(folder / "f/table.csv");
  ASSERT_EQ(t.rows.size(), 20u);
  int n_with_impact = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    const auto scale = std::get<double>(at(t, i, "excitation.scale"));
    const auto mu = std::get<double>(at(t, i, "reduced.mu_fast"));
    const auto single = reduced::simulate_summary(scene::load_scene(
        "ricker-0.78g-1.0s", {"excitation.scale=" + std::to_string(scale), "reduced.mu_fast=" + std::to_string(mu)}));
    EXPECT_EQ(at(t, i, "run"), Cell(double(i + 1)));
    EXPECT_EQ(at(t, i, "n_impacts"), Cell(double(single.impacts.size())));
    EXPECT_NEAR(std::get<double>(at(t, i, "peak_displacement_m")), single.peak_displacement, 1e-6);
    const auto speed = at(t, i, "first_approach_speed_m_s");
    EXPECT_EQ(speed.index() == 1, !single.impacts.empty());
    n_with_impact += !single.impacts.empty();
  }
  EXPECT_GT(n_with_impact, 3);
  EXPECT_LT(n_with_impact, 18);
}

TEST(Fleet, ASecondCallRunsOnlyWhatIsMissing) {
  const TemporaryFolder folder;
  run(folder / "f");
  const auto whole = timeless(folder / "f/table.csv");
  Table part = read_table(folder / "f/table.csv");
  part.rows.erase(part.rows.begin() + 3, part.rows.begin() + 10);
  part.rows[0].back() = std::string("kept"); // `reason`
  const auto reason = std::find(part.columns.begin(), part.columns.end(), "reason") - part.columns.begin();
  part.rows[0].at(static_cast<std::size_t>(reason)) = std::string("kept");
  write_csv(part, folder / "f/table.csv");
  const auto again = run(folder / "f");
  EXPECT_EQ(again.kept, 13u);
  EXPECT_EQ(again.total, 20u);
  const auto t = timeless(folder / "f/table.csv");
  EXPECT_EQ(at(t, 0, "reason"), Cell(std::string("kept"))); // not run again
  for (std::size_t i = 1; i < 20; ++i) EXPECT_EQ(t.rows.at(i), whole.rows.at(i)) << i;
}

TEST(Fleet, InterruptedAndTakenUpAgain) {
  const TemporaryFolder folder;
  run(folder / "whole");
  std::atomic<bool> stop{false};
  FleetOptions o = options(folder / "f");
  o.n_threads = 1, o.interrupted = &stop;
  o.progress = [&](const FleetProgress &p) { stop = p.done >= 3; };
  const Sweep sweep = parse_sweep(pulses, "s.toml");
  try {
    run_fleet("ricker-0.78g-1.0s", {}, sweep, o);
    FAIL() << "was not interrupted";
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::interrupted);
  }
  const auto n = read_table(folder / "f/table.csv").rows.size();
  EXPECT_GE(n, 3u);
  EXPECT_LT(n, 20u);
  stop = false, o.progress = nullptr;
  EXPECT_EQ(run_fleet("ricker-0.78g-1.0s", {}, sweep, o).kept, n);
  EXPECT_EQ(timeless(folder / "f/table.csv").rows, timeless(folder / "whole/table.csv").rows);
}

TEST(Fleet, ShardsTogetherAreTheWhole) {
  const TemporaryFolder folder;
  run(folder / "whole");
  const Sweep sweep = parse_sweep(pulses, "s.toml");
  FleetOptions o = options(folder / "f");
  o.n_shards = 3;
  for (o.shard = 1; o.shard <= 3; ++o.shard) {
    const auto result = run_fleet("ricker-0.78g-1.0s", {}, sweep, o);
    EXPECT_EQ(result.total, o.shard <= 2 ? 7u : 6u);
    EXPECT_EQ(result.kept, 0u);
  }
  EXPECT_TRUE(fs::exists(folder / "f/table-2-of-3.csv"));
  EXPECT_EQ(run(folder / "f").kept, 20u); // gathers
  EXPECT_EQ(timeless(folder / "f/table.csv").rows, timeless(folder / "whole/table.csv").rows);
}

TEST(Fleet, ARunThatFailsStandsInItsRow) {
  const TemporaryFolder folder;
  // no rim to speak of and too strong a pulse: the slider leaves the dish; a combination no scene can have
  const auto result = run(folder / "f", "[grid]\nexcitation.scale = [0.5, 4.0]\nreduced.k_i_kN_per_m = [0]\n"
                                        "reduced.mu_slow = [0.07, 0.2]\n");
  EXPECT_EQ(result.done, 1u);
  EXPECT_EQ(result.stopped, 1u);
  EXPECT_EQ(result.refused, 2u);
  const auto t = read_table(folder / "f/table.csv");
  int n_refused = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto status = std::get<std::string>(at(t, i, "status")), reason = std::get<std::string>(at(t, i, "reason"));
    EXPECT_EQ(reason.empty(), status == "done");
    if (status == "refused") {
      ++n_refused;
      EXPECT_NE(reason.find("mu_slow"), std::string::npos) << reason;
      EXPECT_EQ(at(t, i, "peak_displacement_m").index(), 0u);
    }
  }
  EXPECT_EQ(n_refused, 2);
}

TEST(Fleet, ARunThatEndsPressedHasNoRebound) {
  Summary summary = reduced::simulate_summary(scene::load_scene("ricker-0.78g-1.0s", {"excitation.scale=1.05"}));
  ASSERT_FALSE(summary.impacts.empty());
  EXPECT_TRUE(row_of(summary).contains("first_rebound_speed_m_s"));
  const double pressed = 0.5 * (summary.impacts[0].touch_time + summary.impacts[0].release_time);
  summary = reduced::simulate_summary(scene::load_scene(
      "ricker-0.78g-1.0s", {"excitation.scale=1.05", fmt::format("excitation.duration_s={}", pressed)}));
  const Row row = row_of(summary);
  EXPECT_TRUE(row.contains("first_approach_speed_m_s"));
  EXPECT_FALSE(row.contains("first_rebound_speed_m_s"));
}

TEST(Fleet, RefusesTheFolderOfAnotherFleet) {
  const TemporaryFolder folder;
  const char *const small = "[grid]\nexcitation.scale = [0.5]\n";
  run(folder / "f", small);
  expect_error<InputError>([&] { run(folder / "f", "[grid]\nexcitation.scale = [0.6]\n"); }, {"/f", "another", "-o"});
  EXPECT_THROW(run_fleet("ricker-0.38g-1.5s", {}, parse_sweep(small, "s.toml"), options(folder / "f")), InputError);
  EXPECT_THROW(
      run_fleet("ricker-0.78g-1.0s", {"reduced.mu_fast=0.08"}, parse_sweep(small, "s.toml"), options(folder / "f")),
      InputError);
}

TEST(Fleet, RowsOfOtherInputsAreMadeAgain) {
  const TemporaryFolder folder;
  const auto csv = [&](double peak) {
    folder.write("q.csv", "time_s,acceleration_g\n0,0\n0.5," + std::to_string(peak) + "\n1.0,0\n");
  };
  const auto scene = [&](const char *more) {
    return folder.write("case/scene.toml",
                        std::string("[excitation]\nkind = \"record\"\nx = \"../q.csv\"\nduration_s = 1.5\n") + more);
  };
  fs::create_directories(folder / "case");
  csv(0.1), scene("");
  std::vector<std::string> remarks;
  FleetOptions o = options(folder / "f");
  o.remark = [&](const std::string &sentence) { remarks.push_back(sentence); };
  const Sweep sweep = parse_sweep("[grid]\nexcitation.scale = [0.5, 1.0]\n", "s.toml");
  const auto again = [&] { return run_fleet(folder / "case", {}, sweep, o); };
  const auto peak = [&] { return std::get<double>(at(read_table(folder / "f/table.csv"), 1, "peak_displacement_m")); };
  again();
  const double before = peak();
  EXPECT_EQ(again().kept, 2u);
  EXPECT_TRUE(remarks.empty());
  csv(0.2); // the record
  EXPECT_EQ(again().kept, 0u);
  EXPECT_GT(peak(), 1.5 * before);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("q.csv changed since"), std::string::npos) << remarks[0];
  scene("[load]\nmass_kg = 80000.0\n"); // the scene, which is a folder
  EXPECT_EQ(again().kept, 0u);
  EXPECT_EQ(remarks.size(), 2u);
  std::string fleet = text_of(folder / "f/fleet.json");
  const auto build = fleet.find(physics_version());
  ASSERT_NE(build, std::string::npos);
  fleet[build] = fleet[build] == 'a' ? 'b' : 'a'; // another version of the program
  folder.write("f/fleet.json", fleet);
  EXPECT_EQ(again().kept, 0u);
  EXPECT_NE(remarks.back().find("another version"), std::string::npos) << remarks.back();
  EXPECT_EQ(again().kept, 2u);
}

TEST(Fleet, ADamagedOrForeignFolderIsRefusedUnlessForced) {
  const TemporaryFolder folder;
  const char *const small = "[grid]\nexcitation.scale = [0.5]\n";
  run(folder / "f", small);
  for (const char *text : {"{", "[]", R"({"identity": 3})", R"({"identity": {}, "scene": 1})",
                           R"({"identity": "x", "scene": "s", "n_runs": "1", "keys": []})"}) {
    folder.write("f/fleet.json", text);
    expect_error<DataError>([&] { run(folder / "f", small); }, {"fleet.json is damaged"});
  }
  FleetOptions o = options(folder / "f");
  o.force = true;
  EXPECT_EQ(run_fleet("ricker-0.78g-1.0s", {}, parse_sweep(small, "s.toml"), o).kept, 0u);
  fs::create_directories(folder / "run");
  folder.write("run/summary.json", "{}");
  expect_error<InputError>([&] { run(folder / "run", small); }, {"holds a run", "--force"});
}

TEST(Fleet, OneProcessAShard) {
  const TemporaryFolder folder;
  const FolderLock held(folder / "f");
  expect_error<IoError>([&] { run(folder / "f"); }, {"in use"});
}

TEST(Fleet, ASceneThatCannotBeReadIsSaidBeforeAnythingRuns) {
  const TemporaryFolder folder;
  EXPECT_THROW(run_fleet("nowhere.toml", {}, parse_sweep(pulses, "s.toml"), options(folder / "f")), InputError);
  EXPECT_FALSE(fs::exists(folder / "f"));
}

TEST(Fleet, WritesAlongTheWay) {
  const TemporaryFolder folder;
  FleetOptions o = options(folder / "f");
  o.flush_seconds = 0, o.n_threads = 1;
  std::size_t seen = 0;
  o.progress = [&](const FleetProgress &p) {
    if (p.done > 1 && p.done < p.total && fs::exists(folder / "f/table.csv"))
      seen = std::max(seen, read_table(folder / "f/table.csv").rows.size());
  };
  std::string many = "[grid]\nexcitation.scale = [0.1"; // enough that the table is written before the last run ends
  for (int k = 1; k < 300; ++k) many += (k % 20 ? ", " : ",\n") + std::to_string(0.1 + 0.001 * k);
  run_fleet("ricker-0.78g-1.0s", {}, parse_sweep(many + "]\n", "s.toml"), o);
  EXPECT_GT(seen, 0u);
}

/// Whatever the key, a file is sought beside the sweep that names it, not in the working folder.
TEST(Fleet, FilesAreSoughtBesideTheSweep) {
  for (const std::string key : {"bearing.file", "bearing.surface.file", "excitation.file", "model.own_mesh.file",
                                "reduced.calibration", "reduced.impact_curve"}) {
    const Sweep sweep = parse_sweep("[grid]\n" + key + " = [\"sub/a.file\"]\n", "/study/here/s.toml");
    EXPECT_EQ(sweep.assignments(0), std::vector<std::string>{key + "=\"/study/here/sub/a.file\""});
  }
}

/// Rows rest on every file that a swept key names: an edited curve makes them stale as an edited record does.
TEST(Fleet, InputsHoldTheFilesOfSweptKeys) {
  const TemporaryFolder folder;
  for (const std::string key : {"reduced.impact_curve", "reduced.calibration"}) {
    const std::string file = folder / "swept.file";
    write_atomically("one", file);
    const Sweep sweep = parse_sweep("[grid]\n" + key + " = [\"" + file + "\"]\n", "s.toml");
    const scene::Scene first = scene::load_scene("ricker-0.78g-1.0s", {});
    const auto before = fleet_identity("ricker-0.78g-1.0s", {}, sweep, first).rows.inputs;
    EXPECT_EQ(before.count(file), 1u) << key;
    write_atomically("another", file);
    EXPECT_NE(fleet_identity("ricker-0.78g-1.0s", {}, sweep, first).rows.inputs.at(file), before.at(file)) << key;
  }
}
