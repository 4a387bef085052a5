#include "io/records/target_spectrum.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <array>
#include <fmt/format.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace rimpact {

/// What stands behind the name: KEY=VALUE, parted by commas.
class TargetKeys {
public:
  TargetKeys(const std::string &text, const std::set<std::string> &known) : text_(text) {
    bool first = true;
    for (const auto part : split(text, ',')) {
      if (std::exchange(first, false)) continue;
      const auto equals = part.find('=');
      const std::string key(trim(part.substr(0, equals)));
      if (equals == std::string_view::npos) fail(fmt::format("\"{}\" is not KEY=VALUE", part));
      if (known.count(key) == 0) fail(unknown_word(key, {known.begin(), known.end()}));
      if (!values_.emplace(key, trim(part.substr(equals + 1))).second) fail(key + " is given twice");
    }
  }

  double number(const std::string &key, double least, double most, double otherwise = -1) const {
    const auto found = values_.find(key);
    if (found == values_.end()) {
      if (otherwise < 0) fail(key + " is missing");
      return otherwise;
    }
    const auto value = to_number(found->second);
    if (!value || !(*value > least && *value <= most))
      fail(fmt::format("{} \"{}\" is not a number > {:g} and <= {:g}", key, found->second, least, most));
    return *value;
  }
  std::string word(const std::string &key, const std::string &otherwise) const {
    const auto found = values_.find(key);
    return found == values_.end() ? otherwise : found->second;
  }
  [[noreturn]] void fail(const std::string &what) const {
    throw InputError(fmt::format("--target {}: {}", text_, what));
  }

private:
  std::string text_;
  std::map<std::string, std::string> values_;
};

namespace {

constexpr double largest_target = 10; // [g]

struct Ground {
  const char *type;
  double soil, t_b, t_c, t_d; ///< S [-], [s]
};
/// Tables 3.2 and 3.3 of EN 1998-1:2004.
constexpr std::array<std::array<Ground, 5>, 2> grounds{{{{{"A", 1.0, 0.15, 0.4, 2.0},
                                                          {"B", 1.2, 0.15, 0.5, 2.0},
                                                          {"C", 1.15, 0.20, 0.6, 2.0},
                                                          {"D", 1.35, 0.20, 0.8, 2.0},
                                                          {"E", 1.4, 0.15, 0.5, 2.0}}},
                                                        {{{"A", 1.0, 0.05, 0.25, 1.2},
                                                          {"B", 1.35, 0.05, 0.25, 1.2},
                                                          {"C", 1.5, 0.10, 0.25, 1.2},
                                                          {"D", 1.8, 0.10, 0.30, 1.2},
                                                          {"E", 1.6, 0.05, 0.25, 1.2}}}}};

} // namespace

TargetSpectrum::TargetSpectrum(const std::string &text) {
  const std::string name(trim(std::string_view(text).substr(0, text.find(','))));
  is_asce_ = name == "asce7";
  if (is_asce_)
    read_asce(TargetKeys(text, {"S_DS", "S_D1", "T_L", "scale"}));
  else if (name == "en1998")
    read_en1998(TargetKeys(text, {"a_g", "ground", "type", "scale"}));
  else
    throw InputError(fmt::format("--target {}: {}", text, unknown_word(name, {"asce7", "en1998"})));
}

void TargetSpectrum::read_asce(const TargetKeys &keys) {
  short_ = keys.number("S_DS", 0, largest_target), one_ = keys.number("S_D1", 0, largest_target);
  long_period_ = keys.number("T_L", 0, 100, 8), scale_ = keys.number("scale", 0, 100, 1);
  if (one_ / short_ > long_period_)
    keys.fail(fmt::format("S_D1 / S_DS = {:g} s is beyond T_L = {:g} s", one_ / short_, long_period_));
  words_ = fmt::format("ASCE/SEI 7-22, S_DS = {:g} g, S_D1 = {:g} g, T_L = {:g} s{}", short_, one_, long_period_,
                       scale_ == 1 ? "" : fmt::format(", times {:g}", scale_));
}

void TargetSpectrum::read_en1998(const TargetKeys &keys) {
  ground_ = keys.number("a_g", 0, largest_target), scale_ = keys.number("scale", 0, 100, 1);
  const std::string type = keys.word("type", "1"), wanted = keys.word("ground", "");
  if (type != "1" && type != "2") keys.fail(fmt::format("type \"{}\" is neither 1 nor 2", type));
  for (const auto &ground : grounds[type == "1" ? 0 : 1])
    if (wanted == ground.type) {
      soil_ = ground.soil, t_b_ = ground.t_b, t_c_ = ground.t_c, t_d_ = ground.t_d;
      words_ = fmt::format("EN 1998-1, type {}, ground {}, a_g = {:g} g{}", type, wanted, ground_,
                           scale_ == 1 ? "" : fmt::format(", times {:g}", scale_));
      return;
    }
  keys.fail(wanted.empty() ? "ground is missing (A, B, C, D, E)"
                           : "ground " + unknown_word(wanted, {"A", "B", "C", "D", "E"}));
}

double TargetSpectrum::asce(double period) const {
  const double t_s = one_ / short_, t_0 = 0.2 * t_s;
  if (period < t_0) return short_ * (0.4 + 0.6 * period / t_0);
  if (period <= t_s) return short_;
  return period <= long_period_ ? one_ / period : one_ * long_period_ / (period * period);
}

double TargetSpectrum::en1998(double period) const {
  constexpr double plateau = 2.5;
  const double base = ground_ * soil_;
  if (period < t_b_) return base * (1 + (plateau - 1) * period / t_b_);
  if (period <= t_c_) return base * plateau;
  return period <= t_d_ ? base * plateau * t_c_ / period : base * plateau * t_c_ * t_d_ / (period * period);
}

double TargetSpectrum::at(double period) const {
  return scale_ * (is_asce_ ? asce(period) : en1998(period));
}

} // namespace rimpact
