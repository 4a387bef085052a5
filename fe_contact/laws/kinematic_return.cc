#include "fe_contact/laws/kinematic_return.h"

#include "fe_contact/laws/plastic_flow.h"
#include <cmath>

namespace rimpact::fe {
namespace {

Map6 deviatoric() {
  Map6 projector = Map6::Identity();
  projector.topLeftCorner<3, 3>().array() -= 1.0 / 3;
  return projector;
}

Tensor6 sum_of(const Backstress &back) {
  Tensor6 sum = Tensor6::Zero();
  for (const Tensor6 &term : back) sum += term;
  return sum;
}

const double root_3_2 = std::sqrt(1.5);

} // namespace

KinematicReturn kinematic_return(const HenckyJ2 &law, const Tensor6 &trial, const Backstress &back, const J2State &old,
                                 double dt) {
  const double mu = law.shear_modulus, alpha = old.alpha, soft = law.softening(old);
  KinematicReturn result{.strain = trial, .back = back};
  result.moduli = 2 * mu * deviatoric();
  const Tensor6 stress = 2 * mu * trial, before = sum_of(back);
  const double at_start = root_3_2 * (stress - before).norm(), excess = at_start - soft * law.hardening.stress(alpha);
  if (!(excess > 0)) return result;
  const auto fall = [&](double flow) {
    const FadedBackstress faded = law.backstress.faded(back, flow);
    const Tensor6 eta = stress - faded.sum;
    const double norm = eta.norm();
    return FallOfStress{at_start - root_3_2 * norm + 3 * mu * flow + law.backstress.growth(flow),
                        root_3_2 * eta.dot(faded.change) / norm + 3 * mu + law.backstress.growth_slope(flow)};
  };
  const StepFlow step =
      flow_of(law.hardening, law.rate,
              {.excess = excess, .alpha = alpha, .elastic = 3 * mu, .dt = dt, .softening = soft}, fall);
  const FadedBackstress faded = law.backstress.faded(back, step.flow);
  const Tensor6 eta = stress - faded.sum, n = eta.normalized();
  result.flow = step.flow;
  result.overstress = (soft * step.overstress + (soft - 1)) * law.hardening.stress(alpha + step.flow);
  result.strain -= root_3_2 * step.flow * n;
  result.back = law.backstress.next(back, step.flow, n);
  result.back_work = 0.5 * root_3_2 * step.flow * n.dot(before + sum_of(result.back));
  // d flow = by_trial sqrt(3/2) n : d s*, and d n = (1 - n n) (d s* - d (sum theta_k B_k)) / |eta|.
  const Tensor6 flow_by_strain = 2 * mu * root_3_2 * step.by_trial * n;
  const Map6 across = Map6::Identity() - n * n.transpose();
  const Map6 turn = across * (2 * mu * deviatoric() - faded.change * flow_by_strain.transpose()) / eta.norm();
  result.moduli -= 2 * mu * root_3_2 * (n * flow_by_strain.transpose() + step.flow * turn);
  return result;
}

} // namespace rimpact::fe
