#include "app/jobs/motion_spectrum.h"
#include "app/console/child_process.h"
#include "io/files/file.h"
#include "io/files/table.h"
#include "io/files/table_csv.h"
#include "io/records/record_library.h"
#include "io/records/spectral_acceleration.h"
#include "io/records/target_spectrum.h"
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace rimpact::app {
namespace {

std::vector<double> spectrum_periods() {
  constexpr int n = 61;
  constexpr double shortest = 0.05, longest = 10; // [s]
  std::vector<double> periods;
  for (int i = 0; i < n; ++i) periods.push_back(shortest * std::pow(longest / shortest, i / (n - 1.0)));
  return periods;
}

/// The other component of a row's pair, further down; none: it has none or it was met already.
const MotionRow *partner_below(const std::vector<MotionRow> &rows, std::size_t i) {
  for (std::size_t k = i + 1; k < rows.size(); ++k)
    if (!rows[i].pair.empty() && rows[k].record.file == rows[i].pair &&
        rows[k].record.station == rows[i].record.station)
      return &rows[k];
  return nullptr;
}

} // namespace

void write_spectra(const std::vector<MotionRow> &rows, const std::string &target, const std::string &folder,
                   Console &console) {
  std::optional<TargetSpectrum> wanted;
  if (!target.empty()) wanted.emplace(target);
  const auto periods = spectrum_periods();
  Table table{{"station", "file", "direction", "period_s", "sa_g", "rotd50_g", "rotd100_g", "target_g"}, {}, {}};
  std::map<const MotionRow *, std::vector<RotatedAcceleration>> rotated; // of the second components, by the first ones
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const MotionRow &row = rows[i];
    if (!row.info) continue;
    const auto signal = shared_record(row.record.path);
    if (const auto *other = partner_below(rows, i); other && other->info) {
      const auto second = shared_record(other->record.path);
      for (const double period : periods) rotated[&row].push_back(rotated_acceleration(*signal, *second, period));
      rotated[other] = rotated[&row];
    }
    const auto pair = rotated.find(&row);
    const auto in_g = [&](std::size_t k, double RotatedAcceleration::*member) {
      return pair == rotated.end() ? Cell() : Cell(pair->second[k].*member / standard_gravity);
    };
    for (std::size_t k = 0; k < periods.size(); ++k)
      table.rows.push_back({row.record.station, row.record.file, row.record.direction.spelling, periods[k],
                            spectral_acceleration(*signal, periods[k]) / standard_gravity,
                            in_g(k, &RotatedAcceleration::rotd50), in_g(k, &RotatedAcceleration::rotd100),
                            wanted ? Cell(wanted->at(periods[k])) : Cell()});
  }
  make_folder(folder);
  write_csv(table, folder + "/spectrum.csv");
  if (python({"report.spectrum", folder + "/spectrum.csv", folder + "/spectrum.png"}) != 0)
    console.warn("the picture " + folder + "/spectrum.png was not made");
  console.message(fmt::format("{0}/spectrum.csv and .png: {1} spectra with 5 % damping", folder,
                              table.rows.size() / periods.size()));
}

} // namespace rimpact::app
