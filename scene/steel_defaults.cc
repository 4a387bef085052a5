#include "scene/steel_defaults.h"

#include "io/files/toml_reader.h"
#include "scene/assumptions.h"
#include "scene/bearing_keys.h"
#include "scene/flow_curve.h"
#include "scene/steel_grades.h"
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

/// "steel", "rim", ...
std::string name_of(const SteelTable &of) {
  const std::string_view table = of.table;
  const auto start = table.find('.') + 1;
  return std::string(table.substr(start, table.size() - 1 - start));
}

/// Marks a number of the steel that the file leaves out: an assumption, or not.
void mark(const SteelTable &of, AssumedKeys &marks, const std::string &key, bool assumed) {
  if (assumed)
    marks.keys.insert(of.table + key);
  else
    marks.keys.erase(of.table + key);
}

/// What a grade gives and the file does not.
void resolve_grade(const TomlFile &file, const std::string &prefix, const SteelTable &of, AssumedKeys &marks) {
  Material &steel = of.steel;
  const std::string table = prefix + of.table;
  const auto given = [&](const std::string &key) { return file.find(table + key) != nullptr; };
  if (!given("grade") || !steel.has_grade()) return;
  const SteelGrade &grade = steel_grade(steel.grade);
  Material named = steel;
  try {
    named = steel_of(grade, of.thickness, given("yield_MPa") || given("hardness_HB") ? steel.yield : std::nullopt);
  } catch (const InputError &error) {
    throw InputError(
        fmt::format("{}: {}grade \"{}\": {}", file.location(table + "grade"), table, grade.name, error.what()));
  }
  const auto take = [&](const char *key, auto &target, const auto &value) {
    if (!given(key)) target = value;
  };
  take("E_MPa", steel.E, named.E), take("nu", steel.nu, named.nu);
  take("density_kg_per_m3", steel.density, named.density), take("yield_MPa", steel.yield, named.yield);
  take("strain_limit", steel.strain_limit, named.strain_limit);
  take("rate_D_per_s", steel.rate.D, named.rate.D), take("rate_q", steel.rate.q, named.rate.q);
  take("fracture_D1", steel.fracture.D1, named.fracture.D1), take("fracture_D2", steel.fracture.D2, named.fracture.D2);
  take("fracture_D3", steel.fracture.D3, named.fracture.D3);
  for (const auto &[key, number] : grade.numbers)
    if (const bool estimated = key == "yield_MPa" && given("hardness_HB");
        !given(key) && !is_of_the_curve(key) && !estimated)
      mark(of, marks, key, !number.checked);
  if (given("hardening") || given("curve") || given("tangent_modulus_MPa")) return;
  steel.hardening.law = named.hardening.law;
  take("hardening_Q_MPa", steel.hardening.Q, named.hardening.Q),
      take("hardening_b", steel.hardening.b, named.hardening.b);
  for (const char *key : {"hardening_Q_MPa", "hardening_b"})
    if (!given(key)) mark(of, marks, key, true); // of an estimated curve
}

/// The yield stress estimated from a hardness, where it is not given.
void resolve_hardness(const TomlFile &file, const std::string &prefix, const SteelTable &of, AssumedKeys &marks) {
  Material &steel = of.steel;
  const std::string key = prefix + of.table + "hardness_HB", yield = prefix + of.table + "yield_MPa";
  if (!file.find(key)) return;
  const double estimate = yield_of_hardness(steel.hardness_HB);
  constexpr double rounding = 1e-3;
  if (file.find(yield) && (!steel.yield || std::abs(*steel.yield / estimate - 1) > rounding))
    throw InputError(fmt::format("{}: {} {:g} stands beside yield_MPa, which it would estimate at {:.0f}; give one",
                                 file.location(key), key, steel.hardness_HB, estimate / 1e6));
  if (file.find(yield)) return;
  steel.yield = estimate;
  mark(of, marks, "yield_MPa", true);
}

