#include "records/record_table.h"
#include "files/error.h"
#include "files/loose_cells.h"
#include "files/text.h"
#include "records/record_units.h"
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
void claim(std::size_t &column, std::size_t index, const std::vector<std::string> &names, const std::string &where) {
  if (column != no_column)
    throw DataError(fmt::format("{}: column {} \"{}\" gives what column {} \"{}\" gives already; keep one of them",
                                where, index + 1, names[index], column + 1, names[column]));
  column = index;
}

} // namespace

std::optional<RecordColumns> record_columns(const std::string &header, const std::string &below, double gravity,
                                            const std::string &where) {
  RecordColumns columns{.time = no_column, .acceleration = no_column};
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
    if (is_seconds(unit)) claim(columns.time, i, names, where);
    if (const auto value = acceleration_unit(unit, gravity)) {
      claim(columns.acceleration, i, names, where);
      columns.unit = *value;
    }
  }
  if (columns.time == no_column || columns.acceleration == no_column) return std::nullopt;
  columns.lines = from_below ? 2 : 1;
  return columns;
}

} // namespace rimpact
