#include "io/records/record_units.h"
#include "io/files/digit.h"
#include "io/files/text.h"
#include <cctype>
#include <string>

namespace rimpact {
namespace {

struct AccelerationUnit {
  std::string_view name;
  double value; ///< [m/s^2]; 0: gravity
};
/// A name that another one begins with stands behind it.
constexpr AccelerationUnit acceleration_units[] = {{"CM/S/S", 0.01},  {"CM/SEC/SEC", 0.01},
                                                   {"CM/S**2", 0.01}, {"CM/SEC**2", 0.01},
                                                   {"CM/S^2", 0.01},  {"CM/SEC^2", 0.01},
                                                   {"CM/S2", 0.01},   {"CM/SEC2", 0.01},
                                                   {"GALS", 0.01},    {"GAL", 0.01},
                                                   {"M/S/S", 1.0},    {"M/SEC/SEC", 1.0},
                                                   {"M/S**2", 1.0},   {"M/SEC**2", 1.0},
                                                   {"M/S^2", 1.0},    {"M/SEC^2", 1.0},
                                                   {"M/S2", 1.0},     {"M/SEC2", 1.0},
                                                   {"MM/S2", 0.001},  {"MM/S^2", 0.001},
                                                   {"G'S", 0},        {"G", 0}};

/// Capitals without blanks and brackets; a raised 2 of UTF-8 or Latin-1 is a 2.
std::string plain(std::string_view name) {
  std::string text;
  for (const char c : upper(name))
    if (static_cast<unsigned char>(c) == 0xB2)
      text += '2';
    else if (std::string_view(" []()").find(c) == std::string_view::npos && static_cast<unsigned char>(c) < 0x80)
      text += c;
  return text;
}

double value_of(const AccelerationUnit &unit, double gravity) {
  return unit.value > 0 ? unit.value : gravity;
}

} // namespace

std::optional<double> acceleration_unit(std::string_view name, double gravity) {
  const std::string wanted = plain(name);
  for (const auto &unit : acceleration_units)
    if (wanted == unit.name) return value_of(unit, gravity);
  return std::nullopt;
}

std::optional<double> leading_acceleration_unit(std::string_view text, double gravity) {
  for (const auto &unit : acceleration_units) {
    if (!text.starts_with(unit.name)) continue;
    const std::string_view rest = text.substr(unit.name.size()), next = trim(rest);
    if (!next.empty() && std::string_view("/*^+-=%").find(next.front()) != std::string_view::npos) return std::nullopt;
    if (!next.empty() && (is_digit(next.front()) || next.starts_with("X "))) return std::nullopt;
    for (const std::string_view word : {"FACTOR", "SCALE", "TIMES", "MULTIPL"})
      if (rest.find(word) != std::string_view::npos) return std::nullopt;
    if (rest.empty() || std::isalnum(static_cast<unsigned char>(rest.front())) == 0) return value_of(unit, gravity);
  }
  return std::nullopt;
}

} // namespace rimpact
