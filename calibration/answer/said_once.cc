#include "calibration/answer/said_once.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <regex>

namespace rimpact::calibration {

namespace {

/// A sentence taken apart: the words without a run's name and numbers, and the numbers behind the name.
struct Parts {
  std::string kind;
  std::vector<double> numbers;
};

/// Length of "NAME: " in front, a name being one word; 0 without.
std::size_t name_length(const std::string &sentence) {
  const auto colon = sentence.find(": ");
  return colon == std::string::npos || sentence.find(' ') < colon ? 0 : colon + 2;
}

Parts apart(const std::string &sentence) {
  static const std::regex number(R"([-+]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?)"), named(R"((^|\s)[A-Za-z]\S*[0-9]\S*)");
  const std::string rest = std::regex_replace(sentence.substr(name_length(sentence)), named, "$1NAME");
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
