// Components of one station are one recording; copies count once; FEMA P-695's set and acceptance.
#include "../scene/expect_error.h"
#include "io/records/record.h"
#include "io/records/rotated_spectrum.h"
#include "io/records/spectral_acceleration.h"
#include "made_up.h"
#include "studies/fleets/record_cases.h"
#include "studies/risk/collapse_check.h"
#include "studies/risk/far_field_set.h"
#include "studies/risk/study_reader.h"
#include <algorithm>
#include <fmt/format.h>
#include <set>

using namespace rimpact;
using namespace rimpact::risk;

namespace {

Study folder_study(const TemporaryFolder &folder, const std::string &more = "", const std::string &list = "") {
  std::string text = made_up::head;
  text.replace(text.find("folders = [\".\"]"), 15, "folders = [\".\"]\n" + list);
  return parse_study(text + more, folder / "s.toml");
}

LimitResult limit_of(const std::vector<double> &fragility) {
  LimitResult result;
  for (const double p : fragility) result.fragility.push_back({p, p, p});
  return result;
}

const std::string p695 =
    "[p695]\nquantity = \"peak_displacement_m\"\nmce_g = 0.2\nductility = 3.0\ncategory = \"Dmax\"\n";

} // namespace

TEST(Stations, TheirComponentsAreDrawnTogether) {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  const auto motions = motions_of(folder_study(folder), {});
  for (const auto &level : motions.levels) {
    ASSERT_EQ(level.motions.size(), 3u);
    std::set<std::string> records;
    for (const auto &motion : level.motions) records.insert(motion.record);
    EXPECT_EQ(records, (std::set<std::string>{"RSN1_HILL", "RSN2_VALLEY"}));
  }
}

TEST(Stations, AComponentGivenTwiceMovesNothing) {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  const auto once = motions_of(folder_study(folder), {});
  folder.write("RSN1_HILL180.AT2", made_up::at2(-0.4, 1.0)); // RSN1_HILL000 turned round and doubled
  const auto twice = motions_of(folder_study(folder), {});
  ASSERT_EQ(once.levels.size(), twice.levels.size());
  for (std::size_t i = 0; i < once.levels.size(); ++i) {
    ASSERT_EQ(once.levels[i].motions.size(), twice.levels[i].motions.size());
    for (std::size_t k = 0; k < once.levels[i].motions.size(); ++k) {
      const auto &a = once.levels[i].motions[k], &b = twice.levels[i].motions[k];
      EXPECT_EQ(a.file, b.file);
      EXPECT_EQ(a.scale, b.scale);
      EXPECT_EQ(a.record, b.record);
    }
  }
  EXPECT_TRUE(std::any_of(twice.doubts.begin(), twice.doubts.end(), [](const auto &d) {
    return d.find("RSN1_HILL180 is -2 times RSN1_HILL000: it counts once") != std::string::npos;
  }));
}

TEST(Stations, NoVerticalAmongHorizontalsUnderTwentySpellings) {
  const std::vector<std::string> spellings{"-UP",  "_UP", "UP",   "-DWN", "DWN", "-DOWN", "UD",   "-UD",
                                           "-V",   "V",   "-VER", "VRT",  "VER", "VERT",  "-VRT", "_Z",
                                           "-HNZ", "-Up", "dwn",  "-DN",  "-U",  "UD2"};
  const TemporaryFolder folder;
  std::set<std::string> verticals;
  for (std::size_t i = 0; i < spellings.size(); ++i) {
    const double period = 0.5 + 0.07 * static_cast<double>(i);
    folder.write(fmt::format("RSN{}_HILL000.AT2", i + 1), made_up::at2(0.2, period));
    verticals.insert(
        folder.write(fmt::format("RSN{}_HILL{}.AT2", i + 1, spellings[i]), made_up::at2(0.9, period + 0.03)));
  }
  ASSERT_GE(verticals.size(), 20u);
  const auto sweep = fleets::cases_of_folder(folder.path(), fleets::Components::x, 0); // what a sweep runs
  EXPECT_EQ(sweep.cases.size(), spellings.size());
  for (const auto &motion : sweep.cases)
    for (const auto &axis : motion)
      if (axis.key == "excitation.x") {
        EXPECT_FALSE(verticals.contains(std::get<std::string>(axis.values[0].cell)));
      }
  for (const auto &level : motions_of(folder_study(folder), {}).levels) { // what a study runs
    EXPECT_EQ(level.motions.size(), spellings.size());
    for (const auto &motion : level.motions) EXPECT_FALSE(verticals.contains(motion.file)) << motion.file;
  }
}

TEST(Stations, TheMeasureOfAPairScalesBothComponents) {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  const auto with = [&](const std::string &measure) {
    std::string text = made_up::head;
    text.replace(text.find("period_s = 3.0"), 14, "period_s = 3.0\nmeasure = \"" + measure + "\"");
    return motions_of(parse_study(text, folder / "s.toml"), {});
  };
  const auto own = motions_of(folder_study(folder), {});
  for (const char *measure : {"rotd50", "rotd100"}) {
    const auto motions = with(measure);
    for (std::size_t i = 0; i < motions.levels.size(); ++i) {
      const auto &level = motions.levels[i];
      ASSERT_EQ(level.motions.size(), 2u); // RSN1_HILL; RSN2_VALLEY is alone
      EXPECT_EQ(level.n_listed, 3);
      const auto &one = level.motions[0], &two = level.motions[1];
      EXPECT_EQ(one.scale, two.scale) << "one motion, one factor";
      const auto both = rotated_acceleration(read_record(one.file), read_record(two.file), 3.0);
      const double unscaled = (std::string(measure) == "rotd50" ? both.rotd50 : both.rotd100) / standard_gravity;
      EXPECT_NEAR(one.scale * unscaled / level.intensity_g, 1, 1e-12);
      EXPECT_NEAR(one.over_level * own.levels[i].motions[0].scale / one.scale, 1, 1e-12);
    }
    ASSERT_FALSE(motions.missing.empty());
    EXPECT_NE(motions.missing[0].find("of no pair, which " + std::string(measure)), std::string::npos);
  }
}

