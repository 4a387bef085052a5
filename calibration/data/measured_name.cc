#include "calibration/data/measured_name.h"
#include "calibration/data/channels.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::calibration {
namespace {

bool is_toml(const std::string &path) {
  return std::filesystem::path(path).extension() == ".toml" && !std::filesystem::is_directory(path);
}

} // namespace

std::optional<MeasuredName> measured_name(const std::string &path) {
  if (is_toml(path)) return MeasuredName{path, ""};
  const auto mark = path.rfind('#');
  if (mark == std::string::npos || !is_toml(path.substr(0, mark))) return {};
  return MeasuredName{path.substr(0, mark), path.substr(mark + 1)};
}

bool is_mapping(const std::string &path) {
  return measured_name(path).has_value();
}

TestPart named_part(const Mapping &mapping, const MeasuredName &name, const std::vector<std::string> &tests) {
  if (name.test.empty() && tests.empty()) return mapping.whole;
  const auto listed = [&](const std::string &test) {
    return std::find_if(mapping.tests.begin(), mapping.tests.end(), [&](const auto &t) { return t.name == test; });
  };
  if (name.test.empty() && tests.size() > 1)
    throw InputError(fmt::format("{} holds {} tests; name one: {}#{}", name.file, tests.size(), name.file, tests[0]));
  const std::string wanted = name.test.empty() ? tests.front() : name.test;
  if (tests.empty()) throw InputError(fmt::format("{} is one test: nothing follows its name (#{})", name.file, wanted));
  if (std::find(tests.begin(), tests.end(), wanted) == tests.end())
    throw InputError(fmt::format("{}: test {}", name.file, unknown_word(wanted, tests)));
  TestPart part = listed(wanted) == mapping.tests.end() ? mapping.whole : *listed(wanted);
  part.name = wanted;
  return part;
}

std::vector<std::string> each_test(const std::vector<std::string> &paths) {
  std::vector<std::string> all;
  for (const auto &path : paths) {
    const auto name = measured_name(path);
    const auto tests = name && name->test.empty() && std::filesystem::exists(path) ? tests_of(read_mapping(path))
                                                                                   : std::vector<std::string>();
    for (const auto &test : tests) all.push_back(path + "#" + test);
    if (tests.empty()) all.push_back(path);
  }
  return all;
}

} // namespace rimpact::calibration
