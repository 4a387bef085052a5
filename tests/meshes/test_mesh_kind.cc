// A mesh from foreign hands: what is data, what is a program, and what a program may not do.
#include "io/files/error.h"
#include "meshes/mesh_kind.h"
#include "meshes/mesh_process.h"
#include "meshes/rim_mesh.h"
#include "meshes/sandbox.h"
#include "scene/script_permission.h"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace rimpact::meshes {
namespace {

namespace fs = std::filesystem;

class ForeignMesh : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("rimpact_foreign_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    unsetenv(scene::script_permission);
  }
  void TearDown() override {
    unsetenv(scene::script_permission);
    fs::remove_all(folder_);
  }
  std::string file(const std::string &name, const std::string &text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string marker() const { return (folder_ / "PWNED").string(); }
  /// What reading the file says; "read" when it is accepted.
  static std::string answer(const std::string &path) {
    scene::OwnMesh own;
    own.file = path;
    try {
      read_mesh_apart(own, {});
      return "read";
    } catch (const DataError &error) {
      return error.what();
    }
  }
  fs::path folder_;
};

TEST_F(ForeignMesh, NoEndingMakesAScriptRun) {
  const std::string script = "SystemCall \"touch " + marker() + "\";\n";
  for (const char *name : {"a.msh", "a.geo", "a.GEO", "a.txt", "a", "a.step", "a.stp", "a.opt", "a.pos", "a.gz"}) {
    EXPECT_NE(answer(file(name, script)), "read") << name;
    EXPECT_FALSE(fs::exists(marker())) << name;
  }
}

TEST_F(ForeignMesh, AnOptionFileBesideTheMeshIsNotRun) {
  const std::string path = (folder_ / "mesh.msh").string();
  write_msh(rim_mesh({}, {.level = 0}), path);
  file("mesh.msh.opt", "SystemCall \"touch " + marker() + "\";\n");
  EXPECT_EQ(answer(path), "read");
  EXPECT_FALSE(fs::exists(marker()));
}

TEST_F(ForeignMesh, AScriptNeedsPermissionAndMayNotLeave) {
  const std::string path = file("a.geo", "Point(1) = {0, 0, 0};\n");
  EXPECT_NE(answer(path).find("--allow-script"), std::string::npos);
  setenv(scene::script_permission, "1", 1);
  EXPECT_EQ(answer(path).find("--allow-script"), std::string::npos);
  for (const std::string call :
       {"SystemCall \"x\"", "NonBlockingSystemCall \"x\"", "OnelabRun(\"x\", \"y\")", "Include \"/etc/passwd\"",
        "Merge \"x\"", "Printf(\"x\") > \"f\"", "Save \"f\"", "Exit", "Abort", "Parse [\"x\"]",
        "a() = ListFromFile(\"/etc/passwd\")", "/* Exit */ Exit", "// \n Exit"})
    EXPECT_NE(answer(file("b.geo", "x = 1;\n" + call + ";\n")).find("leaves the script"), std::string::npos) << call;
  EXPECT_EQ(call_that_leaves("// Exit;\n/* Merge */ s = \"SystemCall\"; Exiting_not = 'Save';").find("Exit;"),
            std::string::npos);
}

TEST_F(ForeignMesh, TheKindIsReadFromTheContent) {
  EXPECT_EQ(mesh_kind("$MeshFormat\n2.2 0 8\n"), MeshKind::msh);
  EXPECT_EQ(mesh_kind("\n\r\nISO-10303-21;\n"), MeshKind::step);
  for (const char *other : {"", "Point(1) = {0,0,0};", "$mesh", "x\n$MeshFormat"})
    EXPECT_EQ(mesh_kind(other), MeshKind::script) << other;
}

TEST_F(ForeignMesh, DamagedDataIsRefusedWithASentence) {
  const std::string path = (folder_ / "mesh.msh").string();
  write_msh(rim_mesh({}, {.level = 0}), path);
  const auto size = fs::file_size(path);
  for (const double share : {0.01, 0.3, 0.7, 0.99}) {
    fs::resize_file(path, static_cast<std::uintmax_t>(share * size));
    EXPECT_NE(answer(path), "read") << share;
    write_msh(rim_mesh({}, {.level = 0}), path);
  }
}

/// What a confined process can still do, as its exit code.
template <class Act> int confined(Act act) {
  const pid_t child = fork();
  if (child == 0) _exit(confine(60, 1ul << 40) ? act() : 99);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST_F(ForeignMesh, AConfinedProcessStartsNothingAndWritesNothing) {
  const std::string path = file("readable", "x");
  const int programs = confined([] {
    pid_t started = 0;
    std::string name = "true";
    char *const words[] = {name.data(), nullptr};
    return posix_spawnp(&started, name.c_str(), nullptr, nullptr, words, environ) == 0 ? 1 : 0;
  });
  if (programs == 99) GTEST_SKIP() << "this kernel offers no system-call filter";
  EXPECT_EQ(programs, 0);
  EXPECT_EQ(confined([&] { return std::ofstream(marker()).good() ? 1 : 0; }), 0);
  EXPECT_EQ(confined([&] { return std::remove(path.c_str()) == 0 ? 1 : 0; }), 0);
  EXPECT_EQ(confined([&] { return ::rename(path.c_str(), marker().c_str()) == 0 ? 1 : 0; }), 0);
  EXPECT_EQ(confined([] { return ::socket(AF_INET, SOCK_STREAM, 0) >= 0 ? 1 : 0; }), 0);
  EXPECT_EQ(confined([] { return ::fork() >= 0 ? 1 : 0; }), 0);
  for (const int mode : {O_WRONLY, O_RDWR, O_RDONLY | O_TRUNC})
    EXPECT_EQ(confined([&] { return ::open(path.c_str(), mode) >= 0 ? 1 : 0; }), 0) << mode;
  EXPECT_EQ(confined([&] { return std::ifstream(path).good() ? 0 : 1; }), 0); // reading goes on, and so do threads
  EXPECT_EQ(confined([] {
              int seen = 1;
              std::thread([&] { seen = 0; }).join();
              return seen;
            }),
            0);
}

} // namespace
} // namespace rimpact::meshes
