/// What an isolator carries: nothing that moves by itself, a one-storey inelastic frame (thesis 2.6.1, 4.3)
/// or a linear shear building, every storey with an axial spring. SI units.
#pragma once
#include "io/files/choice.h"
#include <string>
#include <vector>

namespace rimpact::scene {

enum class StructureKind { none, bouc_wen, shear_building };
constexpr auto choices(StructureKind) {
  using enum StructureKind;
  return choices_of<StructureKind>({{none, "none"}, {bouc_wen, "bouc-wen"}, {shear_building, "shear-building"}});
}

struct Superstructure {
  StructureKind kind = StructureKind::none;
  double mass_ratio = 0.9;     ///< gamma = m_s / (m_s + m_b), 0..1 exclusive; not read when `masses` is given
  double period = 0.6;         ///< T_s, elastic, base fixed: 2 pi sqrt(m_s / k_s), or the building's first [s], > 0
  double damping_ratio = 0.02; ///< of that period, proportional to the stiffness [-], 0..1
  // bouc-wen
  double yield = 0.02;      ///< u_y [m], > 0
  double post_yield = 0.05; ///< r_H > 0 or r_S < 0: k_y / k_s [-], -1..1 exclusive
  double exponent = 2;      ///< n [-], 1..50 (see reduced_models/structures/bouc_wen.h)
  double beta = 0.5;        ///< [-], 0.5..1
  // shear-building
  int storeys = 3;                 ///< 1..12
  std::vector<double> masses;      ///< of the floors above the base [kg]; empty: alike, by mass_ratio
  std::vector<double> stiffnesses; ///< of the storeys, from the base up [N/m]; empty: alike, by the period
  // axial
  double vertical_period = 0.1;         ///< 2 pi sqrt(m_s / k_v), or the building's first [s], > 0
  double vertical_damping_ratio = 0.02; ///< [-], 0..1

  bool any() const { return kind != StructureKind::none; }
  bool inelastic() const { return kind == StructureKind::bouc_wen; }
  int n_floors() const { return kind == StructureKind::none ? 0 : inelastic() ? 1 : storeys; }
  /// Masses of the floors [kg] under a total of `supported` that includes the base.
  std::vector<double> floor_masses(double supported) const;
  /// Throws InputError naming key, value and bound.
  void validate(double supported_mass) const;
  bool operator==(const Superstructure &) const = default;
};

} // namespace rimpact::scene
