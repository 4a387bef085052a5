// Paths from files: corners by the share of their length, times, and what a bad file is told.
#include "io/files/error.h"
#include "io/files/file.h"
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace rimpact;
using namespace rimpact::scene;

namespace {

struct PathFile {
  explicit PathFile(const std::string &text)
      : name((std::filesystem::temp_directory_path() / ("rimpact_path_" + std::to_string(::getpid()) + ".csv"))
                 .string()) {
    write_atomically(text, name);
  }
  ~PathFile() { std::filesystem::remove(name); }
  const std::string name;
};

std::string refusal_of(const std::string &text) {
  const PathFile file(text);
  try {
    read_path_table(file.name);
  } catch (const DataError &error) {
    return std::string(error.what()).substr(file.name.size());
  }
  return "taken";
}

TEST(PathTable, GoesFromCornerToCornerByTheShareOfItsLength) {
  const PathFile file("# a test\ntime_s,x_mm,y_m\n0,0,0\n2,30,0\n3,30,0\n4,0,0.04\n");
  const PathTable path = read_path_table(file.name);
  EXPECT_NEAR(path.length(), 0.03 + 0.05, 1e-15);
  EXPECT_NEAR(path.reach(), 0.04, 1e-15);
  EXPECT_FALSE(path.stays_on_x());
  EXPECT_NEAR(path.displacement(0.15 / 0.8).x(), 0.015, 1e-15);
  EXPECT_NEAR(path.displacement(1).y(), 0.04, 1e-15);
  EXPECT_NEAR(path.displacement(0.55 / 0.8).y(), 0.02, 1e-15);
  EXPECT_NEAR(path.instant(0.55 / 0.8), 3.5, 1e-12); // it halted for a second, which takes no share
  ASSERT_EQ(path.turns().size(), 1u);
  EXPECT_NEAR(path.turns()[0], 0.3 / 0.8, 1e-15);
}

TEST(PathTable, BadFilesAreToldLineAndValue) {
  EXPECT_EQ(refusal_of("x_m\n0\nten\n"), ":3: \"ten\" is not a finite number");
  EXPECT_EQ(refusal_of("x_m\n0\ninf\n"), ":3: \"inf\" is not a finite number");
  EXPECT_EQ(refusal_of("x_m\n0\n2000\n"), ":3: 2000 m is beyond 1000 m");
  EXPECT_EQ(refusal_of("x_m\n0.1\n0\n"),
            ":2: the path starts at (0.1, 0) m; it must start at 0, where the bearing rests");
  EXPECT_EQ(refusal_of("x_m,time_s\n0,1\n0.1,1\n"), ":3: time 1 s does not lie after 1 s");
  EXPECT_EQ(refusal_of("x_m,y_m\n0,0\n0.1\n"), ":3: 1 of 2 columns");
  EXPECT_EQ(refusal_of("x_m,x_mm\n0,0\n"),
            ":1: column 2 \"x_mm\" gives what another one gives already; keep one of them");
  EXPECT_EQ(refusal_of("time_s\n0\n"), ":1: the header has no column x_m or x_mm");
  EXPECT_NE(refusal_of("ux\n0\n").find(":1: column \"ux\" is not known"), std::string::npos);
  EXPECT_EQ(refusal_of("x_m\n0\n"), ": 1 places; a path needs at least 2");
}

TEST(PathTable, ASceneReadsItsPathAndNamesKeyFileAndLine) {
  const PathFile file("x_mm\n0\n20\n-20\n0\n");
  const std::string text = "[excitation]\nkind = \"path\"\nscale = 2\nfile = \"" + file.name + "\"\n";
  const Scene scene = parse_scene(text, "my.toml");
  EXPECT_NEAR(prescribed_displacement(scene.excitation, 0.4, 0.25).x(), 0.04, 1e-15);
  EXPECT_NEAR(scene.excitation.rounds(), 1, 1e-12);
  EXPECT_EQ(prescribed_breakpoints(scene.excitation).size(), 2u);
  EXPECT_FALSE(prescribed_instant(scene.excitation, 0.5).has_value());
  write_atomically("x_mm\n0\nhalf\n", file.name);
  try {
    parse_scene(text, "my.toml");
    FAIL() << "a bad path was taken";
  } catch (const DataError &error) {
    EXPECT_EQ(std::string(error.what()),
              "my.toml:4:8: excitation.file " + file.name + ":3: \"half\" is not a finite number");
  }
  EXPECT_THROW(parse_scene("[excitation]\nkind = \"path\"\n", "my.toml"), InputError);
}

TEST(Amplitudes, FollowOneAnotherEachWithItsCycles) {
  const Scene scene =
      parse_scene("[excitation]\nkind = \"cyclic\"\ncycles = 3\namplitudes_m = [0.02, 0.04, 0.09]\n", "my.toml");
  const auto at = [&](double s) { return prescribed_displacement(scene.excitation, 0.4, s).x(); };
  const double quarter = 1.0 / 36;
  EXPECT_NEAR(at(quarter), 0.02, 1e-15);
  EXPECT_NEAR(at(12 * quarter + 3 * quarter), -0.04, 1e-15);
  EXPECT_NEAR(at(24 * quarter + 9 * quarter), 0.09, 1e-15);
  for (const double s : {0.0, 1.0 / 3, 2.0 / 3, 1.0}) EXPECT_NEAR(at(s), 0, 1e-14);
  EXPECT_EQ(scene.excitation.rounds(), 9);
  EXPECT_EQ(scene.excitation.largest_amplitude(), 0.09);
  EXPECT_EQ(parse_scene(to_toml(scene), "again.toml").excitation.amplitudes, scene.excitation.amplitudes);
  EXPECT_THROW(parse_scene("[excitation]\nkind = \"cyclic\"\ncycles = 1.25\namplitudes_m = [0.02, 0.04]\n", "my.toml"),
               InputError);
  EXPECT_THROW(parse_scene("[excitation]\nkind = \"cyclic\"\namplitudes_m = [0.02, 0.9]\n", "my.toml"), InputError);
}

} // namespace
