#include "scene/adopted_calibration.h"

#include "laws/impact/rims_in_series.h"
#include "scene/calibrated_element.h"
#include "scene/rim_identity.h"
#include "scene/scene_keys.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::scene {
namespace {

namespace fs = std::filesystem;

/// The element begins where the fitted one did, if the rim is the same.
void place(CalibratedElement &element, const Bearing &bearing) {
  constexpr double rounding = 1e-9; // [m]
  if (element.values.count("capacity_offset_mm") > 0 || !element.capacity || element.rim != rim_identity(bearing))
    return;
  const double offset = *element.capacity - bearing.lateral_capacity();
  if (std::abs(offset) > rounding) element.values["capacity_offset_mm"] = fmt::format("{}", 1e3 * offset);
}

std::string model_of(const TomlFile &file) {
  const auto *node = file.find("reduced.model");
  return node && node->is_string() ? node->as_string()->get() : word(ModelKind::physical);
}

/// The rigid-body models have each rim by itself, and two plates of [isolator] around it.
void take_one_rim(const TomlFile &file, CalibratedElement &element) {
  const std::string model = model_of(file);
  const bool rigid_bodies = model != word(ModelKind::physical);
  if (!rigid_bodies || model == word(ModelKind::tfp)) // whose rims are those of two of its faces
    for (const auto &entry : keys_of_plates({}, true)) element.values.erase(entry.key.name);
  if (element.rims == 1 || !rigid_bodies) return;
  TomlFile values("", element.origin);
  for (const auto &[key, value] : element.values) values.set("reduced." + key + "=" + value, element.origin);
  Scene scene;
  TomlReader reader(values, "");
  visit_settings(reader, scene);
  const auto one = laws::one_in_series(*scene.reduced.impact_law, scene.reduced, element.rims);
  if (!one)
    throw InputError(fmt::format("{}: its law {} is that of two rims in series, and of one alone it is no law of that "
                                 "form: reduced.model {} needs law elastoplastic, or one of a spring and a dashpot",
                                 element.origin, scene.reduced.impact_law->name, model));
  element.values["k_i_kN_per_m"] = fmt::format("{}", one->k_i / 1e3);
  element.values.erase("capacity_offset_mm");
  element.values.erase("fitted_rim"); // [isolator] has other keys for its plates
}

/// A calibration that a file asks for: where, and the folder it names.
struct Asked {
  bool typed;        ///< with --set
  std::string place; ///< of the key in its file
  std::string path;  ///< absolute
};

/// None where the section names no calibration; the reader says what is wrong with one that is no text.
std::optional<Asked> asked_calibration(const TomlFile &file, const std::string &section, const std::string &folder) {
  const std::string asked = section + ".calibration";
  const auto *node = file.find(asked);
  if (!node || !node->is_string() || node->as_string()->get().empty()) return {};
  std::error_code ignored;
  return Asked{file.is_set(asked), file.location(asked),
               fs::absolute(fs::path(folder) / node->as_string()->get(), ignored).lexically_normal().string()};
}

/// Puts the element's values in the place of the section's keys.
void put(TomlFile &file, const std::string &section, const std::vector<std::string> &keys,
         const CalibratedElement &element, const Asked &asked, std::vector<std::string> &remarks) {
  std::vector<std::string> replaced;
  for (const auto &key : keys) {
    const std::string full = section + "." + key;
    if (!file.find(full) || file.is_set(full)) continue;
    if (!asked.typed)
      throw InputError(fmt::format("{}: {} stands beside {}.calibration of {}, which gives it: strike one of the two",
                                   file.location(full), full, section, asked.place));
    if (key != "taken_from") replaced.push_back(full);
  }
  if (!replaced.empty())
    remarks.push_back(fmt::format("law and numbers of {} take the place of the scene's own {}", element.origin,
                                  fmt::join(replaced, ", ")));
  for (const auto &key : keys) {
    if (file.is_set(section + "." + key)) continue;
    if (const auto value = element.values.find(key); value != element.values.end())
      file.set(section + "." + key + "=" + value->second, element.origin);
    else
      file.erase(section + "." + key); // a file's key that the calibration has not
  }
}

/// Of element_keys(), those that the inner rims of a triple pendulum have too.
const std::vector<std::string> &inner_rim_keys() {
  static const std::vector<std::string> keys = [] {
    KeyList list("", true);
    ImpactElement element;
    visit(list, element);
    std::vector<std::string> known = element_keys();
    std::erase_if(known, [&](const std::string &key) {
      return std::none_of(list.entries.begin(), list.entries.end(),
                          [&](const KeyEntry &entry) { return entry.key.name == key; });
    });
    return known;
  }();
  return keys;
}

/// None where it is not given; the reader says what is wrong with one that is neither true nor false.
std::optional<bool> own_rims_in(const TomlFile &file) {
  const auto *given = file.find(own_rims_key);
  return given && given->is_boolean() ? std::optional(given->as_boolean()->get()) : std::nullopt;
}

} // namespace

