/// Data of the two materials of a bearing (thesis Table 2-1). Data only: the laws live in fe_contact/laws.
#pragma once
#include "files/choice.h"
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

/// Isotropic elastic, optionally with J2 plasticity, bilinear isotropic hardening and a growth with the strain rate.
struct Material {
  double E;                                   ///< Young's modulus [Pa], > 0
  double nu;                                  ///< Poisson's ratio [-], 0 <= nu < 0.5
  double density;                             ///< [kg/m^3], > 0
  std::optional<double> yield = {};           ///< initial yield stress [Pa], > 0; none: elastic
  std::optional<double> tangent_modulus = {}; ///< slope of the uniaxial curve past yield [Pa], 0 <= E_t < E
  std::optional<double> strain_limit = {};    ///< equivalent plastic strain it is trusted to [-], > 0; none: not judged

  StrainRate rate = {}; ///< of steel that yields

  bool knows_rate() const { return yield && rate.model != RateModel::none; }
  bool operator==(const Material &) const = default;
};

/// Hardening modulus H = E E_t / (E - E_t) [Pa] of the uniaxial bilinear curve.
inline double hardening_modulus(const Material &m) {
  const double tangent = m.tangent_modulus.value_or(0.0);
  return m.E * tangent / (m.E - tangent);
}

} // namespace rimpact::scene
