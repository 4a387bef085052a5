// Inputs that are hard on a study, one row each: the sentence it is refused with, or the right result.
#include "io/files/error.h"
#include "made_up.h"
#include "studies/risk/evaluate.h"
#include "studies/risk/study_reader.h"
#include <functional>
#include <gtest/gtest.h>

using namespace rimpact;
using namespace rimpact::risk;

namespace {

using Rows = std::vector<std::string>;

/// A study whose table has these rows, with `more` among its [motions].
Study study_with(const TemporaryFolder &folder, const Rows &rows, const std::string &more = "", const char *mark = "") {
  std::string table = std::string(mark) + "level;rsn;component;factor\n";
  for (const auto &row : rows) table += row + "\n";
  folder.write("table.csv", table);
  std::string text = made_up::head;
  text.replace(text.find("levels_g = [0.1, 0.3]"), 21, "");
  text.replace(text.find("folders = [\".\"]"), 15,
               "folders = [\".\"]\ntable = \"table.csv\"\nlevel_is = \"intensity_g\"\n" + more);
  return parse_study(text, folder / "s.toml");
}

/// Motions a level and their scales, then what is in doubt.
std::string motions_in_words(const Rows &rows, const std::string &more = "", const char *mark = "") {
  const TemporaryFolder folder;
  made_up::write_records(folder);
  const auto motions = motions_of(study_with(folder, rows, more, mark), {});
  std::string text;
  for (const auto &level : motions.levels) {
    text += fmt::format("{} g: {} motions", level.intensity_g, level.motions.size());
    for (const auto &motion : level.motions) text += fmt::format(" x {:.6g}", motion.scale);
    text += "; ";
  }
  for (const auto &doubt : motions.doubts) text += doubt + "; ";
  return text;
}

/// Two levels of these responses (a negative one: a collapse), one a record; the fragilities and the rate.
std::string result_in_words(const std::vector<double> &values, double limit) {
  std::string text = made_up::head;
  text.replace(text.find("[0.1, 0.2, 0.39]"), 16, fmt::format("[{}]", limit));
  const Study study = parse_study(text, "s.toml");
  ResponseSet set;
  for (std::size_t i = 0; i < values.size(); ++i) set.records.push_back(fmt::format("R{}", i));
  for (const double x : {0.1, 0.3}) {
    ResponseLevel level{.intensity_g = x, .n_records = static_cast<int>(values.size()), .runs = {}, .unfinished = {}};
    for (std::size_t i = 0; i < values.size(); ++i)
      level.runs.push_back({static_cast<int>(i), values[i] < 0, {std::abs(values[i])}, {}});
    set.levels.push_back(level);
  }
  const auto result = evaluate(study, set, SystemSample(study, set)).front();
  return fmt::format("P {:.6g} and {:.6g}, band {:.6g} to {:.6g}, rate {}", result.fragility[0].value,
                     result.fragility[1].value, result.fragility[1].low, result.fragility[1].high,
                     result.rate.value == 0 ? "none" : "some");
}

std::string study_in_words(const std::string &old, const std::string &now) {
  std::string text = made_up::head;
  text.replace(text.find(old), old.size(), now);
  return parse_study(text, "s.toml").name;
}

struct HardInput {
  const char *name;
  std::function<std::string()> words; ///< the result in words, or an error
  std::vector<const char *> expected; ///< words of the result or of the sentence
};

std::vector<HardInput> hard_inputs() {
  const std::string a = "0.1;1;HILL000.AT2;1", b = "0.1;1;HILL090.AT2;1", to_level = "scale = \"level\"\n";
  return {
      {"a level without records",
       [=] {
         return motions_in_words({"0.1;2;V.AT2;1", "0.3;7;X.AT2;1"}, to_level);
       },
       {"0.1 g: 1 motions", "0.3 g", "none of its 1 records", "left out"}},
      {"no level has a record",
       [=] { return motions_in_words({"0.1;7;X.AT2;1"}); },
       {"s.toml", "no level has a record"}},
      {"a record twice: its components",
       [=] {
         return motions_in_words({a, b}, to_level);
       },
       {"0.1 g: 2 motions"}},
      {"a record three times",
       [=] {
         return motions_in_words({a, b, a});
       },
       {"table.csv:4", "RSN 1", "more than once"}},
      {"a component twice",
       [=] {
         return motions_in_words({a, a}, "component = \"printed\"\n");
       },
       {"table.csv:3", "more than once", "line 2"}},
      {"a factor 0", [=] { return motions_in_words({"0.1;1;HILL000.AT2;0"}); }, {"table.csv:2", "factor 0", "> 0"}},
      {"a factor that is no number",
       [=] { return motions_in_words({"0.1;1;HILL000.AT2;one"}); },
       {"table.csv:2", "factor", "\"one\" is not a finite number"}},
      {"all runs collapsed",
       [] {
         return result_in_words({-1, -1, -1}, 0.2);
       },
       {"P 1 and 1", "band 1 to 1", "some"}},
      {"none collapsed",
       [] {
         return result_in_words({0.1, 0.4}, 0.2);
       },
       {"P 0.5 and 0.5"}},
      {"one of two collapsed",
       [] {
         return result_in_words({-1, 0.1}, 0.2);
       },
       {"P 0.5 and 0.5"}},
      {"one run a level, below", [] { return result_in_words({0.1}, 0.2); }, {"P 0 and 0", "band 0 to 0", "rate none"}},
      {"one run a level, above", [] { return result_in_words({0.3}, 0.2); }, {"P 1 and 1", "some"}},
      {"a limit never reached",
       [] {
         return result_in_words({0.1, 0.11, 0.12}, 1e6);
       },
       {"P 0 and 0", "rate none"}},
      {"no response but zeros",
       [] {
         return result_in_words({0, 0}, 0.2);
       },
       {"P 0 and 0", "rate none"}},
      {"a hazard that is not monotone",
       [] { return study_in_words("[0.26227, 2475]", "[0.26227, 400]"); },
       {"s.toml:10", "not monotone"}},
      {"a level twice", [] { return study_in_words("[0.1, 0.3]", "[0.1, 0.1]"); }, {"s.toml:6", "twice"}},
      {"decimal commas and a byte order mark",
       [=] { return motions_in_words({"0,1;1;HILL000.AT2;1,5"}, "", "\xEF\xBB\xBF"); },
       {"0.1 g: 1 motions x 1.5"}},
      {"decimal commas between commas",
       [=] {
         const TemporaryFolder folder;
         Study study = study_with(folder, {});
         folder.write("table.csv", "level,rsn,component,factor\n0,1,1,HILL000.AT2,1,5\n");
         return std::to_string(motions_of(study, {}).levels.size());
       },
       {"table.csv:2", "6 cells", "semicolons"}},
      {"a table without rows", [=] { return motions_in_words({}); }, {"table.csv", "no rows"}},
  };
}

} // namespace

TEST(HardInputs, EachIsASentenceOrTheRightResult) {
  for (const auto &input : hard_inputs()) {
    SCOPED_TRACE(input.name);
    std::string words;
    try {
      words = input.words();
    } catch (const Error &error) {
      words = error.what();
    }
    for (const char *word : input.expected)
      EXPECT_NE(words.find(word), std::string::npos) << word << " is not in: " << words;
  }
}
