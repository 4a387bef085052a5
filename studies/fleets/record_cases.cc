// Cases of a sweep from a folder of records.
#include "studies/fleets/record_cases.h"

#include "io/files/error.h"
#include "io/records/record_file.h"
#include "io/records/record_folder.h"
#include "io/records/record_library.h"
#include "io/records/rotated_spectrum.h"
#include "studies/fleets/record_intensity.h"
#include "studies/fleets/sweep_toml.h"
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace rimpact::fleets {
namespace {

Value text_value(const std::string &text) {
  return {nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), text};
}

/// All three components are set, so that none of the scene's own remains.
std::vector<Axis> case_of(const std::string &name, const std::vector<std::string> &horizontal,
                          const std::string &vertical, double sa_period) {
  const auto file = [](const std::string &path) {
    return text_value(path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string());
  };
  const auto [pga_g, pgv, sa_g] = intensity(horizontal, sa_period);
  std::vector<Axis> axes{{"record", {text_value(name)}},
                         {"excitation.kind", {text_value("record")}},
                         {"excitation.x", {file(horizontal.front())}},
                         {"excitation.y", {file(horizontal.size() > 1 ? horizontal[1] : "")}},
                         {"excitation.z", {file(vertical)}},
                         {"variable.record_pga_g", {number_value(pga_g)}},
                         {"variable.record_pgv_m_per_s", {number_value(pgv)}}};
  if (sa_period > 0) axes.push_back({"variable.record_sa_g", {number_value(sa_g)}});
  if (sa_period > 0 && horizontal.size() > 1) {
    const auto [rotd50, rotd100] =
        rotated_acceleration(*shared_record(horizontal[0]), *shared_record(horizontal[1]), sa_period);
    axes.push_back({"variable.record_rotd50_g", {number_value(rotd50 / standard_gravity)}});
    axes.push_back({"variable.record_rotd100_g", {number_value(rotd100 / standard_gravity)}});
  }
  return axes;
}

/// "it has HILL000.AT2 (000), HILL-UP.AT2 (UP)".
std::string what_it_has(const RecordFolder &folder, const Station &station) {
  std::vector<std::string> has;
  for (const auto *part : {&station.horizontal, &station.vertical})
    for (const std::size_t i : *part)
      has.push_back(fmt::format("{} ({})", folder.records[i].file, folder.records[i].direction.spelling));
  return fmt::format("it has {}", fmt::join(has, ", "));
}

std::vector<std::string> paths(const RecordFolder &folder, const std::vector<std::size_t> &records) {
  std::vector<std::string> result;
  for (const std::size_t i : records) result.push_back(folder.records[i].path);
  return result;
}

} // namespace

RecordCases cases_of_folder(const std::string &folder_name, Components components, double sa_period) {
  const RecordFolder folder = read_record_folder(folder_name);
  folder.require_any();
  RecordCases result;
  if (const std::string question = folder.question(); !question.empty()) result.left_out.push_back(question);
  for (const auto &station : folder.stations) {
    const auto horizontal = paths(folder, station.horizontal), vertical = paths(folder, station.vertical);
    if (components == Components::x) {
      for (const auto &path : horizontal) result.cases.push_back(case_of(record_label(path), {path}, "", sa_period));
      continue;
    }
    const bool with_vertical = components == Components::xyz;
    if (!station.is_pair() || (with_vertical && vertical.size() != 1)) {
      result.left_out.push_back(fmt::format("{}: left out, {} asks for two horizontal components{}; {}", station.name,
                                            word(components), with_vertical ? " and a vertical one" : "",
                                            what_it_has(folder, station)));
      continue;
    }
    result.cases.push_back(case_of(station.name, horizontal, with_vertical ? vertical.front() : "", sa_period));
  }
  if (result.cases.empty())
    throw InputError(fmt::format("the folder {} has no station with the components {}{}{}", folder_name,
                                 word(components), result.left_out.empty() ? "" : ": ",
                                 fmt::join(result.left_out, "; ")));
  return result;
}

} // namespace rimpact::fleets
