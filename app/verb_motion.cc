// rimpact motion FILE...: what is in a record.
#include "app/sibling.h"
#include "app/verb.h"
#include "files/file.h"
#include "files/json_text.h"
#include "records/record_library.h"
#include "responses/response.h"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rimpact::app {
namespace {

/// Where each record's picture goes, without its extension. Throws where two would go to one place.
std::vector<std::string> picture_places(const std::vector<std::string> &files, const std::string &folder) {
  std::vector<std::string> places;
  for (const auto &file : files) {
    places.push_back(folder + "/" + std::filesystem::path(file).stem().string());
    const auto before = std::find(places.begin(), places.end() - 1, places.back());
    if (before != places.end() - 1)
      throw InputError(fmt::format("{} and {} would both be drawn as {}.png; draw them into two folders",
                                   files[before - places.begin()], file, places.back()));
  }
  return places;
}

/// Acceleration, velocity and displacement for the plot; velocity is exact for linear acceleration between
/// samples.
std::string motion_csv(const SampledSignal &record) {
  std::string text = "time_s,acceleration_m_per_s2,velocity_m_per_s,displacement_m\n";
  double v = 0, u = 0;
  for (std::size_t k = 0; k < record.values.size(); ++k) {
    const double a = record.values[k];
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", record.instant(k), a, v, u);
    if (k + 1 == record.values.size()) break;
    const double next = record.values[k + 1];
    u += v * record.dt + record.dt * record.dt * (2 * a + next) / 6;
    v += 0.5 * record.dt * (a + next);
  }
  return text;
}

} // namespace

void add_motion(CLI::App &app, Console &console) {
  struct MotionOptions {
    std::vector<std::string> files;
    std::string picture;
  };
  auto *verb = app.add_subcommand("motion", "what is in a ground-motion record");
  auto options = std::make_shared<MotionOptions>();
  verb->add_option("FILE", options->files, "AT2 or CSV records")->required();
  verb->add_option("--png", options->picture, "folder for a plot of each record");
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([options, &console] {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    const auto places =
        options->picture.empty() ? std::vector<std::string>{} : picture_places(options->files, options->picture);
    for (std::size_t k = 0; k < options->files.size(); ++k) {
      const std::string &file = options->files[k];
      const auto record = read_record(std::filesystem::exists(file) ? file : find_record(file, "."));
      const auto info = inspect(record);
      all.push_back({{"file", file},
                     {"npts", info.npts},
                     {"dt_s", info.dt},
                     {"pga_g", info.pga_g},
                     {"pgv_m_per_s", info.pgv},
                     {"pgd_m", info.pgd},
                     {"arias_m_per_s", info.arias},
                     {"duration_5_95_s", info.duration}});
      if (!console.json)
        console.data(fmt::format("{}: NPTS {}, dt {} s, PGA {:.4f} g, PGV {:.4f} m/s, PGD {:.4f} m, Arias "
                                 "{:.3f} m/s, D5-95 {:.2f} s\n",
                                 file, info.npts, info.dt, info.pga_g, info.pgv, info.pgd, info.arias, info.duration));
      if (options->picture.empty()) continue;
      std::error_code failed;
      std::filesystem::create_directories(options->picture, failed);
      if (failed) throw IoError(fmt::format("cannot create the folder {}: {}", options->picture, failed.message()));
      const std::string &base = places[k];
      write_atomically(motion_csv(record), base + ".csv");
      if (python({"report.motion", base + ".csv", base + ".png"}) != 0)
        throw IoError("the plot " + base + ".png was not made");
    }
    if (console.json) console.data(json_text(all));
  });
}

} // namespace rimpact::app
