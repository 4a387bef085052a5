/// Data of the two materials of a bearing (thesis Table 2-1). Data only: the laws live in fe_contact/laws.
#pragma once
#include "io/files/choice.h"
#include "io/files/key_visitor.h"
#include <optional>
#include <string>

namespace rimpact::scene {

/// Which law the flow stress follows with the plastic strain rate (fe_contact/laws/strain_rate.h).
enum class RateModel { none, cowper_symonds, johnson_cook };
constexpr auto choices(RateModel) {
  using enum RateModel;
  return choices_of<RateModel>({{none, "none"}, {cowper_symonds, "cowper-symonds"}, {johnson_cook, "johnson-cook"}});
}

/// Constants of both laws; the model at hand reads its own two.
struct StrainRate {
  RateModel model = RateModel::none;
  double D = 40.0;        ///< Cowper and Symonds: rate at which the flow stress is twice the static one [1/s], > 0
  double q = 5.0;         ///< Cowper and Symonds: exponent [-], >= 1; mild steel (Cowper and Symonds 1957)
  double C = 0.022;       ///< Johnson and Cook: growth by e-fold of the rate [-], > 0; 1006 steel (Johnson, Cook 1983)
  double reference = 1.0; ///< Johnson and Cook: rate up to which the steel is static [1/s], > 0
  bool operator==(const StrainRate &) const = default;
};

/// The model with its constants: "cowper-symonds, D = 40 1/s, q = 5".
std::string in_words(const StrainRate &rate);

/// Which curve the static flow stress follows over the plastic strain (fe_contact/laws/hardening.h).
enum class HardeningLaw { bilinear, table, swift, voce, ludwik };
constexpr auto choices(HardeningLaw) {
  using enum HardeningLaw;
  return choices_of<HardeningLaw>({{bilinear, "bilinear", "a line of tangent_modulus"},
                                   {table, "table", "straight between the rows of curve, held beyond the last"},
                                   {swift, "swift", "K (e0 + strain)^n"},
                                   {voce, "voce", "yield + Q (1 - exp(-b strain))"},
                                   {ludwik, "ludwik", "yield + K strain^n"}});
}

/// What the rows of a curve are.
enum class CurveKind { true_stress, engineering };
constexpr auto choices(CurveKind) {
  using enum CurveKind;
  return choices_of<CurveKind>({{true_stress, "true", "plastic strain and true stress"},
                                {engineering, "engineering", "strain and stress of a tensile test, elastic part too"}});
}

/// Whether the heat of plastic work softens the steel (fe_contact/laws/softening.h).
enum class Softening { none, adiabatic };
constexpr auto choices(Softening) {
  using enum Softening;
  return choices_of<Softening>(
      {{none, "none"}, {adiabatic, "adiabatic", "by the heat of its plastic work, none of which is led away"}});
}

/// Constants of the softening.
struct PlasticHeat {
  Softening model = Softening::none;
  double share = 0.9;    ///< of the plastic work that becomes heat, Taylor and Quinney (1934) [-], 0 < share <= 1
  double capacity = 460; ///< [J/(kg K)], > 0
  double melting = 1500; ///< temperature over the initial one at which nothing is left [K], > 0
  double exponent = 1;   ///< m of Johnson and Cook (1983) [-], > 0
  bool operator==(const PlasticHeat &) const = default;
};

constexpr int most_backstresses = 2;

/// Rows and constants of the curves; the law at hand reads its own.
struct Hardening {
  HardeningLaw law = HardeningLaw::bilinear;
  Rows curve = {}; ///< [-], [Pa]
  CurveKind curve_kind = CurveKind::true_stress;
  // 0: not given.
  double K = 0;  ///< Swift, Ludwik [Pa], > 0
  double e0 = 0; ///< Swift [-], > 0
  double n = 0;  ///< Swift, Ludwik [-], 0 < n <= 1
  double Q = 0;  ///< Voce: growth of the stress without end of strain [Pa], > 0
  double b = 0;  ///< Voce [-], > 0
  /// Of each backstress C [Pa], > 0, and gamma [-], >= 0; none: hardening is isotropic (fe_contact/laws/backstress.h).
  Rows chaboche = {};
  bool operator==(const Hardening &) const = default;
};

/// Constants of Johnson and Cook's fracture strain D1 + D2 exp(D3 triaxiality) (fe_contact/laws/crack_measure.h). Those
/// of Weldox 460 E (Borvik, Hopperstad, Berstad and Langseth, European Journal of Mechanics A 20, 2001): an assumption
/// for any other steel.
struct Fracture {
  double D1 = 0.0705; ///< [-], > 0
  double D2 = 1.732;  ///< [-], >= 0
  double D3 = -0.54;  ///< [-], <= 0
  // Of Bao and Wierzbicki's locus beside it; 0: not given, an estimate from the above (fracture_locus).
  double C1 = 0; ///< plastic strain at fracture in shear [-], > 0
  double C2 = 0; ///< in plain tension [-], > 0
  bool operator==(const Fracture &) const = default;
};

/// Plastic strains at fracture in shear and in plain tension that Bao and Wierzbicki's locus goes through [-].
struct FractureLocus {
  double shear, tension;
};
/// As given, or estimated: in tension Johnson and Cook's at a triaxiality of 1/3; in shear where the largest shear
/// stress is that of tension at fracture, tension (sqrt(3)/2)^(1/n) for a flow stress K eps^n, n = 0.2 (Lee 2005).
FractureLocus fracture_locus(const Fracture &fracture);

constexpr const char *no_grade = "none"; ///< as files write it

/// Isotropic elastic, optionally with J2 plasticity, isotropic hardening and a growth with the strain rate.
struct Material {
  double E;       ///< Young's modulus [Pa], > 0
  double nu;      ///< Poisson's ratio [-], 0 <= nu < 0.5
  double density; ///< [kg/m^3], > 0
  /// Initial yield stress [Pa], > 0; none: elastic. That of the curve itself for `table` and `swift`.
  std::optional<double> yield = {};
  std::optional<double> tangent_modulus = {}; ///< of the bilinear curve past yield [Pa], 0 <= E_t < E; none: another
  std::optional<double> strain_limit = {};    ///< equivalent plastic strain it is trusted to [-], > 0; none: not judged

  StrainRate rate = {};     ///< of steel that yields
  Hardening hardening = {}; ///< the same
  PlasticHeat heat = {};    ///< the same
  Fracture fracture = {};
  std::string grade = no_grade; ///< that the numbers were taken from (scene/steel_grades.h)
  double hardness_HB = 0;       ///< that the yield stress was estimated from, Brinell; 0: it was not

  bool has_grade() const { return grade != no_grade; }
  bool knows_rate() const { return yield && rate.model != RateModel::none; }
  bool operator==(const Material &) const = default;
};

/// Hardening modulus H = E E_t / (E - E_t) [Pa] of the uniaxial bilinear curve.
inline double hardening_modulus(const Material &m) {
  const double tangent = m.tangent_modulus.value_or(0.0);
  return m.E * tangent / (m.E - tangent);
}

} // namespace rimpact::scene