/// The law of hardening, and the yield stress where its curve has one of its own. A curve alone chooses `table`.
void resolve_hardening(const TomlFile &file, const std::string &prefix, const SteelTable &of, AssumedKeys &marks) {
  Material &steel = of.steel;
  const std::string key = prefix + of.table, curve = key + "curve", yield = key + "yield_MPa";
  if (file.find(curve) && !file.find(key + "hardening")) steel.hardening.law = HardeningLaw::table;
  if (!steel.yield) return;
  std::optional<double> own;
  try {
    check_hardening(name_of(of), steel);
    own = yield_of_curve(steel);
  } catch (const InputError &error) {
    throw InputError(fmt::format("{}: {}", file.location(file.find(curve) ? curve : key + "hardening"), error.what()));
  }
  if (!own) return;
  if (file.find(key + "hardness_HB"))
    throw InputError(fmt::format("{}: {}hardness_HB stands beside a curve, which has a yield stress of its own, "
                                 "{:g} MPa; give one",
                                 file.location(key + "hardness_HB"), key, *own / 1e6));
  constexpr double rounding = 1e-3;
  if (!file.find(yield))
    mark(of, marks, "yield_MPa", is_marked(file, curve));
  else if (std::abs(*steel.yield / *own - 1) > rounding)
    throw InputError(fmt::format("{}: {} {:g} is not the {:g} MPa that the curve of hardening \"{}\" begins at; leave "
                                 "it out",
                                 file.location(yield), yield, *steel.yield / 1e6, *own / 1e6,
                                 word(steel.hardening.law)));
  steel.yield = own;
}

/// A part's steel is as the bearing's, and so is what of it is an assumption, but for the keys that the file gives.
void inherit_marks(const TomlFile &file, const std::string &prefix, const std::string &table, AssumedKeys &marks) {
  const std::string of_all = "material.steel.";
  std::set<std::string> keys;
  for (const std::string &key : marks.keys) {
    if (!key.starts_with(table) || file.find(prefix + key)) keys.insert(key);
    if (!key.starts_with(of_all)) continue;
    if (const std::string own = table + key.substr(of_all.size()); !file.find(prefix + own)) keys.insert(own);
  }
  marks.keys = keys;
}

} // namespace

double thickness_of(const Bearing &b, SteelPart part) {
  switch (part) {
  case SteelPart::rim:
    return b.rim.thickness;
  case SteelPart::dish:
    return b.plate.base;
  case SteelPart::slider:
    break;
  }
  return b.double_concave() ? b.slider.height : b.slider.top - b.slider.bottom;
}

void read_flow_curve(const TomlFile &file, const std::string &table, Hardening &hardening, const std::string &folder) {
  const std::string name = hardening.curve.file, key = table + "curve";
  if (name.empty()) return;
  try {
    hardening.curve.values =
        read_curve((std::filesystem::path(folder) / name).lexically_normal().string(), hardening.curve_kind);
  } catch (const DataError &error) {
    throw DataError(fmt::format("{}: {} {}", file.location(key), key, error.what()));
  }
  hardening.curve.file.clear();
}

void resolve_slope(const TomlFile &file, const std::string &table, Material &m) {
  const std::string key = table + "tangent_modulus_MPa";
  if (!m.yield || m.hardening.law != HardeningLaw::bilinear)
    m.tangent_modulus.reset();
  else if (!m.tangent_modulus && file.find(key))
    throw InputError(fmt::format("{}: {} inf must be below E_MPa {:g}", file.location(key), key, m.E / 1e6));
  else if (!m.tangent_modulus)
    m.tangent_modulus = 0.0;
}

void resolve_steel(const TomlFile &file, const std::string &prefix, const SteelTable &of, AssumedKeys &assumed) {
  resolve_hardness(file, prefix, of, assumed);
  resolve_grade(file, prefix, of, assumed);
  resolve_hardening(file, prefix, of, assumed);
  resolve_slope(file, prefix + of.table, of.steel);
}

void read_part_steels(const TomlFile &file, const std::string &prefix, const std::string &folder, Bearing &b) {
  for (const SteelPart part : {SteelPart::rim, SteelPart::dish, SteelPart::slider}) {
    const std::string section = "material." + word(part), table = section + ".";
    if (!file.find(prefix + section)) continue;
    const auto [entry, is_new] = b.part_steels.try_emplace(part, b.steel);
    Material &steel = entry->second;
    if (is_new) {
      steel.grade = no_grade, steel.hardness_HB = 0;
      inherit_marks(file, prefix, table, b.assumed);
    }
    if (file.find(prefix + table + "grade")) steel.hardening = {}, steel.fracture = {};
    TomlReader reader(file, prefix + section);
    visit_steel(reader, steel);
    read_flow_curve(file, prefix + table, steel.hardening, folder);
    resolve_steel(file, prefix, {steel, table, thickness_of(b, part)}, b.assumed);
  }
}

} // namespace rimpact::scene