std::vector<std::string> typed_element_keys(const TomlFile &file, const std::string &section) {
  std::vector<std::string> typed;
  for (const auto &key : element_keys())
    if (const std::string full = section + "." + key; !key.starts_with("fitted_") && !key.starts_with("foot_") &&
                                                      key != "taken_from" && file.is_set(full) && file.find(full))
      typed.push_back(full);
  return typed;
}

TakenTerms adopt_calibration(TomlFile &file, const std::string &folder, const Bearing &bearing,
                             std::vector<std::string> &remarks) {
  const auto asked = asked_calibration(file, reduced_section, folder);
  if (!asked) return {};
  CalibratedElement element = calibrated_element(asked->path);
  place(element, bearing);
  take_one_rim(file, element);
  element.values["taken_from"] = toml_quoted(asked->path);
  put(file, reduced_section, element_keys(), element, *asked, remarks);
  return adopt_stack_terms(file, element.stack, asked->typed, remarks);
}

void adopt_inner_calibration(TomlFile &file, const std::string &folder, std::vector<std::string> &remarks) {
  const auto asked = asked_calibration(file, inner_rims_section, folder);
  if (!asked) return;
  if (model_of(file) != word(ModelKind::tfp))
    throw InputError(fmt::format("{}: {}.calibration is for reduced.model \"{}\", not \"{}\"", asked->place,
                                 inner_rims_section, word(ModelKind::tfp), model_of(file)));
  CalibratedElement element = calibrated_element(asked->path);
  if (element.rims == 1)
    remarks.push_back(fmt::format("the element of the inner rims was fitted to another rim, that of a bearing of one "
                                  "dish ({})",
                                  element.origin));
  take_one_rim(file, element);
  element.values["taken_from"] = toml_quoted(asked->path);
  put(file, inner_rims_section, inner_rim_keys(), element, *asked, remarks);
  if (file.is_set(own_rims_key)) return;
  if (own_rims_in(file) == false && !asked->typed)
    throw InputError(fmt::format("{}: {} = false stands beside {}.calibration of {}: strike one of the two",
                                 file.location(own_rims_key), own_rims_key, inner_rims_section, asked->place));
  file.set(own_rims_key + "=true", element.origin);
}

void require_inner_element(const TomlFile &file) {
  const std::string needed = inner_rims_section + ".k_i_kN_per_m";
  if (own_rims_in(file) != true || file.find(needed)) return;
  throw InputError(fmt::format("{}: {} needs {}, and what else the law of these rims reads (rimpact list laws), or {}."
                               "calibration",
                               file.location(own_rims_key), own_rims_key, needed, inner_rims_section));
}

bool is_changed_by_hand(const std::vector<std::string> &typed, const ImpactElement &element,
                        std::vector<std::string> &remarks) {
  if (typed.empty() || element.calibration.empty()) return false;
  remarks.push_back(fmt::format("{} is given beside the calibration {} and wins: the element is no longer the "
                                "calibrated one, and the speeds, mass and "
                                "rim it holds for are not known",
                                fmt::join(typed, ", "), element.calibration));
  return true;
}

} // namespace rimpact::scene
