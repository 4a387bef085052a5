#include "io/records/record_table.h"
#include "io/files/error.h"
#include "io/files/loose_cells.h"
#include "io/files/text.h"
#include "io/records/direction.h"
#include "io/records/record_units.h"
#include <algorithm>
#include <fmt/format.h>

namespace rimpact {
namespace {

constexpr std::size_t no_column = std::string::npos;

/// Columns of spectra have units of time and acceleration, too.
bool is_spectral(const std::string &name) {
  const std::string word = upper(name);
  for (const char *opening : {"SA", "PSA", "S_A", "PERIOD", "PERIODE", "FREQ"})
    if (word.starts_with(opening)) return true;
  return word.find("SPECTR") != std::string::npos || word.find("SPEKTR") != std::string::npos;
}

/// The unit in a column's name: "time_s", "Acceleration (cm/s2)", "Beschleunigung [m/s²]". Without brackets only names
/// that begin as time or acceleration have one: other tables have columns that end so.
std::string unit_in_name(const std::string &name) {
  const auto open = name.find_last_of("[("), close = name.find_last_of("])");
  if (open != std::string::npos && close != std::string::npos && open < close)
    return name.substr(open + 1, close - open - 1);
  const std::string word = upper(name);
  if (!word.starts_with("T_") && !word.starts_with("TIME") && !word.starts_with("A_") && !word.starts_with("ACC"))
    return {};
  if (name.ends_with("_m_per_s2")) return "m/s2";
  if (name.ends_with("_cm_per_s2")) return "cm/s2";
  const auto mark = name.rfind('_');
  return mark == std::string::npos ? "" : name.substr(mark + 1);
}

bool is_seconds(const std::string &unit) {
  const std::string capitals = upper(trim(unit));
  return capitals == "S" || capitals == "SEC" || capitals == "SECS" || capitals == "SECONDS" || capitals == "SEK" ||
         capitals == "SEG" || capitals == "[S]" || capitals == "(S)" || capitals == "[SEC]" || capitals == "(SEC)";
}

/// Two columns for the same quantity contradict each other: which one is meant the file does not say.
[[noreturn]] void refuse_second(std::size_t first, std::size_t second, const std::vector<std::string> &names,
                                const std::string &where) {
  throw DataError(fmt::format("{}: column {} \"{}\" gives what column {} \"{}\" gives already; keep one of them", where,
                              second + 1, names[second], first + 1, names[first]));
}

/// "NS" of "NS (gal)", "acc_EW_gal" and "a NS [m/s2]": what is left without unit and the words for acceleration.
std::string direction_in_column(const std::string &name) {
  std::string word = upper(name);
  if (const auto open = word.find_last_of("[("); open != std::string::npos) word.resize(open);
  for (const char *unit : {"_M_PER_S2", "_CM_PER_S2", "_M_S2", "_CM_S2", "_GAL", "_G"})
    if (word.ends_with(unit)) {
      word.resize(word.size() - std::string_view(unit).size());
      break;
    }
  for (const std::string_view opening : {"ACCELERATION", "ACCEL", "ACC", "A_", "A "})
    if (word.starts_with(opening)) {
      word.erase(0, opening.size());
      break;
    }
  while (!word.empty() && std::string_view("_.- ").find(word.front()) != std::string_view::npos) word.erase(0, 1);
  return std::string(trim(word));
}

bool is_one_way(const Direction &one, const Direction &two) {
  if (one.kind != two.kind) return false;
  return one.kind == DirectionKind::vertical || (one.azimuth_deg && one.azimuth_deg == two.azimuth_deg) ||
         one.spelling == two.spelling;
}

/// Several accelerations are channels where each has a direction of its own.
void require_directions(const std::vector<AccelerationColumn> &columns, const std::vector<std::string> &names,
                        const std::string &where) {
  for (std::size_t i = 1; i < columns.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const auto one = direction_written(columns[k].direction), two = direction_written(columns[i].direction);
      if (one.kind == DirectionKind::unknown || two.kind == DirectionKind::unknown || is_one_way(one, two))
        refuse_second(columns[k].index, columns[i].index, names, where);
    }
}

} // namespace

std::optional<RecordColumns> record_columns(const std::string &header, const std::string &below, double gravity,
                                            const std::string &where) {
  RecordColumns columns{.time = no_column};
  columns.separator = separator_of(header);
  const auto names = cells_of(header, columns.separator), units = cells_of(below, columns.separator);
  columns.count = names.size();
  const auto is_number = [](const std::string &cell) { return to_number(cell) || decimal_point_for(cell); };
  const bool has_units = units.size() == names.size() && std::none_of(units.begin(), units.end(), is_number);
  bool from_below = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (is_number(names[i]) || is_spectral(names[i])) return std::nullopt;
    std::string unit = unit_in_name(names[i]);
    const bool is_known = is_seconds(unit) || acceleration_unit(unit, gravity);
    if (!is_known && has_units) unit = units[i], from_below = true;
    if (is_seconds(unit)) {
      if (columns.time != no_column) refuse_second(columns.time, i, names, where);
      columns.time = i;
    }
    if (const auto value = acceleration_unit(unit, gravity))
      columns.accelerations.push_back({i, *value, direction_in_column(names[i])});
  }
  if (columns.time == no_column || columns.accelerations.empty()) return std::nullopt;
  require_directions(columns.accelerations, names, where);
  columns.lines = from_below ? 2 : 1;
  return columns;
}

} // namespace rimpact
