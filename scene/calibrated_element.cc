#include "scene/calibrated_element.h"

#include "io/files/file.h"
#include "io/files/key_list.h"
#include "laws/impact/rims_in_series.h"
#include "scene/keys.h"
#include "scene/rim_identity.h"
#include "scene/scene_keys.h"
#include "scene/stored_calibration.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mutex>

namespace rimpact::scene {
namespace {

namespace fs = std::filesystem;

/// What a calibration says, as values of keys of [reduced].
struct Element {
  std::string origin;                        ///< the file read
  std::map<std::string, std::string> values; ///< key -> TOML value
  std::string rim;                           ///< identity of the rim it was fitted to; empty: not said
  std::optional<double> capacity;            ///< where the element begins [m]
  int rims = 1;                              ///< that it is the law of, in series
  StackTerms stack;

  [[noreturn]] void fail(const std::string &what) const {
    throw DataError(fmt::format("{}: its element cannot be read: {}", origin, what));
  }
  void number(const std::string &key, std::optional<double> value) {
    if (value) values[key] = fmt::format("{}", *value);
  }
  void text(const std::string &key, const std::string &value) {
    if (!value.empty()) values[key] = toml_quoted(value);
  }
};

StackTerms terms_of(const StoredStack &stack) {
  StackTerms terms{.values = {}, .slip_from = stack.slip_from};
  const auto flag = [&](const char *key, std::optional<bool> value) {
    if (value) terms.values[key] = *value ? "true" : "false";
  };
  flag("finite_pad", stack.finite_pad), flag("socket_friction", stack.socket_friction);
  if (stack.normal_force) terms.values["normal_force"] = toml_quoted(word(*stack.normal_force));
  if (stack.friction) terms.values["friction"] = toml_quoted(word(*stack.friction));
  if (stack.elastic_slip) terms.values["elastic_slip_mm"] = fmt::format("{:.9g}", 1e3 * *stack.elastic_slip);
  return terms;
}

/// Keys of [reduced], those that are known or every one of them.
std::vector<KeyEntry> keys_of(FittedPlates plates, bool every = false) {
  KeyList list("", every);
  visit(list, plates);
  return list.entries;
}

void take_answer(const StoredAnswer &answer, Element &element) {
  const StoredLaw &law = answer.law;
  element.text("impact_law", law.name);
  for (const auto &[name, value] : law.element.numbers) element.number(element_numbers().at(name).key, value);
  element.number("reference_speed_m_per_s", law.element.reference_speed);
  element.capacity = law.element.lateral_capacity;
  element.number("fitted_from_m_per_s", law.fitted_from), element.number("fitted_to_m_per_s", law.fitted_to);
  element.number(law.belongs_to == BelongsTo::mass ? "fitted_mass_kg" : "fitted_speeds_mass_kg", answer.mass);
  element.rim = answer.rim_identity;
  element.text("fitted_rim", element.rim);
  if (answer.foot) {
    element.text("foot_joint", answer.foot->joint);
    if (answer.foot->goes_at_force) element.values["foot_force_kN"] = file_number(*answer.foot->goes_at_force, kilo);
  }
  if (answer.stack) element.stack = terms_of(*answer.stack);
  element.rims = answer.rims_in_series;
  if (answer.plates)
    for (const auto &entry : keys_of(*answer.plates)) element.values[entry.key.name] = entry.value;
}

/// [reduced] of calibration.toml, the element's keys alone.
void read_fragment(const TomlFile &fragment, Element &element) {
  for (const auto &key : element_keys()) {
    const auto *node = fragment.find("reduced." + key);
    if (!node || key == "calibration" || key == "taken_from") continue;
    if (const auto *text = node->as_string())
      element.values[key] = toml_quoted(text->get());
    else if (const auto number = node->value<double>())
      element.number(key, number);
    else
      element.fail(key + " is neither a number nor a word");
  }
  if (const auto rim = element.values.find("fitted_rim"); rim != element.values.end())
    element.rim = rim->second.substr(1, rim->second.size() - 2);
}

/// The numbers are judged by the scene's own keys and ranges.
void check(const Element &element) {
  if (element.values.count("impact_law") == 0) element.fail("it names no impact_law");
  TomlFile values("", element.origin);
  Scene scene;
  try {
    for (const auto &[key, value] : element.values) values.set("reduced." + key + "=" + value, element.origin);
    TomlReader reader(values, "");
    visit_settings(reader, scene);
  } catch (const InputError &error) {
    throw DataError(std::string(error.what()) + " (the calibration's element)");
  }
  const laws::ImpactLaw &law = *scene.reduced.impact_law;
  for (const auto &key : law.needs) // else it would run on defaults that no calibration gave
    if (element.values.count(key) == 0) element.fail(fmt::format("law {} without {}", law.name, key));
}

Element read_element(const std::string &folder) {
  const StoredCalibration stored = read_calibration(folder);
  Element element{.origin = stored.file, .values = {}, .rim = {}, .capacity = {}, .stack = {}};
  if (stored.answer) {
    take_answer(*stored.answer, element);
  } else {
    element.origin = (fs::path(folder) / "calibration.toml").string();
    const std::string text = read_file(element.origin);
    try {
      read_fragment(TomlFile(text, element.origin), element);
    } catch (const InputError &error) {
      throw DataError(error.what());
    }
  }
  check(element);
  return element;
}

/// A fleet reads the same folder for each of its runs: the last one read is kept while its file is unchanged.
Element remembered_element(const std::string &folder) {
  static std::mutex lock;
  static std::string last;
  static fs::file_time_type when;
  static Element element;
  const std::lock_guard guard(lock);
  std::error_code none;
  const auto now = fs::last_write_time(fs::path(folder) / "calibration.json", none);
  if (folder != last || now != when || none) {
    last.clear();
    element = read_element(folder);
    last = folder, when = now;
  }
  return element;
}

/// The element begins where the fitted one did, if the rim is the same.
void place(Element &element, const Bearing &bearing) {
  constexpr double rounding = 1e-9; // [m]
  if (element.values.count("capacity_offset_mm") > 0 || !element.capacity || element.rim != rim_identity(bearing))
    return;
  const double offset = *element.capacity - bearing.lateral_capacity();
  if (std::abs(offset) > rounding) element.values["capacity_offset_mm"] = fmt::format("{}", 1e3 * offset);
}

/// The rigid-body models have each rim by itself, and two plates of [isolator] around it.
void take_one_rim(const TomlFile &file, Element &element) {
  const auto *node = file.find("reduced.model");
  const std::string model = node && node->is_string() ? node->as_string()->get() : word(ModelKind::physical);
  const bool rigid_bodies = model != word(ModelKind::physical);
  if (!rigid_bodies || model == word(ModelKind::tfp)) // whose rims are those of two of its faces
    for (const auto &entry : keys_of({}, true)) element.values.erase(entry.key.name);
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

} // namespace

const std::vector<std::string> &element_keys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> list{"impact_law", "reference_speed_m_per_s"};
    for (const auto &[name, number] : element_numbers()) list.emplace_back(number.key);
    for (const char *key : {"fitted_from_m_per_s", "fitted_to_m_per_s", "fitted_mass_kg", "fitted_speeds_mass_kg",
                            "fitted_rim", "foot_joint", "foot_force_kN", "taken_from"})
      list.emplace_back(key);
    for (const auto &entry : keys_of({}, true)) list.emplace_back(entry.key.name);
    return list;
  }();
  return keys;
}

