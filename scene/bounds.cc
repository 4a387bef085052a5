#include "scene/bounds.h"
#include "io/files/error.h"
#include "scene/scene.h"
#include <fmt/format.h>

namespace rimpact::scene {

double FrictionBounds::factor(Bound bound) const {
  constexpr double together = 0.75; // not every influence is at its worst at once
  if (bound == Bound::upper) return lambda_max.value_or((1 + together * (ae_max - 1)) * test_max * spec_max);
  if (bound == Bound::lower) return lambda_min.value_or((1 - together * (1 - ae_min)) * test_min * spec_min);
  return 1;
}

void FrictionBounds::validate() const {
  const double low = factor(Bound::lower), high = factor(Bound::upper);
  if (low > high)
    throw InputError(fmt::format("[bounds] has a lower lambda of {:.4g} above its upper one of {:.4g}", low, high));
}

void visit(KeyVisitor &v, FrictionBounds &b) {
  constexpr Range up{1, 10}, down{0, 1, true};
  v.number({"lambda_ae_max", "of ageing and environment; ASCE 7-22, 17.2.8.4", true}, b.ae_max, si, up);
  v.number({"lambda_ae_min", "of ageing and environment, least", true}, b.ae_min, si, down);
  v.number({"lambda_test_max", "of heating, speed and scragging in tests", true}, b.test_max, si, up);
  v.number({"lambda_test_min", "of heating, speed and scragging in tests, least", true}, b.test_min, si, down);
  v.number({"lambda_spec_max", "of production's tolerance", true}, b.spec_max, si, up);
  v.number({"lambda_spec_min", "of production's tolerance, least", true}, b.spec_min, si, down);
  if (v.wants(b.lambda_max.has_value()))
    v.limit({"lambda_max", "of the upper bound itself, as by EN 15129, annex J; inf: by the factors above"},
            b.lambda_max, si, {0, 10, true});
  if (v.wants(b.lambda_min.has_value()))
    v.limit({"lambda_min", "of the lower bound itself; inf: by the factors above"}, b.lambda_min, si, {0, 10, true});
}

Scene at_bound(const Scene &scene, Bound bound) {
  Scene moved = scene;
  moved.reduced.measured.scale *= scene.bounds.factor(bound);
  return moved;
}

} // namespace rimpact::scene
