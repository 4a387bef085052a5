// Which records stand at which level.
#include "../scene/expect_error.h"
#include "io/records/record.h"
#include "io/records/spectral_acceleration.h"
#include "made_up.h"
#include "studies/risk/motions.h"
#include "studies/risk/study_reader.h"
#include <algorithm>
#include <filesystem>

using namespace rimpact;
using namespace rimpact::risk;

namespace {

Study table_study(const TemporaryFolder &folder, const std::string &rows, const std::string &more = "") {
  folder.write("table.csv", "level;rsn;component;factor\n" + rows);
  std::string text = made_up::head;
  text.replace(text.find("levels_g = [0.1, 0.3]"), 21, "");
  text.replace(text.find("folders = [\".\"]"), 15,
               "folders = [\".\"]\ntable = \"table.csv\"\nlevel_is = \"intensity_g\"\n" + more);
  return parse_study(text, folder / "s.toml");
}
double sa(const std::string &file) {
  return spectral_acceleration(read_record(file), 3.0) / standard_gravity;
}
std::string name(const Motion &motion) {
  return std::filesystem::path(motion.file).stem().string();
}

} // namespace

TEST(Motions, TheComponentThatMeetsTheLevel) {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  const double factor =
      0.1 / sa(folder / "RSN1_HILL090.AT2"); // printed with a decimal comma, of the other component's name
  std::string number = fmt::format("{:.4f}", factor);
  std::replace(number.begin(), number.end(), '.', ',');
  const auto motions = motions_of(table_study(folder, "0,1;1;HILL000.AT2;" + number + "\n0,1;9;X.AT2;1\n"), {});
  ASSERT_EQ(motions.levels.size(), 1u);
  ASSERT_EQ(motions.levels[0].motions.size(), 1u);
  EXPECT_EQ(name(motions.levels[0].motions[0]), "RSN1_HILL090");
  EXPECT_NEAR(motions.levels[0].motions[0].over_level, 1, 1e-3);
  EXPECT_EQ(motions.levels[0].n_listed, 2);
  ASSERT_EQ(motions.missing.size(), 1u);
  EXPECT_NE(motions.missing[0].find("table.csv:3: RSN 9 X.AT2"), std::string::npos) << motions.missing[0];
}

TEST(Motions, ARecordTwiceIsItsTwoComponents) {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  const std::string a = fmt::format("0.1;1;HILL000.AT2;{:.4f}\n", 0.1 / sa(folder / "RSN1_HILL000.AT2"));
  const std::string b = fmt::format("0.1;1;HILL000.AT2;{:.4f}\n", 0.1 / sa(folder / "RSN1_HILL090.AT2"));
  for (const auto &rows : {a + b, b + a}) {
    const auto motions = motions_of(table_study(folder, rows), {});
    ASSERT_EQ(motions.levels[0].motions.size(), 2u);
    EXPECT_NE(name(motions.levels[0].motions[0]), name(motions.levels[0].motions[1]));
    for (const auto &motion : motions.levels[0].motions) EXPECT_NEAR(motion.over_level, 1, 1e-3);
    EXPECT_EQ(motions.levels[0].motions[0].record, motions.levels[0].motions[1].record); // drawn together
    ASSERT_EQ(motions.doubts.size(), 1u);
    EXPECT_EQ(motions.doubts[0].find("one record serves every level: the bands"), 0u) << motions.doubts[0];
  }
  expect_error<DataError>([&] { motions_of(table_study(folder, a + b + a), {}); },
                          {"table.csv:4", "RSN 1", "more than once"});
  expect_error<DataError>([&] { motions_of(table_study(folder, a + a, "component = \"printed\"\n"), {}); },
                          {"table.csv:3", "more than once", "line 2"});
}

TEST(Motions, HardTables) {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  expect_error<DataError>([&] { motions_of(table_study(folder, "0.1;1;HILL000.AT2;0\n"), {}); },
                          {"table.csv:2", "factor 0", "must be > 0"});
  expect_error<DataError>([&] { motions_of(table_study(folder, "0;1;HILL000.AT2;1\n"), {}); },
                          {"level 0", "must be > 0"});
  expect_error<InputError>([&] { motions_of(table_study(folder, "0.1;7;X.AT2;1\n"), {}); },
                           {"no level has a record", "--records"});
  expect_error<InputError>([&] { motions_of(table_study(folder, "0.1;1;X.AT2;1\n"), {folder / "nowhere"}); },
                           {"nowhere"});
  // a level without records is left out and said
  const auto motions =
      motions_of(table_study(folder, "0.1;2;VALLEY000.AT2;1\n0.3;7;X.AT2;1\n", "scale = \"level\"\n"), {});
  EXPECT_EQ(motions.levels.size(), 1u);
  EXPECT_TRUE(std::any_of(motions.doubts.begin(), motions.doubts.end(),
                          [](const auto &d) { return d.find("none of its 1 records") != std::string::npos; }));
}

TEST(Motions, OfPeersSearch) {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  folder.write("_SearchResults.csv", "PEER Strong Motion Database Search Report\n\n -- Summary of Metadata of Selected "
                                     "Records --\n Result ID, Spectral "
                                     "Ordinate, Record Sequence Number, MSE, Scale Factor,\n1,SRSS,2,0.1,1.50,\n\n -- "
                                     "Scaled spectra --\nT (s), Pga\n");
  std::string text = made_up::head;
  text.replace(text.find("levels_g = [0.1, 0.3]"), 21, "");
  text.replace(text.find("[hazard]"), 8,
               "[[motions.set]]\nsearch_results = \"_SearchResults.csv\"\nlevel = 475\n[hazard]");
  const auto motions = motions_of(parse_study(text, folder / "s.toml"), {});
  ASSERT_EQ(motions.levels.size(), 1u);
  EXPECT_NEAR(motions.levels[0].intensity_g, 0.1129, 1e-12);
  EXPECT_EQ(motions.levels[0].motions[0].scale, 1.5);
}

// Of the thesis's appendix C every row that can be checked meets one level a table within 2 % or its factor's two
// digits.
TEST(Motions, AppendixCMeetsItsLevels) {
  const std::string shelf = std::string(RIMPACT_SHARED_RECORDS) + "/appendix_c";
  if (!std::filesystem::exists(shelf + "/appendix_c.csv")) GTEST_SKIP() << "the records of appendix C are not here";
  for (const char *name : {"thesis-2.6.toml", "thesis-4-Tb5.toml"}) {
    Study study = read_study(std::string(RIMPACT_STUDIES) + "/" + name);
    study.motions.table = shelf + "/appendix_c.csv";
    const auto motions = motions_of(study, {shelf});
    EXPECT_TRUE(motions.doubts.empty()) << motions.doubts.front();
    std::size_t n = 0, beyond = 0;
    for (const auto &level : motions.levels) {
      EXPECT_EQ(level.n_listed, 30);
      EXPECT_GE(level.motions.size(), 8u);
      for (const auto &motion : level.motions) ++n, beyond += std::abs(motion.over_level - 1) > level_tolerance;
    }
    EXPECT_EQ(motions.levels.size(), 10u);
    EXPECT_GE(n, 150u);
    EXPECT_LE(beyond, 3u); // small factors, whose two digits allow it
  }
}
