#include "calibration/data/measured_table.h"
#include "io/files/binary_kind.h"
#include "io/files/character_set.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "responses/response_csv.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::calibration {
namespace {

bool holds(const std::vector<std::string> &cells, const std::string &name) {
  return std::find(cells.begin(), cells.end(), name) != cells.end();
}

/// Sets tried where bytes are no UTF-8 and no set is stated; western first.
constexpr const char *usual_sets[] = {"windows-1252", "windows-1254", "windows-1250", "shift_jis", "gb18030"};

std::size_t line_of(std::string_view bytes, std::size_t byte) {
  return 1 +
         static_cast<std::size_t>(std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(byte), '\n'));
}

/// Whether some line of `text` holds all names; blind to separators, for a set of characters is what is looked for.
bool names_stand_in(const std::string &text, const std::vector<std::string> &names) {
  for (const auto line : lines_of(text))
    if (std::all_of(names.begin(), names.end(), [&](const auto &name) { return line.find(name) != line.npos; }))
      return true;
  return false;
}

/// The file's text in UTF-8; a set that was found is told.
std::string decoded(const std::string &bytes, const std::string &path, const TableForm &form,
                    std::vector<std::string> &notes) {
  if (!form.encoding.empty()) {
    const auto text = utf8_from(bytes, form.encoding, path);
    if (!text) throw DataError(fmt::format("{}: is not written in {} from end to end", path, form.encoding));
    return *text;
  }
  const std::string text = utf8_text(bytes, path);
  const auto wrong = not_utf8(text);
  if (!wrong) return text;
  for (const char *set : usual_sets)
    if (const auto found = utf8_from(bytes, set, path); found && names_stand_in(*found, form.names)) {
      notes.push_back(
          fmt::format("{} is no UTF-8; it is read as {}, by which it has the columns named (encoding)", path, set));
      return *found;
    }
  throw DataError(fmt::format("{}:{}: byte 0x{:02X} is no UTF-8, and by none of {} has a line the columns \"{}\"; "
                              "state the character set: encoding = \"...\"",
                              path, line_of(text, *wrong), static_cast<unsigned char>(text[*wrong]),
                              fmt::join(usual_sets, ", "), fmt::join(form.names, "\", \"")));
}

bool is_remark(std::string_view line) {
  return trim(line).empty() || trim(line).front() == '#';
}

} // namespace

std::string unit_as_mapped(std::string written) {
  std::string unit(trim(written));
  if (unit.size() > 2 && (unit.front() == '[' || unit.front() == '(')) unit = unit.substr(1, unit.size() - 2);
  if (const auto slash = unit.find('/'); slash != std::string::npos) unit.replace(slash, 1, "_per_");
  return unit == "sec" ? "s" : unit;
}

MeasuredTable::MeasuredTable(const std::string &bytes, const std::string &path, const TableForm &form) : path_(path) {
  refuse_binary(bytes, path);
  const std::string text = decoded(bytes, path, form, notes_);
  const Lines lines = lines_of(text);
  read_rows(lines, find_header(lines, form), form);
  take_units(form.names);
  leave_out_footer(form.names);
  if (rows_.empty()) throw DataError(fmt::format("{}: the table has no rows below its header", path));
}

std::size_t MeasuredTable::names_in(std::string_view line, char separator, const std::vector<std::string> &names) {
  if (std::none_of(names.begin(), names.end(), [&](const auto &name) { return line.find(name) != line.npos; }))
    return 0;
  const auto cells = cells_of(line, separator);
  return static_cast<std::size_t>(
      std::count_if(names.begin(), names.end(), [&](const auto &name) { return holds(cells, name); }));
}

/// By the names; where no line has all of them, the one with most is taken, and what it misses is said by who needs it.
std::size_t MeasuredTable::find_header(const Lines &lines, const TableForm &form) {
  std::size_t first = static_cast<std::size_t>(form.skip_lines);
  std::optional<char> stated;
  while (first < lines.size() && (is_remark(lines[first]) || stated_separator(lines[first]))) {
    if (const auto said = stated_separator(lines[first])) stated = said;
    ++first;
  }
  if (first >= lines.size()) throw DataError(fmt::format("{}: holds no header line", path_));
  std::size_t header = first, most = 0;
  separator_ = stated.value_or(separator_of(lines[first]));
  int seen = 0; // lines with all names
  for (std::size_t i = first;
       i < lines.size() && (form.skip_lines == 0 || form.block > 0) && seen < std::max(1, form.block); ++i)
    for (const char separator : {stated.value_or(separator_of(lines[i])), ';', '\t', ','}) {
      const std::size_t found = names_in(lines[i], separator, form.names);
      const bool all = found == form.names.size();
      if (all || (seen == 0 && found > most)) header = i, separator_ = separator, most = found;
      if (!all) continue;
      ++seen;
      break;
    }
  if (seen < form.block)
    throw DataError(fmt::format("{}: block {} is asked for, but {} line{} ha{} the columns \"{}\"", path_, form.block,
                                seen, seen == 1 ? "" : "s", seen == 1 ? "s" : "ve", fmt::join(form.names, "\", \"")));
  header_ = cells_of(lines[header], separator_);
  for (const auto &name : form.names)
    if (std::count(header_.begin(), header_.end(), name) > 1)
      throw DataError(fmt::format("{}: column \"{}\" stands twice", path_, name));
  return header + 1; // the first row
}

