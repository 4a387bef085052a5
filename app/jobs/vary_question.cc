#include "app/jobs/vary_question.h"

#include "app/words/assignments.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "scene/assumptions.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {
namespace {

using calibration::VariedKey;

constexpr const char *form = "must be KEY=LOW:HIGH or KEY=LOW:HIGH:N, as rim.thickness_mm=20:80";

double number_in(std::string_view text, const std::string &word) {
  const auto value = to_number(text);
  if (!value || !std::isfinite(*value)) throw InputError(fmt::format("--vary {}: {}", word, form));
  return *value;
}

/// Keys of which a slow push of the rim alone knows nothing: every rim would be the same.
void require_felt(const std::string &key, const std::string &word) {
  constexpr std::array unfelt{"pad.",
                              "foot.",
                              "contact.",
                              "material.ertalyte.",
                              "material.steel.rate",
                              "material.steel.density",
                              "material.steel.strain_limit",
                              "material.steel.fracture"};
  for (const char *part : unfelt)
    if (key.starts_with(part))
      throw InputError(fmt::format("--vary {}: a slow push of the rim does not feel bearing.{}", word, key));
}

VariedKey varied_key(const std::string &word) {
  constexpr int usual = 3, most = 20;
  const auto equals = word.find('=');
  const auto parts = equals == std::string::npos ? std::vector<std::string_view>{}
                                                 : split(std::string_view(word).substr(equals + 1), ':');
  if (equals == 0 || parts.size() < 2 || parts.size() > 3) throw InputError(fmt::format("--vary {}: {}", word, form));
  VariedKey key{.key = word.substr(0, equals), .values = {}};
  if (key.key.starts_with("bearing.")) key.key.erase(0, std::string("bearing.").size());
  require_felt(key.key, word);
  const double low = number_in(parts[0], word), high = number_in(parts[1], word);
  const double n = parts.size() == 3 ? number_in(parts[2], word) : usual;
  if (!(low > 0 && low < high)) throw InputError(fmt::format("--vary {}: must be 0 < LOW < HIGH", word));
  if (!(n >= 2 && n <= most && n == std::floor(n)))
    throw InputError(fmt::format("--vary {}: N must be a whole number from 2 to {}", word, most));
  for (int i = 0; i < static_cast<int>(n); ++i) key.values.push_back(low + (high - low) * i / (n - 1));
  return key;
}

double speed_of(const std::vector<std::string> &words) {
  constexpr double least = 0.01, most = 10; // [m/s]
  const auto at = values_of(words, "--at");
  for (const auto &[name, value] : at)
    if (name != "speed") throw InputError("--at " + unknown_word(name, {"speed"}));
  if (at.empty()) throw InputError("--vary asks at one speed of approach: give it, as --at speed=0.8 (m/s)");
  const double speed = at.at("speed");
  if (!(speed >= least && speed <= most))
    throw InputError(fmt::format("--at speed={:g} must be from {:g} to {:g} m/s", speed, least, most));
  return speed;
}

std::map<std::string, double> targets_of(const std::vector<std::string> &words) {
  auto targets = values_of(words, "--target");
  for (const auto &[name, most] : targets) {
    const auto &known = calibration::vary_outputs();
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError("--target " + unknown_word(name, known));
    if (!(most > 0 && std::isfinite(most))) throw InputError(fmt::format("--target {}={:g} must be > 0", name, most));
  }
  return targets;
}

} // namespace

calibration::VaryQuestion vary_question(const VaryWords &words, const GivenCase &given) {
  constexpr std::size_t most = 200;
  if (scene::load_is_assumed(given.scene))
    throw InputError(
        fmt::format("load.mass_kg: {} gives no load, and --vary answers for none that is assumed; give "
                    "yours by --set load.vertical_kN=... or --set load.mass_kg=..., or a scene with [load]",
                    given.origin));
  calibration::VaryQuestion question{.keys = {},
                                     .speed = speed_of(words.at),
                                     .mass = given.scene.load.mass,
                                     .weight = given.scene.load.vertical,
                                     .strain_limit = scene::strain_limit(given.scene.bearing),
                                     .targets = targets_of(words.targets)};
  std::size_t n = 1;
  for (const auto &word : words.vary) {
    question.keys.push_back(varied_key(word));
    n *= question.keys.back().values.size();
    for (std::size_t j = 0; j + 1 < question.keys.size(); ++j)
      if (question.keys[j].key == question.keys.back().key)
        throw InputError(fmt::format("--vary {}: the key is given twice", word));
  }
  if (n > most) throw InputError(fmt::format("--vary asks for {} rims; {} or fewer are run", n, most));
  return question;
}

std::vector<std::string> settings_of(const calibration::VaryQuestion &question, const std::vector<double> &at) {
  std::vector<std::string> settings;
  for (std::size_t j = 0; j < at.size(); ++j)
    settings.push_back(fmt::format("bearing.{}={:.10g}", question.keys[j].key, at[j]));
  return settings;
}

std::string name_of(const calibration::VaryQuestion &question, const std::vector<double> &at) {
  std::string name;
  for (std::size_t j = 0; j < at.size(); ++j) {
    const auto &key = question.keys[j].key;
    const auto dot = key.rfind('.');
    name += fmt::format("{}{}-{:g}", j == 0 ? "" : "_", dot == std::string::npos ? key : key.substr(dot + 1), at[j]);
  }
  return name;
}

std::vector<std::vector<double>> combinations(const calibration::VaryQuestion &question) {
  std::vector<std::vector<double>> all{{}};
  for (std::size_t j = question.keys.size(); j-- > 0;) {
    std::vector<std::vector<double>> longer;
    for (const auto &rest : all)
      for (const double value : question.keys[j].values) {
        longer.push_back({value});
        longer.back().insert(longer.back().end(), rest.begin(), rest.end());
      }
    all = std::move(longer);
  }
  return all;
}

} // namespace rimpact::app
