// Frames as tables: written and read back, and what is refused.
#include "../scene/temporary_folder.h"
#include "buildings/frame_source.h"
#include "buildings/frame_tables.h"
#include "buildings/modes.h"
#include "buildings/regular_building.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/text.h"
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::buildings;

namespace {} // namespace

TEST(FrameTables, ReadBackToTheSameBuilding) {
  RegularBuilding b = load_building("thesis-2.4");
  b.bearings = {{2, "fps-225"}};
  b.eccentricity = {0.1, 0.2};
  b.damping_ratio = 0.05;
  const Frame written = make_frame(b);
  const TemporaryFolder kept;
  const std::string folder = kept.path();
  write_tables(written, folder);
  const Frame read = load_frame(folder);
  EXPECT_EQ(read.sections.size(), 2u);
  EXPECT_EQ(read.damping_ratio, 0.05);
  EXPECT_EQ(read.nodes[1].bearing, "fps-225");
  EXPECT_EQ(read.nodes[0].bearing, "");
  const auto here = fixed_base_modes(assemble(read)).omega, there = fixed_base_modes(assemble(written)).omega;
  EXPECT_EQ((here - there).cwiseAbs().maxCoeff(), 0);
  const auto bearings = bearings_of(read, scene::Scene());
  ASSERT_EQ(bearings.size(), 6u);
  EXPECT_EQ(bearings[0].bearing.name, "shfps-225");
  EXPECT_EQ(bearings[1].bearing.name, "fps-225");
}

TEST(FrameTables, AreRefusedWithFileAndLine) {
  const TemporaryFolder kept;
  const std::string folder = kept.path();
  /// Of the tables with one of them changed; without the folder. Data files are exit code 3.
  const auto refusal_of = [&](const std::string &file, const auto &changed) {
    write_tables(make_frame(load_building("thesis-2.4")), folder);
    write_atomically(changed(read_file(folder + "/" + file)), folder + "/" + file);
    try {
      load_frame(folder);
    } catch (const DataError &error) {
      return std::string(error.what()).substr(folder.size() + 1);
    }
    return std::string();
  };
  const auto said = [&](const std::string &file, const std::string &from, const std::string &to) {
    return refusal_of(file, [&](std::string text) { return text.replace(text.find(from), from.size(), to); });
  };
  /// One cell of a line (from 1) changed.
  const auto with_cell = [&](const std::string &file, int line, const std::string &column, const std::string &cell) {
    return refusal_of(file, [&](const std::string &text) {
      const auto lines = lines_of(text);
      const auto columns = split(lines[0], ',');
      const auto at = std::find(columns.begin(), columns.end(), column) - columns.begin();
      std::string changed;
      for (int n = 1; n <= static_cast<int>(lines.size()); ++n) {
        const auto cells = split(lines[n - 1], ',');
        for (int c = 0; c < static_cast<int>(cells.size()); ++c)
          changed += (c > 0 ? "," : "") + (n == line && c == at ? cell : std::string(cells[c]));
        changed += "\n";
      }
      return changed;
    });
  };
  EXPECT_NE(said("nodes.csv", "\n2,8", "\n2,eight").find("nodes.csv:3: x_m is \"eight\", not a number"),
            std::string::npos);
  EXPECT_NE(said("nodes.csv", "\n2,8", "\n5,8").find("nodes.csv:3: node is 5; rows are numbered"), std::string::npos);
  EXPECT_EQ(with_cell("nodes.csv", 3, "vertical_mass_kg", "0"),
            "nodes.csv:3: node 2 has the mass 0 kg; it must be above 0");
  EXPECT_EQ(with_cell("nodes.csv", 2, "bearing", ""),
            "nodes.csv:2: bearing is empty; 0: none, 1: the scene's, or the name or file of another");
  EXPECT_EQ(with_cell("elements.csv", 4, "j", "99"),
            "elements.csv:4: element 3 ends at node 99; the frame has nodes 1 to 24");
  EXPECT_EQ(with_cell("diaphragms.csv", 3, "mass_kg", "-1"),
            "diaphragms.csv:3: diaphragm 2 has the mass -1 kg; it must be above 0");
  EXPECT_NE(said("elements.csv", "E_Pa", "E_kPa").find("elements.csv: has no column E_Pa"), std::string::npos);
  EXPECT_NE(said("elements.csv", "23400000000", "-1").find("elements.csv:2: E_Pa is -1"), std::string::npos);
  EXPECT_NE(said("elements.csv", ",0.27083", ",-0.27083").find("elements.csv:2: Asy_m2 is -0.27083"), std::string::npos)
      << said("elements.csv", ",0.27083", ",-0.27083");
  EXPECT_NE(said("diaphragms.csv", ",0.02", ",0.03").find("diaphragms.csv:3: damping_ratio is 0.02; it must be"),
            std::string::npos);
  EXPECT_NE(said("diaphragms.csv", "\n2,", "\n2,1,").find("diaphragms.csv:3: 7 cells, the head has 6"),
            std::string::npos);
}

TEST(FrameSource, ABearingsFileLiesBesideTheTables) {
  const TemporaryFolder kept;
  const std::string folder = kept.path();
  RegularBuilding b = load_building("thesis-2.4");
  b.bearings = {{1, "mine.toml"}, {2, "fps-225"}};
  write_tables(make_frame(b), folder);
  write_atomically("[rim]\nheight_mm = 61\n", folder + "/mine.toml");
  const auto bearings = bearings_of(load_frame(folder), scene::Scene());
  EXPECT_NEAR(bearings[0].bearing.rim.height, 0.061, 1e-12);
  EXPECT_EQ(bearings[1].bearing.name, "fps-225");
}

TEST(FrameSource, NamesTheNodeOfABearingItDoesNotKnow) {
  RegularBuilding b = load_building("thesis-2.4");
  b.bearings = {{3, "no-such-bearing"}};
  try {
    bearings_of(make_frame(b), scene::Scene());
    FAIL();
  } catch (const InputError &error) {
    EXPECT_EQ(std::string(error.what()).find("the bearing under node 3: "), 0u) << error.what();
  }
  b.bearings = {{9, "fps-225"}};
  EXPECT_THROW(make_frame(b), InputError);
}
