// Restarts: N steps are k steps, a checkpoint, and N - k steps; what is not this system's checkpoint is refused.
#include "blocks.h"
#include "fe_contact/drive/record_checkpoint.h"
#include "fe_contact/drive/state_fields.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "responses/identity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <unistd.h>

namespace rimpact::fe {
namespace {

/// A checkpoint file that is gone at the end of its scope.
struct File {
  std::string path =
      (std::filesystem::temp_directory_path() / ("rimpact_restart_" + std::to_string(::getpid()) + ".h5")).string();
  ~File() { std::filesystem::remove(path); }
};

void keep(ContactSystem &system, SystemState &state, const std::string &path, MotionPoint *point = nullptr) {
  Checkpoint file;
  StateWriter writer(file);
  visit(writer, state);
  if (point) visit(writer, *point);
  write_checkpoint(file, path);
  system.start_afresh_at(state);
}

SystemState resume(ContactSystem &system, const std::string &path, MotionPoint *point = nullptr) {
  SystemState state = system.at_rest();
  const Checkpoint file = read_checkpoint(path);
  StateReader reader(file);
  visit(reader, state);
  if (point) visit(reader, *point);
  system.start_afresh_at(state);
  return state;
}

enum class Way { straight, kept, resumed };

/// Eight steps that press and drag a block until part of it slips; after the fourth a checkpoint.
SystemState dragged(Way way, double tolerance, std::vector<ContactStatus> *at_checkpoint = nullptr) {
  const File file;
  StepOptions options;
  options.newton.tolerance = tolerance;
  std::optional<Block> block(std::in_place, FrictionCoefficient{0.3, 0.2, 50});
  SystemState state = block->system->at_rest();
  for (int k = 1; k <= 8; ++k) {
    EXPECT_TRUE(static_step(*block->system, state, block->drive(6e-6 * k, 1e-4, 1e-3), options).converged) << k;
    if (k != 4 || way == Way::straight) continue;
    state.growth_hold = 2; // static steps leave it
    if (at_checkpoint) *at_checkpoint = state.contacts[0].status;
    keep(*block->system, state, file.path);
    if (way != Way::resumed) continue;
    block.emplace(FrictionCoefficient{0.3, 0.2, 50}); // nothing of the first process is left
    state = resume(*block->system, file.path);
    if (at_checkpoint) {
      EXPECT_EQ(state.contacts[0].status, *at_checkpoint);
    }
  }
  return state;
}

void expect_equal(const SystemState &a, const SystemState &b) {
  EXPECT_EQ((a.u - b.u).norm(), 0);
  EXPECT_EQ((a.v - b.v).norm(), 0);
  EXPECT_EQ((a.a - b.a).norm(), 0);
  EXPECT_EQ(a.growth_hold, b.growth_hold);
  EXPECT_EQ(a.contacts[0].pressure, b.contacts[0].pressure);
  EXPECT_EQ(a.contacts[0].status, b.contacts[0].status);
  EXPECT_EQ((a.reports[0].friction - b.reports[0].friction).norm(), 0);
}

TEST(Restart, MidSlipItIsExactToTheLastBit) {
  std::vector<ContactStatus> status;
  const SystemState resumed = dragged(Way::resumed, 1e-8, &status);
  // Otherwise nothing would be shown: at the checkpoint some points slip and some stick.
  EXPECT_GT(std::count(status.begin(), status.end(), ContactStatus::slip), 0);
  EXPECT_GT(std::count(status.begin(), status.end(), ContactStatus::stick), 0);
  expect_equal(dragged(Way::kept, 1e-8), resumed);
}

TEST(Restart, MidSlipItAgreesWithARunThatNeverStopped) {
  const SystemState straight = dragged(Way::straight, 1e-10), resumed = dragged(Way::resumed, 1e-10);
  EXPECT_LT((straight.u - resumed.u).norm(), 1e-10 * straight.u.norm());
  EXPECT_LT((straight.reports[0].friction - resumed.reports[0].friction).norm(),
            1e-10 * straight.reports[0].friction.norm());
  EXPECT_EQ(straight.contacts[0].status, resumed.contacts[0].status);
}

/// Flight, impact and rebound; the checkpoint falls on the twentieth step, in the middle of contact.
std::pair<SystemState, MotionReport> impact(Way way, const scene::StrainRate &rate = {}) {
  constexpr double end = 14e-6;
  const File file;
  Bar bar(rate);
  SystemState state = bar.thrown();
  int steps = 0;
  MotionPoint kept_at;
  bar.after_point = [&](const MotionPoint &point) {
    if (++steps != 20 || way == Way::straight) return;
    EXPECT_GT(state.reports[0].stick + state.reports[0].slip, 0);
    EXPECT_GT(state.energies.plastic, 0);
    kept_at = point;
    keep(*bar.system, state, file.path, &kept_at);
  };
  MotionReport report = bar.run(state, end);
  EXPECT_TRUE(report.march.finished) << report.march.reason;
  EXPECT_GT(steps, 30);
  if (way != Way::resumed) return {state, report};
  Bar second(rate);
  SystemState resumed = resume(*second.system, file.path, &second.from);
  EXPECT_EQ(second.from.t, kept_at.t);
  report = second.run(resumed, end);
  EXPECT_TRUE(report.march.finished) << report.march.reason;
  return {resumed, report};
}

TEST(Restart, MidImpactItIsExactToTheLastBitWithItsLedger) {
  const auto [kept, kept_report] = impact(Way::kept);
  const auto [resumed, resumed_report] = impact(Way::resumed);
  expect_equal(kept, resumed);
  EXPECT_EQ(kept_report.ledger.plastic, resumed_report.ledger.plastic);
  EXPECT_EQ(kept_report.ledger.integrator, resumed_report.ledger.integrator);
  EXPECT_EQ(kept_report.imbalance(), resumed_report.imbalance());
  EXPECT_LT(resumed_report.imbalance(), 5e-3);
}

TEST(Restart, MidImpactItIsExactToTheLastBitWhereTheSteelKnowsItsRate) {
  const scene::StrainRate rate{.model = scene::RateModel::cowper_symonds};
  const auto [kept, kept_report] = impact(Way::kept, rate);
  const auto [resumed, resumed_report] = impact(Way::resumed, rate);
  expect_equal(kept, resumed);
  double viscous = 0;
  for (std::size_t k = 0; k < kept.history.size(); ++k) {
    EXPECT_EQ(kept.history[k].overstress, resumed.history[k].overstress);
    EXPECT_EQ(kept.history[k].viscous_work, resumed.history[k].viscous_work);
    viscous = std::max(viscous, kept.history[k].viscous_work);
  }
  EXPECT_GT(viscous, 0);
  EXPECT_EQ(kept_report.ledger.plastic, resumed_report.ledger.plastic);
  EXPECT_EQ(kept_report.imbalance(), resumed_report.imbalance());
}

TEST(Restart, ACheckpointOfAnotherMeshIsRefused) {
  const File file;
  Block quadratic(FrictionCoefficient::constant(0.3), 2), linear(FrictionCoefficient::constant(0.3), 1);
  SystemState at_rest = quadratic.system->at_rest();
  keep(*quadratic.system, at_rest, file.path);
  try {
    resume(*linear.system, file.path);
    FAIL() << "another mesh's checkpoint was taken";
  } catch (const DataError &error) {
    EXPECT_NE(std::string(error.what()).find("are due"), std::string::npos) << error.what();
  }
}

std::string sentence_of(const std::function<void()> &read) {
  try {
    read();
  } catch (const DataError &error) {
    return error.what();
  }
  return "nothing was thrown";
}
bool tells(const std::string &sentence, const std::string &part) {
  return sentence.find(part) != std::string::npos;
}

TEST(Restart, ACheckpointOfAnotherVersionSceneOrHalfWrittenIsRefused) {
  RunOptions options;
  options.folder = std::filesystem::temp_directory_path() / ("rimpact_restart_" + std::to_string(::getpid()));
  std::filesystem::create_directories(options.folder);
  const std::string path = checkpoint_of(options);
  const auto identity = to_json(identity_of(scene::load_scene("static-unidirectional")));
  RunRecord record;
  record.identity = identity;
  const auto read = [&] { return sentence_of([&] { kept_checkpoint(options, record); }); };
  EXPECT_TRUE(tells(read(), "nothing to resume")) << read();
  begin_checkpoint(options, record);
  EXPECT_TRUE(has_only_begun(kept_checkpoint(options, record)));
  Checkpoint checkpoint;
  StateWriter writer(checkpoint);
  visit(writer, record);
  write_checkpoint(checkpoint, path);
  EXPECT_FALSE(has_only_begun(kept_checkpoint(options, record)));
  record.identity = to_json(identity_of(scene::load_scene("static-unidirectional", {"model.mesh=2"})));
  EXPECT_TRUE(tells(read(), "another run: the scene changed since")) << read();
  record.identity = identity;
  record.identity["build"] = "an older one";
  EXPECT_TRUE(tells(read(), "another version of the program")) << read();
  record.identity = identity;
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_TRUE(tells(read(), "checksum")) << read();
  std::filesystem::resize_file(path, 100);
  EXPECT_TRUE(tells(read(), "is damaged")) << read();
  std::filesystem::remove_all(options.folder);
}

TEST(Restart, EveryFlippedBitIsFound) {
  const File file;
  Checkpoint checkpoint;
  checkpoint.numbers["a"] = {1, 2, 3};
  write_checkpoint(checkpoint, file.path);
  const std::string whole = read_file(file.path);
  EXPECT_EQ(read_checkpoint(file.path).field("a", 3), checkpoint.numbers["a"]);
  for (std::size_t k = 0; k < whole.size(); k += 37) {
    std::string bytes = whole;
    bytes[k] = static_cast<char>(bytes[k] ^ (1 << (k % 8)));
    write_atomically(bytes, file.path);
    EXPECT_TRUE(tells(sentence_of([&] { read_checkpoint(file.path); }), "run without --resume")) << k;
  }
}

TEST(Restart, FieldsAreWhatIsDue) {
  Checkpoint file;
  file.path = "F/checkpoint.h5";
  file.numbers = {{"a", {1, 2, 3}}, {"whole", {1.5}}, {"bad", {std::nan("")}}, {"huge", {1e300}}};
  EXPECT_EQ(sentence_of([&] { file.field("a", 4); }),
            "F/checkpoint.h5 is damaged (field a has 3 values, 4 are due); run without --resume to start afresh");
  for (const auto &[name, limits] :
       {std::pair{"missing", Limits{}}, {"whole", count}, {"bad", Limits{}}, {"bad", infinite_too}, {"huge", Limits{}}})
    EXPECT_TRUE(tells(sentence_of([&] { file.field(name, 1, limits); }), std::string("field ") + name)) << name;
  EXPECT_EQ(file.number("whole", {1, 2}), 1.5);
}

enum class Colour { red, blue };
constexpr auto choices(Colour) {
  return choices_of<Colour>({{Colour::red, "red"}, {Colour::blue, "blue"}});
}

TEST(Restart, AVisitorReadsWhatItHasWrittenAndRefusesWhatCannotBe) {
  Checkpoint file;
  StateWriter writer(file);
  std::vector<Impact> impacts{{0.1, 0.2, 30, 0.5, 0.2, 1e6, 0.01}, {1.1, 1.2, 210, 0.4, 0.1, 2e6, 0.02}};
  Colour colour = Colour::blue;
  writer.part("hits", [&] { visit(writer, impacts); });
  writer.choice("colour", colour);
  StateReader reader(file);
  std::vector<Impact> read;
  Colour seen = Colour::red;
  const auto take = [&] {
    read.clear();
    reader.part("hits", [&] { visit(reader, read); });
    reader.choice("colour", seen);
  };
  take();
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].peak_force, 2e6);
  EXPECT_EQ(read[0].restitution(), impacts[0].restitution());
  EXPECT_EQ(seen, Colour::blue);
  file.texts["colour"] = "green";
  EXPECT_TRUE(tells(sentence_of(take), "field colour is no word of its list")) << sentence_of(take);
  file.numbers["hits_number"] = {3};
  EXPECT_TRUE(tells(sentence_of(take), "field hits_touch_time has 2 values, 3 are due")) << sentence_of(take);
}

} // namespace
} // namespace rimpact::fe
