#include "app/words/assignments.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <fmt/format.h>

namespace rimpact::app {
namespace {

double number_in(std::string_view text, const std::string &option, const std::string &word) {
  if (const auto value = to_number(text)) return *value;
  throw InputError(fmt::format("{} {}: \"{}\" is not a number", option, word, text.substr(0, 40)));
}

/// NAME=REST.
std::pair<std::string, std::string_view> assignment(const std::string &word, const std::string &option,
                                                    const char *form) {
  const auto equals = word.find('=');
  if (equals == std::string::npos) throw InputError(fmt::format("{} {}: must be {}", option, word, form));
  return {word.substr(0, equals), std::string_view(word).substr(equals + 1)};
}

} // namespace

std::map<std::string, double> values_of(const std::vector<std::string> &words, const std::string &option) {
  std::map<std::string, double> values;
  for (const auto &word : words) {
    const auto [name, text] = assignment(word, option, "NAME=VALUE");
    if (values.count(name) > 0) throw InputError(fmt::format("{} {}: {} is given twice", option, word, name));
    values[name] = number_in(text, option, word);
  }
  return values;
}

std::map<std::string, calibration::Bounds> ranges_of(const std::vector<std::string> &words, const std::string &option) {
  std::map<std::string, calibration::Bounds> ranges;
  for (const auto &word : words) {
    const auto [name, text] = assignment(word, option, "NAME=LOW:HIGH");
    const auto ends = split(text, ':');
    if (ends.size() != 2) throw InputError(fmt::format("{} {}: must be NAME=LOW:HIGH", option, word));
    ranges[name] = {number_in(ends[0], option, word), number_in(ends[1], option, word)};
  }
  return ranges;
}

} // namespace rimpact::app
