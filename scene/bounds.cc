#include "scene/bounds.h"
#include "io/files/error.h"
#include "scene/scene.h"
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rimpact::scene {

namespace {

struct EuropeanFactor {
  Key key;
  std::optional<double> EuropeanFactors::*value;
};
constexpr std::array european_factors{
    EuropeanFactor{{"lambda_ageing", "of ageing, at its worst; inf: not given"}, &EuropeanFactors::ageing},
    EuropeanFactor{{"lambda_temperature", "of the lowest temperature; inf: not given"}, &EuropeanFactors::temperature},
    EuropeanFactor{{"lambda_contamination", "of dirt; inf: not given"}, &EuropeanFactors::contamination},
    EuropeanFactor{{"lambda_travel", "of the travel gathered over the life; inf: not given"},
                   &EuropeanFactors::travel}};

double product(const EuropeanFactors &factors) {
  double all = 1;
  for (const auto &[key, value] : european_factors) all *= 1 + factors.combination * ((factors.*value).value_or(1) - 1);
  return all;
}

void check_given(const FrictionBounds &b) {
  std::vector<std::string> missing;
  for (const auto &[key, value] : european_factors)
    if (!(b.european.*value)) missing.emplace_back(key.name);
  if (missing.empty() || b.lambda_max) return;
  throw InputError(fmt::format("[bounds] standard \"{}\" needs {}: the standard prints them by material, sealing and "
                               "temperature (EN 1998-2, annex JJ), and this program has no values of its own",
                               word(b.standard), fmt::join(missing, ", ")));
}

} // namespace

double FrictionBounds::factor(Bound bound) const {
  constexpr double together = 0.75; // not every influence is at its worst at once
  if (standard == BoundsStandard::en) {
    if (bound == Bound::upper) return lambda_max.value_or(product(european) * spec_max);
    if (bound == Bound::lower) return lambda_min.value_or(spec_min);
  }
  if (bound == Bound::upper) return lambda_max.value_or((1 + together * (ae_max - 1)) * test_max * spec_max);
  if (bound == Bound::lower) return lambda_min.value_or((1 - together * (1 - ae_min)) * test_min * spec_min);
  return 1;
}

void FrictionBounds::validate() const {
  if (standard == BoundsStandard::en) check_given(*this);
  const double low = factor(Bound::lower), high = factor(Bound::upper);
  if (low > high)
    throw InputError(fmt::format("[bounds] has a lower lambda of {:.4g} above its upper one of {:.4g}", low, high));
}

void visit(KeyVisitor &v, FrictionBounds &b) {
  constexpr Range up{1, 10}, down{0, 1, true};
  const bool asce = b.standard == BoundsStandard::asce;
  if (v.wants(!asce)) v.choice({.name = "standard", .meaning = "whose factors make the bounds"}, b.standard);
  if (v.wants(asce)) {
    v.number({"lambda_ae_max", "of ageing and environment; ASCE 7-22, 17.2.8.4", true}, b.ae_max, si, up);
    v.number({"lambda_ae_min", "of ageing and environment, least", true}, b.ae_min, si, down);
    v.number({"lambda_test_max", "of heating, speed and scragging in tests", true}, b.test_max, si, up);
    v.number({"lambda_test_min", "of heating, speed and scragging in tests, least", true}, b.test_min, si, down);
  }
  if (v.wants(!asce)) {
    auto &e = b.european;
    for (const auto &[key, value] : european_factors) v.limit(key, e.*value, si, up);
    v.number({"lambda_combination", "psi: how much of each counts, all taken together"}, e.combination, si, {0, 1});
  }
  v.number({"lambda_spec_max", "of production's tolerance", true}, b.spec_max, si, up);
  v.number({"lambda_spec_min", "of production's tolerance, least", true}, b.spec_min, si, down);
  if (v.wants(b.lambda_max.has_value()))
    v.limit({"lambda_max", "of the upper bound itself; inf: by the factors above"}, b.lambda_max, si, {0, 10, true});
  if (v.wants(b.lambda_min.has_value()))
    v.limit({"lambda_min", "of the lower bound itself; inf: by the factors above"}, b.lambda_min, si, {0, 10, true});
}

Scene at_bound(const Scene &scene, Bound bound) {
  Scene moved = scene;
  moved.reduced.measured.scale *= scene.bounds.factor(bound);
  return moved;
}

} // namespace rimpact::scene
