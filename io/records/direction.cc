#include "io/records/direction.h"
#include "io/files/digit.h"
#include "io/files/text.h"
#include <algorithm>

namespace rimpact {
namespace {

/// What has to stand before a spelling at the end of a file's name, from the least to the most that is asked.
enum class Before { anything, digit, mark };

struct Spelling {
  std::string_view word;
  DirectionKind kind;
  double azimuth; ///< [deg], negative: none
  Before before;
};
constexpr auto vertical_axis = DirectionKind::vertical, level_axis = DirectionKind::horizontal;
constexpr double no_azimuth = -1;
constexpr Spelling spellings[] = {
    {"UP", vertical_axis, no_azimuth, Before::digit},
    {"UD", vertical_axis, no_azimuth, Before::digit},
    {"UPDOWN", vertical_axis, no_azimuth, Before::anything},
    {"UPDO", vertical_axis, no_azimuth, Before::mark},
    {"DOWN", vertical_axis, no_azimuth, Before::anything},
    {"DWN", vertical_axis, no_azimuth, Before::anything},
    {"DN", vertical_axis, no_azimuth, Before::mark},
    {"U", vertical_axis, no_azimuth, Before::mark},
    {"V", vertical_axis, no_azimuth, Before::digit},
    {"Z", vertical_axis, no_azimuth, Before::digit},
    {"VER", vertical_axis, no_azimuth, Before::anything},
    {"VERT", vertical_axis, no_azimuth, Before::anything},
    {"VRT", vertical_axis, no_azimuth, Before::anything},
    {"VT", vertical_axis, no_azimuth, Before::mark},
    {"V1", vertical_axis, no_azimuth, Before::mark},
    {"VERTICAL", vertical_axis, no_azimuth, Before::anything},
    {"UD1", vertical_axis, no_azimuth, Before::digit},
    {"UD2", vertical_axis, no_azimuth, Before::digit},
    {"N", level_axis, 360, Before::digit},
    {"E", level_axis, 90, Before::digit},
    {"S", level_axis, 180, Before::digit},
    {"W", level_axis, 270, Before::digit},
    {"NS", level_axis, 360, Before::digit},
    {"EW", level_axis, 90, Before::digit},
    {"SN", level_axis, 360, Before::digit},
    {"WE", level_axis, 90, Before::digit},
    {"NS1", level_axis, 360, Before::digit},
    {"EW1", level_axis, 90, Before::digit},
    {"NS2", level_axis, 360, Before::digit},
    {"EW2", level_axis, 90, Before::digit},
    {"NORTH", level_axis, 360, Before::mark},
    {"EAST", level_axis, 90, Before::mark},
    {"SOUTH", level_axis, 180, Before::mark},
    {"WEST", level_axis, 270, Before::mark},
    {"L", level_axis, no_azimuth, Before::mark},
    {"T", level_axis, no_azimuth, Before::mark},
    {"L1", level_axis, no_azimuth, Before::mark},
    {"T1", level_axis, no_azimuth, Before::mark},
    {"LN", level_axis, no_azimuth, Before::mark},
    {"TR", level_axis, no_azimuth, Before::mark},
    {"LONG", level_axis, no_azimuth, Before::mark},
    {"TRAN", level_axis, no_azimuth, Before::mark},
    {"TRANS", level_axis, no_azimuth, Before::mark},
    {"LONGITUDINAL", level_axis, no_azimuth, Before::mark},
    {"H1", level_axis, no_azimuth, Before::mark},
    {"TRANSVERSE", level_axis, no_azimuth, Before::mark},
    {"H2", level_axis, no_azimuth, Before::mark},
    {"FN", level_axis, no_azimuth, Before::mark},
    {"FP", level_axis, no_azimuth, Before::mark},
    {"X", level_axis, no_azimuth, Before::mark},
    {"Y", level_axis, no_azimuth, Before::mark},
    {"HORIZONTAL", level_axis, no_azimuth, Before::mark},
    {"RADIAL", level_axis, no_azimuth, Before::mark},
    {"TANGENTIAL", level_axis, no_azimuth, Before::mark},
};
constexpr std::size_t longest = 12;

/// "N55W", "S5E": from north or south towards east or west.
std::optional<double> quadrant(std::string_view word) {
  if (word.size() < 3 || word.size() > 4 || (word.front() != 'N' && word.front() != 'S') ||
      (word.back() != 'E' && word.back() != 'W'))
    return std::nullopt;
  const auto inner = word.substr(1, word.size() - 2);
  if (!std::all_of(inner.begin(), inner.end(), is_digit)) return std::nullopt;
  const double angle = *to_number(inner);
  if (angle > 90) return std::nullopt;
  if (word.front() == 'N') return word.back() == 'E' ? angle : 360 - angle;
  return word.back() == 'E' ? 180 - angle : 180 + angle;
}

/// Streams of SEED: band, an accelerometer's letter, then Z, N, E, or 1 and 2 for axes of its own.
std::optional<Direction> stream(std::string_view word) {
  if (word.size() != 3 || std::string_view("HBEC").find(word[0]) == std::string_view::npos ||
      std::string_view("NLG").find(word[1]) == std::string_view::npos)
    return std::nullopt;
  switch (word[2]) {
  case 'Z':
    return Direction{vertical_axis, std::nullopt, std::string(word)};
  case 'N':
    return Direction{level_axis, 360, std::string(word)};
  case 'E':
    return Direction{level_axis, 90, std::string(word)};
  case '1':
  case '2':
    return Direction{level_axis, std::nullopt, std::string(word)};
  default:
    return std::nullopt;
  }
}

/// An azimuth of `n_digits` digits, or of any number up to three where it is 0.
std::optional<double> azimuth(std::string_view word, std::size_t n_digits) {
  if (word.empty() || word.size() > 3 || (n_digits > 0 && word.size() != n_digits) ||
      !std::all_of(word.begin(), word.end(), is_digit))
    return std::nullopt;
  const double angle = *to_number(word);
  return angle <= 360 ? std::optional(angle) : std::nullopt;
}

Direction of(const Spelling &known) {
  return {known.kind, known.azimuth < 0 ? std::nullopt : std::optional(known.azimuth), std::string(known.word)};
}

bool is_mark(char c) {
  return c == '-' || c == '_' || c == '.' || c == ' ';
}

/// Whether a spelling may follow `before`, the name without it.
bool may_follow(Before needed, std::string_view before, bool is_peers) {
  if (before.empty() || needed == Before::anything || is_mark(before.back())) return true;
  return needed == Before::digit && (is_digit(before.back()) || is_peers);
}

Direction ending(std::string_view name, std::size_t length, bool is_peers) {
  const auto before = name.substr(0, name.size() - length), word = name.substr(name.size() - length);
  if (const auto angle = quadrant(word)) return {level_axis, angle, std::string(word)};
  if (const auto angle = azimuth(word, 3)) return {level_axis, angle, std::string(word)};
  if (const auto code = stream(word); code && may_follow(Before::mark, before, false)) return *code;
  for (const auto &known : spellings)
    if (known.word == word && may_follow(known.before, before, is_peers)) return of(known);
  return {};
}

} // namespace

Direction direction_written(std::string_view given) {
  std::string word = upper(trim(given));
  for (const std::string_view title : {"COMPONENT", "COMP", "DIRECTION", "DIR", "AZIMUTH", "AZ"})
    if (word.starts_with(title) && word.size() > title.size()) {
      word.erase(0, title.size());
      break;
    }
  std::erase_if(word, [](char c) { // "N 55 W", "E-W", "360 deg.", the degree sign in UTF-8
    return c == ' ' || c == '-' || c == '.' || c == ':' || c == '=' || static_cast<unsigned char>(c) >= 0x80;
  });
  for (const std::string_view unit : {"DEGREES", "DEG"})
    if (word.ends_with(unit)) {
      word.erase(word.size() - unit.size());
      break;
    }
  if (const auto angle = azimuth(word, 0)) return {level_axis, angle, word};
  if (const auto angle = quadrant(word)) return {level_axis, angle, word};
  if (const auto code = stream(word)) return *code;
  for (const auto &known : spellings)
    if (known.word == word) return of(known);
  return {};
}

NamedDirection direction_in_name(std::string_view stem) {
  const std::string name = upper(stem);
  const bool is_peers = name.starts_with("RSN") && name.size() > 3 && is_digit(name[3]);
  for (std::size_t length = std::min(longest, name.empty() ? 0 : name.size() - 1); length > 0; --length) {
    auto direction = ending(name, length, is_peers);
    if (direction.kind == DirectionKind::unknown) continue;
    std::size_t end = name.size() - length;
    while (end > 1 && is_mark(name[end - 1])) --end;
    return {std::string(stem.substr(0, end)), std::move(direction)};
  }
  return {std::string(stem), {}};
}

} // namespace rimpact
