// rimpact motion FILE|FOLDER...: what is in records.
#include "app/console/child_process.h"
#include "app/jobs/motion_choice.h"
#include "app/jobs/motion_spectrum.h"
#include "app/verbs/catalogue.h"
#include "app/words/motion_table.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "io/records/record_corrections.h"
#include "io/records/record_doubts.h"
#include "io/records/record_file.h"
#include "io/records/record_library.h"
#include "responses/response.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace rimpact::app {
namespace {

/// Where each record's picture goes, without its extension. Throws where two would go to one place.
std::vector<std::string> picture_places(const std::vector<std::string> &files, const std::string &folder) {
  std::vector<std::string> places;
  for (const auto &file : files) {
    places.push_back(folder + "/" + record_label(file));
    const auto before = std::find(places.begin(), places.end() - 1, places.back());
    if (before != places.end() - 1)
      throw InputError(fmt::format("{} and {} would both be drawn as {}.png; draw them into two folders",
                                   files[before - places.begin()], file, places.back()));
  }
  return places;
}

/// Acceleration, velocity and displacement for the plot.
std::string motion_csv(const SampledSignal &record) {
  std::string text = "time_s,acceleration_m_per_s2,velocity_m_per_s,displacement_m\n";
  integrate_from_rest(record, [&](std::size_t i, double v, double u) {
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", record.instant(i), record.values[i], v, u);
  });
  return text;
}

/// A record and its plot, each where `base` says.
void draw_record(const std::string &name, const std::string &base) {
  write_atomically(motion_csv(read_record(name)), base + ".csv");
  if (python({"report.motion", base + ".csv", base + ".png"}) != 0)
    throw IoError("the plot " + base + ".png was not made");
}

void draw_records(const std::vector<MotionRow> &rows, const std::string &folder) {
  std::vector<std::string> names;
  for (const auto &row : rows)
    if (row.info) names.push_back(row.record.path);
  const auto places = picture_places(names, folder);
  make_folder(folder);
  for (std::size_t k = 0; k < names.size(); ++k) draw_record(names[k], places[k]);
}

/// What a folder's components are, in words behind its table.
std::string folder_in_words(const RecordFolder &folder) {
  const auto pairs =
      std::count_if(folder.stations.begin(), folder.stations.end(), [](const auto &s) { return s.is_pair(); });
  return fmt::format("{} records of {} stations, {} of them with two horizontal components", folder.records.size(),
                     folder.stations.size(), pairs);
}

void ask_about(const RecordFolder &folder, Console &console) {
  const std::string path = corrections_path(folder.path);
  write_atomically(records_csv(folder), path);
  console.message(fmt::format("{} says what was understood; correct it, and it counts from now on", path));
}

struct MotionOptions {
  std::vector<std::string> names;
  std::string picture, corrected, spectra;
  double period = 0; ///< [s], 0: no spectral acceleration
  bool ask = false;
  SelectionOptions selection;
  double strike = -1; ///< [deg], negative: not given
  std::string rotated;
  std::vector<double> range{0.2, 1.5}; ///< of periods, over `period`
};

/// The one folder that a selection or a rotation is of.
void choose_from(const MotionOptions &options, Console &console) {
  if (options.names.size() != 1) throw InputError("--select and --strike take one folder of records");
  const std::string given = options.names.front();
  const std::string name = std::filesystem::exists(given) ? given : find_record(given, ".");
  const RecordFolder folder = read_record_folder(name);
  folder.require_any();
  if (const std::string question = folder.question(); !question.empty()) console.warn(question);
  if (options.strike >= 0) rotate_motions(folder, options.strike, options.rotated, console);
  if (options.selection.rules.count == 0) return;
  SelectionOptions selection = options.selection;
  if (options.period == 0) throw InputError("--select needs --period, that of the structure [s]");
  selection.rules.period = options.period;
  selection.rules.from = options.range[0], selection.rules.to = options.range[1];
  if (!(options.range[0] < options.range[1])) throw InputError("--range A,B needs A below B");
  select_motions(folder, selection, console);
}

/// Each record with its baseline taken off, as a CSV of its own.
void write_corrected(const std::vector<MotionRow> &rows, const std::string &folder, Console &console) {
  make_folder(folder);
  for (const auto &row : rows) {
    if (!row.info) continue;
    const std::string path = folder + "/" + record_label(row.record.path) + ".csv";
    write_atomically(acceleration_csv(baseline_corrected(read_record(row.record.path))), path);
    console.message(fmt::format("{}: {} with its baseline corrected", path, row.record.path));
  }
}

std::vector<MotionRow> motion_rows(const std::string &given, const MotionOptions &options, Console &console) {
  const std::string name = std::filesystem::exists(given) ? given : find_record(given, ".");
  if (!holds_records(name)) {
    if (options.ask)
      throw InputError(fmt::format("--ask writes records.csv for a folder or a zip archive, and {} is none", given));
    return rows_of_file(name, options.period);
  }
  const RecordFolder folder = read_record_folder(name);
  folder.require_any();
  if (options.ask) ask_about(folder, console);
  console.message(folder_in_words(folder));
  if (const std::string question = folder.question(); !options.ask && !question.empty()) console.warn(question);
  return rows_of_folder(folder, options.period);
}

void look_at_motions(const MotionOptions &options, Console &console) {
  const std::string &target = options.selection.target;
  if (!target.empty() && options.selection.rules.count == 0 && options.spectra.empty())
    throw InputError("--target belongs to --select or --spectrum");
  if (options.selection.rules.count > 0 || options.strike >= 0) {
    if (options.ask || !(options.picture + options.corrected + options.spectra).empty())
      throw InputError("--select and --strike stand without --ask, --png, --baseline and --spectrum");
    return choose_from(options, console);
  }
  std::vector<MotionRow> all;
  std::string text;
  for (const auto &name : options.names) {
    auto rows = motion_rows(name, options, console);
    text += holds_records(name) ? motion_table(rows) : motion_lines(rows);
    std::move(rows.begin(), rows.end(), std::back_inserter(all));
  }
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto &row : all) json.push_back(to_json(row));
  console.data(console.json ? json_text(json) : text);
  if (!options.picture.empty()) draw_records(all, options.picture);
  if (!options.spectra.empty()) write_spectra(all, target, options.spectra, console);
  if (!options.corrected.empty()) write_corrected(all, options.corrected, console);
}