void MeasuredTable::read_rows(const Lines &lines, std::size_t first, const TableForm &form) {
  for (std::size_t i = first; i < lines.size(); ++i) {
    if (form.block > 0 && (trim(lines[i]).empty() && !rows_.empty())) break;
    if (is_remark(lines[i])) continue;
    Row row{i + 1, cells_of(lines[i], separator_)};
    if (row.cells == header_) {
      if (form.block > 0) break;
      throw DataError(fmt::format("{}:{}: the names of the columns stand again: the file holds several tests; say "
                                  "which by block = 1, 2, ... (or [test.NAME] block = ...)",
                                  path_, i + 1));
    }
    rows_.push_back(std::move(row));
  }
}

bool MeasuredTable::has_number(const Row &row, const std::vector<std::string> &names) const {
  return std::any_of(names.begin(), names.end(), [&](const auto &name) {
    if (!has(name) || place(name) >= row.cells.size()) return false;
    const auto &cell = row.cells[place(name)];
    const auto with_point = decimal_point_for(cell);
    return to_number(with_point ? *with_point : cell).has_value();
  });
}

/// A first row without any number is no sample: its words are units where they are known as such.
void MeasuredTable::take_units(const std::vector<std::string> &names) {
  if (rows_.empty() || has_number(rows_.front(), names)) return;
  units_ = rows_.front().cells;
  units_.resize(header_.size());
  const bool known = std::any_of(units_.begin(), units_.end(),
                                 [](const auto &cell) { return csv_unit(unit_as_mapped(cell)).has_value(); });
  notes_.push_back(fmt::format("{}:{}: {}", path_, rows_.front().line,
                               known ? "a row of units" : "no row of numbers below the names: it is left out"));
  if (!known) units_.clear();
  rows_.erase(rows_.begin());
}

/// Words below the last row of numbers.
void MeasuredTable::leave_out_footer(const std::vector<std::string> &names) {
  std::size_t kept = rows_.size();
  const auto starts_with_time = [&](const Row &row) { return has_number(row, {names.front()}); };
  while (kept > 0 && !starts_with_time(rows_[kept - 1])) --kept;
  if (kept == 0 || kept == rows_.size()) return;
  if (names.size() > 1 &&
      std::any_of(rows_.begin() + static_cast<std::ptrdiff_t>(kept), rows_.end(), [&](const Row &row) {
        const std::vector<std::string> others(names.begin() + 1, names.end());
        return trim(row.cells[std::min(place(names.front()), row.cells.size() - 1)]).empty() && has_number(row, others);
      }))
    return; // samples without an instant of this clock: a channel has its own, or the table is broken
  notes_.push_back(fmt::format("{}:{}: {} line{} below the table left out, from \"{}\" on", path_, rows_[kept].line,
                               rows_.size() - kept, rows_.size() - kept == 1 ? "" : "s",
                               rows_[kept].cells.front().substr(0, 40)));
  rows_.resize(kept);
}

bool MeasuredTable::has(const std::string &column) const {
  return holds(header_, column);
}

std::size_t MeasuredTable::place(const std::string &column) const {
  return static_cast<std::size_t>(std::find(header_.begin(), header_.end(), column) - header_.begin());
}

const std::string &MeasuredTable::text(std::size_t row, const std::string &column) const {
  const auto at = place(column);
  if (at >= rows_[row].cells.size())
    throw DataError(
        fmt::format("{}:{}: {} of {} columns", path_, rows_[row].line, rows_[row].cells.size(), header_.size()));
  return rows_[row].cells[at];
}

double MeasuredTable::number(std::size_t row, const std::string &column) const {
  const std::string &cell = text(row, column);
  const auto value = decimals_.number(cell, fmt::format("{}:{}", path_, rows_[row].line));
  if (!value)
    throw DataError(fmt::format("{}:{}: \"{}\" is not a finite number", path_, rows_[row].line, cell.substr(0, 40)));
  return *value;
}

std::string MeasuredTable::unit(const std::string &column) const {
  if (!units_.empty() && csv_unit(unit_as_mapped(units_[place(column)]))) return unit_as_mapped(units_[place(column)]);
  const auto open = column.find_last_of("[(");
  if (open == std::string::npos || (column.back() != ']' && column.back() != ')')) return "";
  return unit_as_mapped(column.substr(open));
}

std::vector<std::string> MeasuredTable::notes() const {
  auto all = notes_;
  if (decimals_.comma()) all.push_back(path_ + " is read with a decimal comma");
  return all;
}

} // namespace rimpact::calibration
