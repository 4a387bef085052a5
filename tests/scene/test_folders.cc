// What results are of (identity), what a folder holds (kept runs), whose it is (locks), and what may name it.
#include "expect_error.h"
#include "io/files/digest.h"
#include "io/files/file.h"
#include "io/files/folder_lock.h"
#include "responses/kept_run.h"
#include "responses/physics_version.h"
#include "responses/run_folder.h"
#include "responses/summary.h"
#include "scene/names.h"
#include "scene/toml_writer.h"
#include "temporary_folder.h"
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {
using namespace rimpact;
using namespace rimpact::scene;

std::string csv(double peak) {
  return fmt::format("time_s,acceleration_g\n0,0\n0.5,{}\n1.0,0\n", peak);
}
Scene record_scene(const TemporaryFolder &folder, double peak) {
  folder.write("q.csv", csv(peak));
  return parse_scene("[excitation]\nkind = \"record\"\nx = \"q.csv\"\n", "s.toml", {}, folder.path());
}
void write_run(const std::string &folder, const Scene &scene) {
  Response response;
  for (const char *name : {"time", "displacement_x", "displacement_y", "displacement_z", "force_x", "force_y",
                           "force_z", "impact_x", "impact_y", "gap"})
    response.append(name, 0);
  write_run_folder(folder, scene, response, Summary());
}

TEST(Digest, IsThatOfSha256sum) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const TemporaryFolder folder;
  EXPECT_EQ(sha256_of_file(folder.write("f", "abc")), sha256("abc"));
}

TEST(Identity, ChangesWithTheContentsOfARecordAndNotWithItsName) {
  const TemporaryFolder folder;
  const auto before = identity_of(record_scene(folder, 0.5));
  ASSERT_EQ(before.inputs.size(), 1u);
  EXPECT_EQ(before.inputs.begin()->first, folder / "q.csv");
  EXPECT_EQ(identity_of(record_scene(folder, 0.5)), before);
  const auto after = identity_of(record_scene(folder, 0.6));
  EXPECT_EQ(before.scene, after.scene);
  EXPECT_EQ(changes(before, after), "the file " + folder / "q.csv" + " changed");
  EXPECT_EQ(changes(before, before), "");
}

/// gmsh has words that open another file and that no list of refused ones holds for sure.
TEST(Identity, HoldsTheFilesThatAScriptNames) {
  const TemporaryFolder folder;
  folder.write("plate.step", "ISO-10303-21;");
  folder.write("inner.geo", "v() = ShapeFromFile('plate.step');\n");
  folder.write("bearing.geo", "// \"none.step\"\nShapeFromFile(\"inner.geo\"); Physical Volume(\"slider\") = {1};\n");
  Scene scene = load_scene("impact-window");
  scene.model.own_mesh.file = folder / "bearing.geo";
  const auto before = identity_of(scene);
  ASSERT_EQ(before.inputs.size(), 3u);
  EXPECT_TRUE(before.inputs.contains(folder / "inner.geo"));
  folder.write("plate.step", "ISO-10303-21; END;");
  EXPECT_EQ(changes(before, identity_of(scene)), "the file " + folder / "plate.step" + " changed");
  folder.write("plate.step", "ISO-10303-21;");
  folder.write("none.step", "ISO-10303-21;");
  EXPECT_EQ(changes(before, identity_of(scene)), "the file " + folder / "none.step" + " was not read");
  scene.model.own_mesh.file = folder.write("bearing.msh", "\"plate.step\"");
  EXPECT_EQ(identity_of(scene).inputs.size(), 1u) << "data name no files";
}

TEST(Identity, KnowsSceneAndProgramApart) {
  const auto a = identity_of(load_scene("impact-window")),
             b = identity_of(load_scene("impact-window", {"excitation.speed_m_per_s=0.2"}));
  EXPECT_EQ(changes(a, b), "the scene changed");
  auto other = a;
  other.build = "another";
  EXPECT_NE(changes(other, a).find("another version of the program"), std::string::npos);
  EXPECT_EQ(physics_version().size(), 64u);
  EXPECT_EQ(identity_from(to_json(a)), a);
  for (const char *text : {"{}", "3", "null", R"({"scene": 1, "inputs": {}, "build": "b"})",
                           R"({"scene": "", "inputs": [1], "build": "b"})"})
    EXPECT_FALSE(identity_from(nlohmann::json::parse(text))) << text;
}

