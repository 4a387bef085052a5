#include "scene/steel_grades.h"

#include "io/files/error.h"
#include "io/files/text.h"
#include "io/files/toml_file.h"
#include "scene/steel_data.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::scene {
namespace {

GradeNumber number_from(const toml::table &table) {
  GradeNumber number;
  if (const auto *rows = table["value"].as_array())
    for (const auto &row : *rows)
      number.by_thickness.push_back(
          {row.as_array()->at(0).value<double>().value() / 1e3, row.as_array()->at(1).value<double>().value()});
  else
    number.value = table["value"].value<double>().value();
  number.source = table["source"].value<std::string>().value();
  number.scatter = table["scatter"].value<std::string>().value();
  number.checked = table["checked"].value<bool>().value();
  return number;
}

std::vector<SteelGrade> read_grades() {
  std::vector<SteelGrade> grades;
  const TomlFile file(steel_data, "steels.toml");
  for (const auto &[name, node] : file.root()) {
    SteelGrade grade{.name = std::string(name.str()), .title = {}, .numbers = {}};
    for (const auto &[key, entry] : *node.as_table())
      if (entry.is_string())
        grade.title = entry.as_string()->get();
      else
        grade.numbers[std::string(key.str())] = number_from(*entry.as_table());
    grades.push_back(std::move(grade));
  }
  return grades;
}

} // namespace

double GradeNumber::at(double thickness) const {
  if (by_thickness.empty()) return value;
  const auto row =
      std::find_if(by_thickness.begin(), by_thickness.end(), [&](const auto &row) { return thickness <= row[0]; });
  return row == by_thickness.end() ? by_thickness.back()[1] : (*row)[1];
}

const GradeNumber *SteelGrade::find(const std::string &key) const {
  const auto found = numbers.find(key);
  return found == numbers.end() ? nullptr : &found->second;
}

bool is_of_the_curve(const std::string &key) {
  return key == "ultimate_MPa" || key == "uniform_strain";
}

const std::vector<SteelGrade> &steel_grades() {
  static const std::vector<SteelGrade> grades = read_grades();
  return grades;
}

const std::vector<std::string> &grade_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list{Material{}.grade};
    for (const SteelGrade &grade : steel_grades()) list.push_back(grade.name);
    return list;
  }();
  return names;
}

const SteelGrade &steel_grade(const std::string &name) {
  const auto &grades = steel_grades();
  const auto found = std::find_if(grades.begin(), grades.end(), [&](const auto &grade) { return grade.name == name; });
  if (found == grades.end()) throw InputError("grade " + unknown_word(name, grade_names()));
  return *found;
}

Hardening voce_through(double yield, double ultimate, double uniform) {
  const double S = ultimate * (1 + uniform), p = std::log1p(uniform), wanted = p * S / (S - yield);
  if (!(S > yield) || !(wanted < 1))
    throw InputError(fmt::format("no curve from a yield stress of {:g} MPa necks at {:g} MPa and a strain of {:g}",
                                 yield / 1e6, ultimate / 1e6, uniform));
  // y = b p solves y / (e^y - 1) = p S / (S - yield): the left side falls from 1 to 0.
  double low = 0, high = 100;
  constexpr int halvings = 200;
  for (int k = 0; k < halvings; ++k) {
    const double y = (low + high) / 2;
    (y > wanted * std::expm1(y) ? low : high) = y;
  }
  Hardening voce;
  voce.law = HardeningLaw::voce;
  voce.b = high / p;
  voce.Q = (S - yield) / -std::expm1(-high);
  return voce;
}

Material steel_of(const SteelGrade &grade, double thickness, std::optional<double> yield) {
  constexpr double MPa = 1e6;
  const auto at = [&](const char *key, double otherwise) {
    const GradeNumber *number = grade.find(key);
    return number ? number->at(thickness) : otherwise;
  };
  constexpr double default_limit = 0.20; // as in a bearing by default
  const StrainRate rate;
  const Fracture fracture;
  Material steel{at("E_MPa", 0) * MPa, at("nu", 0), at("density_kg_per_m3", 0)};
  steel.grade = grade.name;
  steel.yield = yield.value_or(at("yield_MPa", 0) * MPa);
  steel.hardening = voce_through(*steel.yield, at("ultimate_MPa", 0) * MPa, at("uniform_strain", 0));
  steel.strain_limit = at("strain_limit", default_limit);
  steel.rate.D = at("rate_D_per_s", rate.D), steel.rate.q = at("rate_q", rate.q);
  steel.fracture = {
      .D1 = at("fracture_D1", fracture.D1), .D2 = at("fracture_D2", fracture.D2), .D3 = at("fracture_D3", fracture.D3)};
  return steel;
}

double yield_of_hardness(double HB) {
  constexpr double MPa = 1e6, of_vickers = 0.95;
  return (2.876 * HB / of_vickers - 90.7) * MPa;
}

} // namespace rimpact::scene