/// --select and --strike with what belongs to them.
void add_choices(CLI::App &verb, const std::shared_ptr<MotionOptions> &options) {
  auto *select = verb.add_option("--select", options->selection.rules.count,
                                 "of a folder: so many recordings whose spectra fit --target best, scaled to it")
                     ->check(CLI::Range(1, 1000));
  auto *target =
      verb.add_option("--target", options->selection.target,
                      "of --select and --spectrum: asce7,S_DS=g,S_D1=g,T_L=s or en1998,a_g=g,ground=A..E,type=1|2");
  auto *out = verb.add_option("-o,--output", options->selection.folder,
                              "of --select: folder for sweep.toml, spectrum.csv and .png, selection.csv");
  verb.add_option("--range", options->range, "of --select: periods from A to B times --period (0.2 1.5)")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(0.01, 10.0))
      ->needs(select);
  verb.add_option("--largest-scale", options->selection.rules.largest_scale,
                  "of --select: factors beyond it, or below its inverse, are not taken (5)")
      ->check(CLI::Range(1.0, 1000.0))
      ->needs(select);
  select->needs(target)->needs(out);
  out->needs(select);
  auto *strike = verb.add_option("--strike", options->strike,
                                 "of a folder: turns every pair to fault-normal and fault-parallel [deg from north]")
                     ->check(CLI::Range(0.0, 360.0));
  auto *rotated = verb.add_option("--rotated", options->rotated, "folder for what --strike makes, as CSV");
  strike->needs(rotated);
  rotated->needs(strike);
}

void add_motion(CLI::App &verb, Console &console) {
  auto options = std::make_shared<MotionOptions>();
  verb.add_option("FILE", options->names,
                  "records of any form, FILE#2 for a channel, or folders and zip archives of them")
      ->required();
  verb.add_option("--png", options->picture, "folder for a plot of each record");
  verb.add_flag("--ask", options->ask,
                "writes records.csv into a folder, or beside an archive: stations and directions, to be corrected");
  verb.add_option("--period", options->period, "S_a at this period [s] with 5 % damping, of pairs RotD50 and RotD100")
      ->check(CLI::Range(0.01, 100.0));
  verb.add_option("--spectrum", options->spectra,
                  "folder for spectrum.csv and .png: S_a with 5 % damping of each record, RotD50 and RotD100 of pairs");
  verb.add_option("--baseline", options->corrected, "folder for each record with its baseline corrected, as CSV");
  add_choices(verb, options);
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([options, &console] { look_at_motions(*options, console); });
}

} // namespace

const Verb motion_verb{
    {.name = "motion",
     .help = "what is in ground-motion records, or in a folder of them",
     .examples = "rimpact motion record.AT2\nrimpact motion x.AT2 y.AT2 --json\nrimpact motion my-records",
     .next = "rimpact reduced SCENE --set excitation.kind=record --set excitation.x=FILE"},
    add_motion};

} // namespace rimpact::app
