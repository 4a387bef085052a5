#include "app/jobs/motion_choice.h"
#include "app/console/child_process.h"
#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/json_text.h"
#include "io/records/fault_rotation.h"
#include "io/records/record_library.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rimpact::app {
namespace {

std::string spectra_csv(const RecordSelection &selection) {
  std::string text = "period_s,target_g,mean_g";
  for (std::size_t k = 0; k < selection.recordings.size(); ++k) text += fmt::format(",record_{}_g", k + 1);
  text += "\n";
  for (std::size_t i = 0; i < selection.periods.size(); ++i) {
    text += fmt::format("{:.6g},{:.6g},{:.6g}", selection.periods[i], selection.target[i], selection.mean[i]);
    for (const auto &recording : selection.recordings) text += fmt::format(",{:.6g}", recording.spectrum[i]);
    text += "\n";
  }
  return text;
}

std::string json_word(const std::string &text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string full_path(const std::string &path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

/// A sweep file of the selection: one case a recording, scaled.
std::string sweep_toml(const RecordSelection &selection, const TargetSpectrum &target) {
  std::string text =
      fmt::format("# {} recordings selected and scaled to {}\n", selection.recordings.size(), target.words());
  for (const auto &r : selection.recordings) {
    text += fmt::format("[[case]]\nname = {}\nexcitation.kind = \"record\"\nexcitation.x = {}\nexcitation.y = {}\n"
                        "excitation.scale = {:.6g}\n",
                        json_word(r.station), json_word(full_path(r.x)),
                        r.y.empty() ? "\"\"" : json_word(full_path(r.y)), r.factor);
  }
  return text;
}

std::string selection_csv(const RecordSelection &selection) {
  std::string text = "station,factor,misfit,x,y\n";
  for (const auto &r : selection.recordings)
    text += fmt::format("{},{:.6g},{:.4f},{},{}\n", json_word(r.station), r.factor, r.misfit, json_word(r.x),
                        json_word(r.y));
  return text;
}

/// The largest and the smallest of mean over target.
std::pair<double, double> range_of_ratio(const RecordSelection &selection) {
  double least = selection.mean[0] / selection.target[0], most = least;
  for (std::size_t i = 0; i < selection.mean.size(); ++i) {
    const double ratio = selection.mean[i] / selection.target[i];
    least = std::min(least, ratio), most = std::max(most, ratio);
  }
  return {least, most};
}

nlohmann::ordered_json selection_json(const RecordSelection &selection, const TargetSpectrum &target,
                                      const std::string &folder) {
  auto recordings = nlohmann::ordered_json::array();
  for (const auto &r : selection.recordings)
    recordings.push_back({{"station", r.station}, {"x", r.x}, {"y", r.y}, {"factor", r.factor}, {"misfit", r.misfit}});
  const auto [least, most] = range_of_ratio(selection);
  return {{"target", target.words()},
          {"spectrum", target.is_largest_direction() ? "largest direction" : "geometric mean"},
          {"from_s", selection.periods.front()},
          {"to_s", selection.periods.back()},
          {"candidates", selection.n_candidates},
          {"common_factor", selection.common},
          {"least_mean_over_target", least},
          {"largest_mean_over_target", most},
          {"recordings", recordings},
          {"sweep", folder + "/sweep.toml"},
          {"doubts", selection.doubts}};
}

std::string selection_in_words(const RecordSelection &selection, const TargetSpectrum &target,
                               const std::string &folder) {
  std::string text =
      fmt::format("{}; {:.3g} to {:.3g} s, {} of {} candidates\n", target.words(), selection.periods.front(),
                  selection.periods.back(), selection.recordings.size(), selection.n_candidates);
  std::size_t width = 7;
  for (const auto &r : selection.recordings) width = std::max(width, r.station.size());
  text += fmt::format("{:<{}}  {:>8} {:>8}\n", "station", width, "factor", "misfit");
  for (const auto &r : selection.recordings)
    text += fmt::format("{:<{}}  {:>8.3f} {:>8.3f}\n", r.station, width, r.factor, r.misfit);
  const auto [least, most] = range_of_ratio(selection);
  return text + fmt::format("mean over target {:.3f} to {:.3f} (common factor {:.3f} in every factor)\n{}/sweep.toml, "
                            "spectrum.csv, selection.csv\n",
                            least, most, selection.common, folder);
}

} // namespace

std::string acceleration_csv(const SampledSignal &record) {
  std::string text = "time_s,acceleration_m_per_s2\n";
  for (std::size_t i = 0; i < record.values.size(); ++i)
    text += fmt::format("{:.9g},{:.9g}\n", record.instant(i), record.values[i]);
  return text;
}

void select_motions(const RecordFolder &folder, const SelectionOptions &options, Console &console) {
  const TargetSpectrum target(options.target);
  const RecordSelection selection = select_records(folder, target, options.rules);
  for (const auto &doubt : selection.doubts) console.warn(doubt);
  make_folder(options.folder);
  write_atomically(spectra_csv(selection), options.folder + "/spectrum.csv");
  write_atomically(selection_csv(selection), options.folder + "/selection.csv");
  write_atomically(sweep_toml(selection, target), options.folder + "/sweep.toml");
  if (python({"report.selection", options.folder + "/spectrum.csv", options.folder + "/spectrum.png"}) != 0)
    console.warn("the picture " + options.folder + "/spectrum.png was not made");
  console.data(console.json ? json_text(selection_json(selection, target, options.folder))
                            : selection_in_words(selection, target, options.folder));
}

void rotate_motions(const RecordFolder &folder, double strike, const std::string &out, Console &console) {
  make_folder(out);
  std::size_t n = 0;
  for (const auto &station : folder.stations) {
    if (!station.is_pair()) continue;
    const auto &first = folder.records[station.horizontal[0]], &second = folder.records[station.horizontal[1]];
    try {
      const auto turned = fault_components(*shared_record(first.path), first.direction, *shared_record(second.path),
                                           second.direction, strike);
      std::string label = station.name;
      std::replace_if(
          label.begin(), label.end(), [](char c) { return c == '/' || c == '\\' || c == ' ' || c == ','; }, '_');
      for (const auto &[ending, signal] : {std::pair("-FN", &turned.normal), std::pair("-FP", &turned.parallel)}) {
        write_atomically(acceleration_csv(*signal), fmt::format("{}/{}{}.csv", out, label, ending));
      }
      ++n;
    } catch (const DataError &error) {
      console.warn(fmt::format("{}: not turned: {}", station.name, error.what()));
    }
  }
  console.message(fmt::format("{}: {} pairs turned to fault-normal (FN) and fault-parallel (FP), strike {:g} degrees",
                              out, n, strike));
}

} // namespace rimpact::app
