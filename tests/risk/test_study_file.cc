#include "../scene/expect_error.h"
#include "made_up.h"
#include "studies/risk/comparisons.h"
#include "studies/risk/study.h"
#include "studies/risk/study_reader.h"
#include <algorithm>

using namespace rimpact;
using namespace rimpact::risk;

namespace {

const std::string whole = std::string(made_up::head) + made_up::systems;

std::string with(std::string text, const std::string &old, const std::string &now) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}
void refuse(const std::string &text, std::initializer_list<const char *> words) {
  expect_error<InputError>([&] { parse_study(text, "s.toml"); }, words);
}

} // namespace

TEST(StudyFile, SystemsAreCasesDevicesAndGrid) {
  const Study study = parse_study(whole + "[[device]]\nname = 'soft'\nreduced.k_i_kN_per_m = 1e5\n[[device]]\nname = "
                                          "'stiff'\nreduced.k_i_kN_per_m = 1e6\n",
                                  "s.toml");
  const Systems systems = systems_of(study);
  EXPECT_EQ(systems.size(), 4u);
  EXPECT_EQ(systems.keys, (std::vector<std::string>{"bearing.surface.a_m", "device", "reduced.k_i_kN_per_m"}));
  EXPECT_EQ(study.name, "s");
  EXPECT_EQ(study.limits[0].values, (std::vector<double>{0.1, 0.2, 0.39}));
  ASSERT_EQ(comparisons(study, systems).size(), 2u);
  for (const auto &c : comparisons(study, systems)) // the same device, another dish
    EXPECT_EQ(systems.all[c.system].values[1], systems.all[c.reference].values[1]);
}

/// A file is sought beside the study that names it, in [set] as in a device.
TEST(StudyFile, FilesAreSoughtBesideTheStudy) {
  const std::string set = with(whole, "[set]\n", "[set]\nreduced.impact_curve = \"sub/curve.h5\"\n");
  const Study study = parse_study(set, "/study/here/s.toml");
  EXPECT_NE(
      std::find(study.settings.begin(), study.settings.end(), "reduced.impact_curve=\"/study/here/sub/curve.h5\""),
      study.settings.end());
  const Study device =
      parse_study(whole + "[[device]]\nreduced.impact_curve = \"sub/curve.h5\"\n", "/study/here/s.toml");
  const auto settings = systems_of(device).all.front().overrides; // the systems do not outlive the line
  EXPECT_NE(std::find(settings.begin(), settings.end(), "reduced.impact_curve=\"/study/here/sub/curve.h5\""),
            settings.end());
}

TEST(StudyFile, RefusalsNameFileLineAndColumn) {
  refuse(with(whole, "scene = ", "scen = "), {"s.toml:1:", "scen"});
  refuse(with(whole, "[0.1129, 475]", "[0.1129, 40]"), {"s.toml:", "not monotone", "40", "point 2"});
  refuse(with(whole, "\"peak_displacement_m\"", "\"peak_displacment_m\""), {"did you mean", "peak_displacement_m"});
  refuse(with(whole, "[0.1, 0.2, 0.39]", "[0.1, 0.1]"), {"different numbers > 0"});
  refuse(with(whole, "[0.1, 0.2, 0.39]", "[0, 0.1]"), {"different numbers > 0"});
  refuse(with(whole, "reference = 2.25", "reference = 2.0"), {"no system has this"});
  refuse(with(whole, "period_s = 3.0", "period_s = 0"), {"intensity.period_s"});
  refuse(with(whole, "levels_g = [0.1, 0.3]", "levels_g = [0.1, 0.1]"), {"twice"});
  refuse(with(whole, "levels_g = [0.1, 0.3]", ""), {"one of motions.table"});
  refuse(with(whole, "period_s = 3.0", "period_s = 3.0\nmeasure = \"rotd\""), {"measure", "rotd50"});
  refuse(with(with(whole, "period_s = 3.0", "period_s = 3.0\nmeasure = \"rotd50\""), "levels_g = [0.1, 0.3]", "") +
             "[[motions.set]]\nsearch_results = \"a.csv\"\nlevel = 475\n",
         {"intensity.measure", "levels_g"});
  refuse(with(whole, "replicates = 60", "replicates = 1"), {"replicates", "between 2"});
  refuse(with(whole, "excitation.duration_s = 7.0", "excitation.scale = 2.0"), {"s.toml:3:", "set by [motions]"});
  refuse(with(whole, "bearing.surface.a_m = [2.25, 0.5625]", "bearing.surface.b_m = [2.25]"), {"b_m"});
}

/// Tables of a list are read as every other table: what is unknown, missing or of another type stands with its line.
TEST(StudyFile, ListsOfTablesAreReadAsTables) {
  refuse(with(whole, "values = [0.1,", "value = [0.1,"), {"s.toml:11:", "needs values"});
  refuse(with(whole, "[bootstrap]", "value = 1\n[bootstrap]"),
         {"s.toml:14:", "unknown key \"value\" in [limit]", "values"});
  refuse(with(whole, "[0.1, 0.2, 0.39]", "{ from = 0.1, to = 0.4, count = 2.5 }"),
         {"s.toml:13:", "limit.values.count", "whole number"});
  refuse(with(whole, "[0.1, 0.2, 0.39]", "{ from = 0.1, to = 0.4 }"), {"s.toml:13:", "limit.values needs count"});
  refuse(with(whole, "[[limit]]", "[limit]"), {"s.toml:", "limit must be tables", "[[limit]]"});
  refuse(with(whole, "folders = [\".\"]", "folders = \".\""), {"s.toml:8:", "motions.folders", "array of strings"});
  refuse(with(whole, "[hazard]", "[[motions.set]]\nlevel = 475\n[hazard]"), {"s.toml:9:", "needs search_results"});
  refuse(with(whole, "[hazard]", "[[motions.set]]\nlevel = -1\n[hazard]"),
         {"s.toml:10:", "motions.set.level -1", "> 0"});
  refuse(with(whole, "reference = 2.25", "reference = true"), {"difference.reference", "must be a number"});
  const Study even = parse_study(with(whole, "[0.1, 0.2, 0.39]", "{ from = 0.1, to = 0.4, count = 4 }"), "s.toml");
  EXPECT_EQ(even.limits[0].values, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
}

TEST(StudyFile, ShippedStudiesAreTheThesis) {
  const auto size = [](const char *name) {
    const Study study = read_study(std::string(RIMPACT_STUDIES) + "/" + name);
    EXPECT_EQ(study.parts.samples, 15);
    EXPECT_EQ(study.hazard.size(), 10u);
    return systems_of(study).size();
  };
  EXPECT_EQ(size("thesis-2.6.toml"), 64u);
  EXPECT_EQ(size("thesis-4-Tb3.toml") + size("thesis-4-Tb5.toml"), 1152u);
  EXPECT_EQ(size("impact-laws.toml"), 14u);
}