TEST(ResolvedKeys, AreValuesWithoutComments) {
  const auto keys = resolved_keys(
      "name = \"a # b\"   # said\n\n[excitation]\nscale = 1.0 # assumption\nlist = [1,\n  2,\n  3]\n[a.b]\nc = true\n");
  EXPECT_EQ(keys.at("name"), "\"a # b\"");
  EXPECT_EQ(keys.at("excitation.scale"), "1.0");
  EXPECT_EQ(keys.at("excitation.list"), "[1, 2, 3]");
  EXPECT_EQ(keys.at("a.b.c"), "true");
  EXPECT_EQ(keys.size(), 4u);
}

TEST(SceneDifferences, NameKeyAndBothValues) {
  const std::string one = to_toml(load_scene("impact-window")),
                    other = to_toml(load_scene("impact-window", {"excitation.speed_m_per_s=0.2"}));
  EXPECT_EQ(scene_differences(one, one), "");
  EXPECT_NE(scene_differences(one, other).find("excitation.speed_m_per_s is 0.1 there and 0.2 here"), std::string::npos)
      << scene_differences(one, other);
  EXPECT_NE(scene_differences(one, to_toml(load_scene("ricker-0.78g-1.0s"))).find("more"), std::string::npos);
}

TEST(KeptRun, SaysWhatDiffers) {
  const TemporaryFolder folder;
  const std::string run = folder / "run";
  const Scene scene = record_scene(folder, 0.5);
  EXPECT_FALSE(kept_run(run, scene).any);
  write_run(run, scene);
  EXPECT_TRUE(kept_run(run, scene).is_current());
  EXPECT_EQ(kept_run(run, scene).status, RunStatus::done);
  Scene moved = scene;
  moved.load.mass = 1e5;
  EXPECT_NE(kept_run(run, moved).other_scene.find("load.mass_kg"), std::string::npos);
  const auto edited = kept_run(run, record_scene(folder, 0.6));
  EXPECT_EQ(edited.other_scene, "");
  EXPECT_NE(edited.changed.find("q.csv changed"), std::string::npos) << edited.changed;
  record_scene(folder, 0.5);
  auto summary = read_summary(run);
  summary.erase("identity");
  folder.write("run/summary.json", summary.dump());
  EXPECT_NE(kept_run(run, scene).changed.find("older version"), std::string::npos);
}

TEST(Summaries, ThatAreDamagedAreRefusedInOneSentence) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_summary(folder.path()).empty());
  for (const auto &[text, needle] : {std::pair{"{", "not a JSON object"},
                                     {"[]", "not a JSON object"},
                                     {R"({"status": 3})", "`status` must be a text, got 3"},
                                     {R"({"status": null})", "status"},
                                     {R"({"impacts": "X"})", "`impacts` must be a list"},
                                     {R"({"impacts": [1]})", "impacts"},
                                     {R"({"impacts": [{"peak_force_N": "big"}]})", "peak_force_N"},
                                     {R"({"n_impacts": "two"})", "n_impacts"},
                                     {R"({"energy": 1})", "energy"},
                                     {R"({"wall_time_s": []})", "wall_time_s"}}) {
    folder.write("summary.json", text);
    expect_error<DataError>([&] { read_summary(folder.path()); }, {"summary.json is damaged", needle});
  }
  folder.write("summary.json", R"({"peak_impact_force_N": null, "mesh": null})");
  EXPECT_NO_THROW(read_summary(folder.path()));
}

TEST(FolderLock, IsHeldByOneAndGoneWithIt) {
  const TemporaryFolder folder;
  const std::string run = folder / "a/run";
  {
    const FolderLock lock(run);
    expect_error<IoError>([&] { FolderLock second(run); },
                          {run.c_str(), "in use by process", std::to_string(::getpid()).c_str(), "-o"});
    const FolderLock part(run, "2-of-3"); // shards run side by side
  }
  EXPECT_FALSE(std::filesystem::exists(run)) << "an empty folder that it made goes with it";
  std::filesystem::create_directories(run);
  folder.write("a/run/.rimpact.lock", "process 1 on another host, killed\n"); // left by a crash: nobody holds it
  { const FolderLock lock(run); }
  EXPECT_TRUE(std::filesystem::is_empty(run));
  expect_error<IoError>([] { FolderLock nowhere("/proc/nowhere"); }, {"/proc/nowhere"});
}

