// Cases of a sweep from a folder of records.
#include "files/error.h"
#include "fleets/record_folder.h"
#include "fleets/sweep_reader.h"
#include "fleets/sweep_toml.h"
#include <filesystem>
#include <fmt/format.h>
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
  return axes;
}

} // namespace

RecordCases cases_of_folder(const std::string &folder, Components components, double sa_period) {
  RecordCases result;
  for (const auto &motion : ground_motions(folder)) {
    if (components == Components::x) {
      for (const auto &path : motion.horizontal)
        result.cases.push_back(case_of(std::filesystem::path(path).stem().string(), {path}, "", sa_period));
      continue;
    }
    const bool with_vertical = components == Components::xyz;
    if (motion.horizontal.size() != 2 || (with_vertical && motion.vertical.empty())) {
      result.left_out.push_back(fmt::format("{}: left out, it has {} horizontal component(s){}", motion.name,
                                            motion.horizontal.size(),
                                            motion.vertical.empty() ? " and no vertical one" : ""));
      continue;
    }
    result.cases.push_back(case_of(motion.name, motion.horizontal, with_vertical ? motion.vertical : "", sa_period));
  }
  if (result.cases.empty())
    throw InputError(fmt::format("the folder {} has no station with the components {}", folder, word(components)));
  return result;
}

} // namespace rimpact::fleets
