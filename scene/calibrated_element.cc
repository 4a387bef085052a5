#include "scene/calibrated_element.h"

#include "io/files/file.h"
#include "io/files/key_list.h"
#include "scene/keys.h"
#include "scene/scene_keys.h"
#include "scene/stored_calibration.h"
#include <filesystem>
#include <fmt/format.h>
#include <mutex>

namespace rimpact::scene {
namespace {

namespace fs = std::filesystem;

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

void take_answer(const StoredAnswer &answer, CalibratedElement &element) {
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
    for (const auto &entry : keys_of_plates(*answer.plates)) element.values[entry.key.name] = entry.value;
}

/// [reduced] of calibration.toml, the element's keys alone.
void read_fragment(const TomlFile &fragment, CalibratedElement &element) {
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
void check(const CalibratedElement &element) {
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

CalibratedElement read_element(const std::string &folder) {
  const StoredCalibration stored = read_calibration(folder);
  CalibratedElement element{.origin = stored.file, .values = {}, .rim = {}, .capacity = {}, .stack = {}};
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

} // namespace

void CalibratedElement::fail(const std::string &what) const {
  throw DataError(fmt::format("{}: its element cannot be read: {}", origin, what));
}

void CalibratedElement::number(const std::string &key, std::optional<double> value) {
  if (value) values[key] = fmt::format("{}", *value);
}

void CalibratedElement::text(const std::string &key, const std::string &value) {
  if (!value.empty()) values[key] = toml_quoted(value);
}

/// Keys of [reduced], those that are known or every one of them.
std::vector<KeyEntry> keys_of_plates(FittedPlates plates, bool every) {
  KeyList list("", every);
  visit(list, plates);
  return list.entries;
}

const std::vector<std::string> &element_keys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> list{"impact_law", "reference_speed_m_per_s"};
    for (const auto &[name, number] : element_numbers()) list.emplace_back(number.key);
    for (const char *key : {"fitted_from_m_per_s", "fitted_to_m_per_s", "fitted_mass_kg", "fitted_speeds_mass_kg",
                            "fitted_rim", "foot_joint", "foot_force_kN", "taken_from"})
      list.emplace_back(key);
    for (const auto &entry : keys_of_plates({}, true)) list.emplace_back(entry.key.name);
    return list;
  }();
  return keys;
}

/// A fleet reads the same folders for each of its runs: those read last are kept while their files are unchanged.
CalibratedElement calibrated_element(const std::string &folder) {
  struct Read {
    fs::file_time_type when;
    CalibratedElement element;
  };
  constexpr std::size_t most = 16;
  static std::mutex lock;
  static std::map<std::string, Read> known;
  const std::lock_guard guard(lock);
  std::error_code none;
  const auto now = fs::last_write_time(fs::path(folder) / "calibration.json", none);
  if (const auto found = known.find(folder); found != known.end() && !none && found->second.when == now)
    return found->second.element;
  if (known.size() > most) known.clear();
  known.erase(folder);
  return known.emplace(folder, Read{now, read_element(folder)}).first->second.element;
}

} // namespace rimpact::scene