TEST(Files, ThatNeverEndOrAreNoneAreRefused) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  expect_error<DataError>([&] { read_file(folder / "pipe"); }, {"pipe", "a file is needed"});
  expect_error<DataError>([] { read_file("/proc/self/mem"); }, {"/proc/self/mem", "cannot be read"});
  expect_error<IoError>([&] { write_atomically("x", folder / "pipe"); }, {"pipe", "no file"});
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
  const std::string big(3'000'000, 'x');
  EXPECT_EQ(read_file(folder.write("big", big)), big);
}

TEST(Removal, LeavesWhatIsTheUsers) {
  const TemporaryFolder folder;
  const std::string run = folder / "run";
  write_run(run, load_scene("impact-window"));
  std::filesystem::create_directories(run + "/fields");
  for (const char *name : {"run/fields/rim_001.vtu", "run/fields.pvd", "run/checkpoint.h5", "run/response.png",
                           "run/bearing.toml", "run/notes.txt", "run/.response.h5.123.tmp", "run/.mine.tmp"})
    folder.write(name, "x");
  remove_by_products(run);
  for (const char *gone : {"/fields", "/fields.pvd", "/checkpoint.h5", "/response.png", "/.response.h5.123.tmp"})
    EXPECT_FALSE(std::filesystem::exists(run + gone)) << gone;
  EXPECT_TRUE(std::filesystem::exists(run + "/summary.json"));
  remove_run(run);
  for (const char *gone : {"/summary.json", "/response.h5", "/response.csv"})
    EXPECT_FALSE(std::filesystem::exists(run + gone)) << gone;
  for (const char *stays : {"/scene.toml", "/bearing.toml", "/notes.txt", "/.mine.tmp"})
    EXPECT_TRUE(std::filesystem::exists(run + stays)) << stays;
}

TEST(Names, ThatLeadElsewhereAreRefused) {
  for (const std::string name : {"..", ".", "", "a/b", "../../../x", "\xe9"}) {
    Scene scene = load_scene("impact-window");
    scene.name = name;
    expect_error<InputError>([&] { scene.validate(); }, {"name"});
  }
  expect_error<InputError>([] { parse_scene("", "caf\xe9.toml"); }, {"name", "UTF-8"});
  EXPECT_EQ(parse_scene("name = \"cafe\"\n", "caf\xe9.toml").name, "cafe");
  const TemporaryFolder folder;
  folder.write("q\xe9.csv", csv(0.5));
  Scene scene = record_scene(folder, 0.5);
  scene.excitation.x_file = folder / "q\xe9.csv";
  expect_error<InputError>([&] { scene.validate(); }, {"excitation.x", "UTF-8"});
}

TEST(Names, AreFoldersWithoutSurprises) {
  for (const auto &[name, folder] : {std::pair{"window-0.2", "window-0.2"},
                                     {"caf\xc3\xa9 \xe6\xb0\xb4", "caf\xc3\xa9 \xe6\xb0\xb4"},
                                     {"a\nb\x1b[31m", "a_b_[31m"},
                                     {".hidden", "_hidden"},
                                     {"-o", "_o"},
                                     {"a/b", "a_b"},
                                     {"", "scene"}})
    EXPECT_EQ(folder_name(name), folder);
  EXPECT_EQ(folder_name(std::string(300, 'x')).size(), 100u);
  std::string euros;
  for (int k = 0; k < 60; ++k) euros += "\xe2\x82\xac";
  EXPECT_EQ(folder_name(euros).size(), 99u); // not in the middle of a character
  EXPECT_EQ(printable("a\x1b[2J\xff\tb\n"), "a?[2J?\tb\n");
  EXPECT_TRUE(is_utf8("\xf0\x9f\x8c\x89"));
  for (const char *bad : {"\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\x80"})
    EXPECT_FALSE(is_utf8(bad));
}

} // namespace
