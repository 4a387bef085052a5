/// Data of the two materials of a bearing (thesis Table 2-1). Data only: the laws live in fe_contact/laws.
#pragma once
#include <optional>

namespace rimpact::scene {

/// Isotropic elastic, optionally with J2 plasticity and bilinear isotropic hardening.
struct Material {
  double E;                                   ///< Young's modulus [Pa], > 0
  double nu;                                  ///< Poisson's ratio [-], 0 <= nu < 0.5
  double density;                             ///< [kg/m^3], > 0
  std::optional<double> yield = {};           ///< initial yield stress [Pa], > 0; none: elastic
  std::optional<double> tangent_modulus = {}; ///< slope of the uniaxial curve past yield [Pa], 0 <= E_t < E
  std::optional<double> strain_limit = {};    ///< equivalent plastic strain it is trusted to [-], > 0; none: not judged

  bool operator==(const Material &) const = default;
};

/// Hardening modulus H = E E_t / (E - E_t) [Pa] of the uniaxial bilinear curve.
inline double hardening_modulus(const Material &m) {
  const double tangent = m.tangent_modulus.value_or(0.0);
  return m.E * tangent / (m.E - tangent);
}

} // namespace rimpact::scene