std::vector<std::string> typed_element_keys(const TomlFile &file) {
  std::vector<std::string> typed;
  for (const auto &key : element_keys())
    if (!key.starts_with("fitted_") && !key.starts_with("foot_") && key != "taken_from" &&
        file.is_set("reduced." + key) && file.find("reduced." + key))
      typed.push_back("reduced." + key);
  return typed;
}

TakenTerms adopt_calibration(TomlFile &file, const std::string &folder, const Bearing &bearing,
                             std::vector<std::string> &remarks) {
  const std::string asked = "reduced.calibration";
  const auto *node = file.find(asked);
  if (!node || !node->is_string() || node->as_string()->get().empty())
    return {}; // the reader says what is wrong with it
  const bool typed = file.is_set(asked);
  const std::string place_of_it = file.location(asked);
  std::error_code ignored;
  const std::string path =
      fs::absolute(fs::path(folder) / node->as_string()->get(), ignored).lexically_normal().string();
  Element element = remembered_element(path);
  place(element, bearing);
  take_one_rim(file, element);
  element.values["taken_from"] = toml_quoted(path);
  std::vector<std::string> replaced;
  for (const auto &key : element_keys()) {
    const std::string full = "reduced." + key;
    if (!file.find(full) || file.is_set(full)) continue;
    if (!typed)
      throw InputError(fmt::format("{}: {} stands beside {} of {}, which gives it: strike one of the two",
                                   file.location(full), full, asked, place_of_it));
    if (key != "taken_from") replaced.push_back(full);
  }
  if (!replaced.empty())
    remarks.push_back(fmt::format("law and numbers of {} take the place of the scene's own {}", element.origin,
                                  fmt::join(replaced, ", ")));
  for (const auto &key : element_keys()) {
    if (file.is_set("reduced." + key)) continue;
    if (const auto value = element.values.find(key); value != element.values.end())
      file.set("reduced." + key + "=" + value->second, element.origin);
    else
      file.erase("reduced." + key); // a file's key that the calibration has not
  }
  return adopt_stack_terms(file, element.stack, typed, remarks);
}

void forget_origin(const std::vector<std::string> &typed, ReducedSettings &reduced, std::vector<std::string> &remarks) {
  if (typed.empty() || reduced.calibration.empty()) return;
  remarks.push_back(fmt::format("{} is given beside the calibration {} and wins: the element is no longer the "
                                "calibrated one, and the speeds, mass and "
                                "rim it holds for are not known",
                                fmt::join(typed, ", "), reduced.calibration));
  reduced.forget_fit();
}

} // namespace rimpact::scene
