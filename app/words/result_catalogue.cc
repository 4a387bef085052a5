#include "app/words/result_catalogue.h"

#include "io/files/error.h"
#include "responses/response.h"
#include "responses/response_csv.h"
#include <fmt/format.h>
#include <optional>

namespace rimpact::app {
namespace {

/// What stands before the number of a signal that a family has one of for each bearing, floor or point; empty: of none.
std::string family(const std::string &name) {
  const auto digit = [&](std::size_t at) { return at < name.size() && name[at] >= '0' && name[at] <= '9'; };
  for (const std::string what : {"bearing_", "floor_", "member_", "normal_A", "normal_B", "normal_C", "normal_D"})
    if (name.starts_with(what) && digit(what.size())) return what;
  return {};
}

/// The first of a family stands for all of it, as bearing_N_force_x; the others are left out.
std::optional<SignalInfo> common(SignalInfo signal) {
  const std::string what = family(signal.name);
  if (what.empty()) return signal;
  const std::size_t behind = signal.name.find_first_not_of("0123456789", what.size());
  const std::string rest = behind == std::string::npos ? "" : signal.name.substr(behind);
  if (signal.name != what + "1" + rest) return {};
  signal.name = what + "N" + rest;
  if (const auto one = signal.description.find('1'); one != std::string::npos) signal.description.replace(one, 1, "N");
  return signal;
}

} // namespace

NamedTexts signals() {
  NamedTexts list;
  for (const auto &known : known_signals())
    if (const auto signal = common(known))
      list.emplace_back(signal->name,
                        fmt::format("{}: {}", signal->units == "1" ? "-" : signal->units, signal->description));
  return list;
}

NamedTexts columns() {
  NamedTexts list;
  for (const auto &column : csv_columns())
    list.emplace_back(fmt::format("{}_{}", column.symbol, column.unit),
                      fmt::format("{}{}", column.signal, column.written ? "" : " (read only)"));
  return list;
}

NamedTexts files() {
  return {
      {"scene.toml", "of a run: the scene as resolved, every default written out; runs again anywhere"},
      {"response.h5", "of a run: one data set a signal under /response, each with units and description; /meta: "
                      "version, scene, commit"},
      {"response.csv", "of a run: the main signals, one row an instant"},
      {"summary.json", "of a run: peaks, impacts, energy ledger, cost, warnings, status"},
      {"log.txt", "of a finite-element run: what was said, and one line a step"},
      {"checkpoint.h5", "of a finite-element run: where --resume goes on"},
      {"fields.pvd", "of a finite-element run: the times of the fields, for ParaView"},
      {"fields/*.vtu", "of a finite-element run: displacement, stress, plastic strain, pressure and gap"},
      {"response.png", "of a run with --png: the main histories and loops"},
      {"report.html", "of `report` and `main`: one self-contained page"},
      {"calibration.json", "of `calibrate`: the answer, the fit and what stands behind it"},
      {"calibration.toml", "of `calibrate`: the answer's law as [reduced] of a scene"},
      {"fitted-scene.toml", "of `calibrate`: bearing, load and [reduced] of the fitted runs, for `export`"},
      {"table.csv, table.h5", "of a sweep: one row a run, its parameters and results"},
      {"fractiles.csv, fractiles.h5", "of a sweep with [fractiles]: quantiles along one key"},
      {"runs.h5", "of a reliability study: the table of all runs, its columns read where they stand in systems/"},
      {"spectrum.csv", "of `motion --spectrum` and `--select`: response spectra"},
      {"limits.json", "of a sweep: which share of the hits lies where the models are not known to hold, and doubts"},
      {"fleet.json", "of a sweep: what its rows are of"},
      {"main.json", "of `main`: the comparison, the warnings, where bearing and load come from"},
      {"curve.h5, curve.csv, curve.json", "of `curve`: the rim's quasi-static paths, their samples, what was printed"}};
}

NamedTexts exit_codes() {
  const std::pair<ExitCode, const char *> codes[] = {
      {ExitCode::done, "done"},
      {ExitCode::bug, "a bug: please report it"},
      {ExitCode::input, "the command line or a TOML file: the message names file, line, value and bound"},
      {ExitCode::data, "a data file: a record, a table, a mesh, a response"},
      {ExitCode::stopped, "the solver stopped: what is before it, and a checkpoint, are kept"},
      {ExitCode::gate, "a gate of calibrate, study or compare was not met"},
      {ExitCode::io, "reading or writing failed, or another process has the folder"},
      {ExitCode::interrupted, "interrupted: --resume goes on"}};
  NamedTexts list;
  for (const auto &[code, text] : codes) list.emplace_back(fmt::format("{}", static_cast<int>(code)), text);
  return list;
}

} // namespace rimpact::app
