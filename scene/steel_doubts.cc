#include "scene/steel_doubts.h"

#include "scene/steel_defaults.h"
#include "scene/steel_grades.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::scene {
namespace {

bool differ(double own, double of_grade) {
  constexpr double rounding = 1e-3;
  return std::abs(own - of_grade) > rounding * std::abs(of_grade);
}

/// The numbers by which most steels differ, and the curve. A curve of one's own, or a hardness, brings its yield
/// stress.
std::vector<std::string> own_numbers(const Material &steel, const Material &named) {
  constexpr double MPa = 1e6;
  std::vector<std::string> own;
  const auto compare = [&](const char *key, double value, double of_grade) {
    if (differ(value, of_grade)) own.push_back(fmt::format("{} {:.4g} (the grade's: {:.4g})", key, value, of_grade));
  };
  compare("E_MPa", steel.E / MPa, named.E / MPa), compare("nu", steel.nu, named.nu);
  compare("density_kg_per_m3", steel.density, named.density);
  const bool settled =
      steel.hardness_HB > 0 || steel.hardening.law == HardeningLaw::table || steel.hardening.law == HardeningLaw::swift;
  if (!settled && steel.yield) compare("yield_MPa", *steel.yield / MPa, *named.yield / MPa);
  if (steel.hardening.law == HardeningLaw::bilinear) own.emplace_back("two straight lines (the grade's: Voce's curve)");
  return own;
}

/// `table`: of the steel, in bearing.material; `part`: whose thickness [m] its numbers go by.
void add_doubts(const std::string &table, const Material &steel, const std::string &part, double thickness,
                std::vector<std::string> &found) {
  if (!steel.has_grade() || !steel.yield) return;
  const SteelGrade &grade = steel_grade(steel.grade);
  if (const auto own = own_numbers(steel, steel_of(grade, thickness)); !own.empty())
    found.push_back(
        fmt::format("bearing.material.{} of grade {}: the file's own numbers stand in the grade's place: {}. "
                    "Left out, they are the grade's",
                    table, grade.name, fmt::join(own, ", ")));
  double most = HUGE_VAL;
  for (const auto &[key, number] : grade.numbers)
    if (!number.by_thickness.empty()) most = std::min(most, number.by_thickness.back()[0]);
  if (thickness > most)
    found.push_back(fmt::format("{} is {:g} mm thick, beyond the {:g} mm that the tables of grade {} go to "
                                "(bearing.material.{}): the last values are taken",
                                part, 1e3 * thickness, 1e3 * most, grade.name, table));
}

} // namespace

std::vector<std::string> doubts_of_grade(const Bearing &bearing) {
  std::vector<std::string> found;
  add_doubts("steel", bearing.steel, "the rim", bearing.rim.thickness, found);
  for (const auto &[part, steel] : bearing.part_steels)
    add_doubts(word(part), steel, description(part), thickness_of(bearing, part), found);
  return found;
}

} // namespace rimpact::scene
