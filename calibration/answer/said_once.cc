#include "calibration/answer/said_once.h"
#include "io/files/data_folder.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

namespace rimpact::calibration {

namespace {

/// A sentence taken apart: the words without a run's name and numbers, and the numbers behind the name.
struct Parts {
  std::string kind;
  std::vector<double> numbers;
};

/// Of data/words/alike.json, which the report reads too.
struct Patterns {
  std::regex name_in_front, named, number;
};
const Patterns &patterns() {
  static const Patterns known = [] {
    const auto path = std::filesystem::path(data_folder()) / "data" / "words" / "alike.json";
    std::ifstream file(path);
    const auto words = nlohmann::json::parse(file, nullptr, false);
    if (!words.is_object()) throw IoError(path.string() + " cannot be read: it goes with the program");
    const auto of = [&](const char *key) { return std::regex(words.at(key).get<std::string>()); };
    return Patterns{of("name_in_front"), of("named"), of("number")};
  }();
  return known;
}

Parts apart(const std::string &sentence) {
  const auto &[name_in_front, named, number] = patterns();
  const std::string rest = std::regex_replace(std::regex_replace(sentence, name_in_front, ""), named, "$1NAME");
  Parts parts{.kind = std::regex_replace(rest, number, "#"), .numbers = {}};
  for (std::sregex_iterator i(rest.begin(), rest.end(), number), end; i != end; ++i)
    parts.numbers.push_back(std::abs(std::stod(i->str())));
  return parts;
}

/// Whether `a` is worse: the first number in which they differ is larger.
bool worse(const Parts &a, const Parts &b) {
  const std::size_t n = std::min(a.numbers.size(), b.numbers.size());
  for (std::size_t i = 0; i < n; ++i)
    if (a.numbers[i] != b.numbers[i]) return a.numbers[i] > b.numbers[i];
  return false;
}

} // namespace

std::vector<std::string> said_once(const std::vector<std::string> &sentences) {
  struct Kind {
    Parts worst;
    std::size_t said; ///< which sentence
    int n = 1;
  };
  std::vector<Kind> kinds;
  for (std::size_t i = 0; i < sentences.size(); ++i) {
    Parts parts = apart(sentences[i]);
    const auto same = [&](const Kind &kind) { return kind.worst.kind == parts.kind; };
    const auto found = std::find_if(kinds.begin(), kinds.end(), same);
    if (found == kinds.end()) {
      kinds.push_back({std::move(parts), i});
      continue;
    }
    ++found->n;
    if (worse(parts, found->worst)) found->worst = std::move(parts), found->said = i;
  }
  std::vector<std::string> lines;
  for (const auto &kind : kinds)
    lines.push_back(kind.n == 1 ? sentences[kind.said]
                                : fmt::format("{} alike, the worst: {}", kind.n, sentences[kind.said]));
  return lines;
}

} // namespace rimpact::calibration
