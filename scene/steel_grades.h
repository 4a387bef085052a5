/// Steels by name, as data/materials/steels.toml has them: every number with its source, its scatter and whether it was
/// checked. The file is compiled in.
#pragma once
#include "scene/material.h"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::scene {

struct GradeNumber {
  std::vector<std::array<double, 2>> by_thickness; ///< [m], in the file's unit: each up to its thickness
  double value = 0;                                ///< where no thickness matters, in the file's unit
  std::string source, scatter;
  bool checked = false; ///< a page that prints it was read
  /// At a part's thickness [m]; beyond the last one the last one's.
  double at(double thickness) const;
};

struct SteelGrade {
  std::string name, title;
  std::map<std::string, GradeNumber> numbers; ///< by key: "yield_MPa", ...; beside the steel's keys ultimate_MPa and
                                              ///< uniform_strain [-]
  const GradeNumber *find(const std::string &key) const;
};

/// Whether a grade's number settles its curve, and is no key of the steel.
bool is_of_the_curve(const std::string &key);

const std::vector<SteelGrade> &steel_grades();
/// "none" and the names.
const std::vector<std::string> &grade_names();
/// Throws InputError for a name that is none.
const SteelGrade &steel_grade(const std::string &name);

/// The steel at a part's thickness [m]: what the grade says nothing of is as in a steel by default. Its curve is Voce's
/// through the yield stress, `yield` [Pa] where given, and the point where a bar necks.
Material steel_of(const SteelGrade &grade, double thickness, std::optional<double> yield = std::nullopt);

/// Voce's constants by which a bar that yields at `yield` [Pa] carries its largest engineering stress `ultimate` [Pa]
/// at the engineering strain `uniform`: with S = ultimate (1 + uniform) and p = ln(1 + uniform), the true stress is S
/// there and, after Considere, its slope too. Elastic strain is left out of p. Throws InputError where no curve does
/// so: p S >= S - yield.
Hardening voce_through(double yield, double ultimate, double uniform);

/// Yield stress [Pa] of steel of a Brinell hardness, an estimate: -90.7 + 2.876 HV in MPa, of 150 steels that are not
/// austenitic (Pavlina and Van Tyne 2008), with HB = 0.95 HV (ISO 18265).
double yield_of_hardness(double HB);

} // namespace rimpact::scene
