/// How far friction may lie from its nominal value over a bearing's life: the property modification factors lambda, and
/// a scene with all its friction at one end of the range. Source: ASCE 7-22, 17.2.8.4: lambda_max = (1 + 0.75
/// (lambda_ae,max - 1)) lambda_test,max lambda_spec,max and lambda_min = (1 - 0.75 (1 - lambda_ae,min)) lambda_test,min
/// lambda_spec,min. The defaults are the commentary's to 17.2.8.4 for unlubricated interfaces of a manufacturer who is
/// not known (2.12 and 0.60; McVitty and Constantinou 2015, MCEER-15-0003): assumptions until tests of the bearing say
/// otherwise. EN 15129, annex J, with EN 1998-2, annex JJ: lambda_max = lambda_spec_max times, of ageing, temperature,
/// contamination and accumulated travel, 1 + psi (lambda_f - 1), and lambda_min = lambda_spec_min. Its tables are not
/// at hand, so the four have to be given.
#pragma once
#include "io/files/choice.h"
#include "io/files/key_visitor.h"
#include <optional>

namespace rimpact::scene {

struct Scene;

enum class Bound { nominal, lower, upper };
constexpr auto choices(Bound) {
  using enum Bound;
  return choices_of<Bound>({{nominal, "nominal"}, {lower, "lower"}, {upper, "upper"}});
}

/// Whose factors make the bounds.
enum class BoundsStandard { asce, en };
constexpr auto choices(BoundsStandard) {
  using enum BoundsStandard;
  return choices_of<BoundsStandard>({{asce, "asce-7-22", "17.2.8.4, with its commentary's values where none is given"},
                                     {en, "en-15129", "annex J; its four factors have to be given"}});
}

/// Of EN 15129, each at its worst [-], >= 1.
struct EuropeanFactors {
  std::optional<double> ageing = {}, temperature = {}, contamination = {}, travel = {};
  double combination = 1; ///< psi [-], 0..1: of what each is above 1, for they are not all at their worst at once
  bool operator==(const EuropeanFactors &) const = default;
};

struct FrictionBounds {
  BoundsStandard standard = BoundsStandard::asce;
  double ae_max = 1.56, ae_min = 1;        ///< ageing and environment [-]
  double test_max = 1.3, test_min = 0.7;   ///< heating, speed and scragging in the prototype's tests [-]
  double spec_max = 1.15, spec_min = 0.85; ///< tolerance of production [-]
  EuropeanFactors european = {};
  std::optional<double> lambda_max = {}, lambda_min = {}; ///< in place of the products [-]

  double factor(Bound bound) const; ///< of friction [-]; 1 for the nominal run
  bool assumed() const { return !lambda_max && !lambda_min && *this == FrictionBounds(); }
  /// Throws InputError where the lower bound is above the upper one, or a factor of EN 15129 is missing.
  void validate() const;
  bool operator==(const FrictionBounds &) const = default;
};
void visit(KeyVisitor &visitor, FrictionBounds &bounds); ///< [bounds]

/// The scene with every coefficient of friction times the factor of the bound (reduced.mu_scale).
Scene at_bound(const Scene &scene, Bound bound);

} // namespace rimpact::scene