TEST(FarFieldSet, ItsPrintedFactorsAreTheMedianVelocityOverEachOwn) {
  // PGV_PEER of table A-4D [cm/s], in the set's order. Coolwater's factor is derived from its velocity, 32.4.
  const double velocities[] = {57.2, 44.8, 59.2, 34.1, 28.4, 36.7, 36.0, 33.9, 54.1, 27.4, 37.7,
                               32.4, 34.2, 42.3, 47.3, 42.8, 31.7, 45.4, 90.7, 38.8, 17.8, 25.9};
  const auto set = far_field_set();
  ASSERT_EQ(set.size(), 22u);
  std::set<std::string> numbers;
  for (std::size_t i = 0; i < set.size(); ++i) {
    numbers.insert(set[i].rsn);
    const double bound = set[i].rsn == std::string("68") ? 0.0105 : 0.0051; // its 2.10 is printed for 2.09
    EXPECT_NEAR(set[i].normalisation, 37.2 / velocities[i], bound) << set[i].station;
  }
  EXPECT_EQ(numbers.size(), 22u);
  const auto median_with = [&](double coolwater) {
    std::vector<double> all(std::begin(velocities), std::end(velocities));
    all[11] = coolwater;
    std::sort(all.begin(), all.end());
    return (all[10] + all[11]) / 2;
  };
  EXPECT_NEAR(median_with(32.4), 37.2, 1e-12) << "the median that all factors have";
  EXPECT_GT(median_with(38.9), 38) << "the velocity of today's file is not the one the table was made with";
}

TEST(FarFieldSet, ItsMedianMeetsTheLevel) {
  const TemporaryFolder folder;
  const char *numbers[] = {"953", "960", "1602"};
  for (int k = 0; k < 3; ++k) {
    folder.write(fmt::format("RSN{}_A000.AT2", numbers[k]), made_up::at2(0.2 + 0.1 * k, 1.0 + 0.3 * k));
    folder.write(fmt::format("RSN{}_A090.AT2", numbers[k]), made_up::at2(0.3, 0.7 + 0.5 * k));
  }
  const auto motions = motions_of(folder_study(folder, "", "list = \"p695-far-field\"\n"), {});
  ASSERT_EQ(motions.levels.size(), 2u);
  EXPECT_EQ(motions.levels[0].n_listed, 44);
  ASSERT_EQ(motions.levels[0].motions.size(), 6u);
  std::vector<double> over;
  for (const auto &motion : motions.levels[0].motions) {
    over.push_back(std::log(motion.over_level));
    EXPECT_NEAR(motion.scale * spectral_acceleration(read_record(motion.file), 3.0) / standard_gravity,
                0.1 * motion.over_level, 1e-12);
  }
  std::sort(over.begin(), over.end());
  EXPECT_NEAR(over[2] + over[3], 0, 1e-12);
  EXPECT_NEAR(motions.levels[1].motions[0].scale / motions.levels[0].motions[0].scale, 3, 1e-12);
  EXPECT_EQ(motions.missing.size(), 2 * 19u);
}

TEST(CollapseCheck, MarginOfAMedianBetweenLevels) {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  const Study study = folder_study(folder, p695);
  ASSERT_TRUE(study.collapse);
  const std::vector<double> levels{0.1, 0.3, 0.9};
  const auto check = collapse_check(study, {limit_of({0.0, 0.25, 0.75})}, levels);
  ASSERT_TRUE(check.median_g);
  EXPECT_NEAR(*check.median_g, std::sqrt(0.3 * 0.9), 1e-12);
  EXPECT_NEAR(check.margin, *check.median_g / 0.2, 1e-12);
  EXPECT_NEAR(check.adjusted, check.margin * std::exp(0.14 * std::pow(2.0, 0.42) * 1.5), 1e-12); // T = 3 s
  EXPECT_NEAR(check.beta, 0.525, 1e-12);
  const auto never = collapse_check(study, {limit_of({0.0, 0.1, 0.4})}, levels);
  EXPECT_TRUE(never.is_least);
  EXPECT_NEAR(never.margin, 0.9 / 0.2, 1e-12);
  const auto always = collapse_check(study, {limit_of({0.6, 0.8, 1.0})}, levels);
  EXPECT_FALSE(always.is_least);
  EXPECT_EQ(always.adjusted, 0); // the median is below the first level
  const auto json = to_json(std::vector{check, always});
  EXPECT_FALSE(json["all_accepted"].get<bool>());
  EXPECT_NEAR(json["mean_adjusted_collapse_margin"].get<double>(), check.adjusted / 2, 1e-12);
}

TEST(CollapseCheck, RefusesWhatTheStudyHasNot) {
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string &more, std::initializer_list<const char *> words) {
    expect_error<InputError>([&] { folder_study(folder, more); }, words);
  };
  refuse("[p695]\nquantity = \"ductility\"\nmce_g = 1\n", {"p695.quantity", "ductility", "peak_displacement_m"});
  refuse("[p695]\nquantity = \"peak_displacement_m\"\n", {"mce_g"});
  refuse(p695 + "limit = 7\n", {"p695.limit 7"});
  refuse("[plausible]\nductilty = 3\n", {"ductilty", "ductility"});
  EXPECT_EQ(folder_study(folder, "[plausible]\nductility = 3\n").parts.plausible.at("ductility"), 3);
}
