#include "fe_contact/laws/backstress.h"

#include <cmath>

namespace rimpact::fe {

BackstressLaw::BackstressLaw(const scene::Material &material) {
  for (const auto &[C, gamma] : material.hardening.chaboche.values) {
    C_.at(n_) = C, gamma_.at(n_) = gamma;
    ++n_;
  }
}

FadedBackstress BackstressLaw::faded(const Backstress &old, double flow) const {
  FadedBackstress result{Tensor6::Zero(), Tensor6::Zero()};
  for (int k = 0; k < n_; ++k) {
    const double theta = 1 / (1 + gamma_[k] * flow);
    result.sum += theta * old[k];
    result.change -= gamma_[k] * theta * theta * old[k];
  }
  return result;
}

double BackstressLaw::growth(double flow) const {
  double sum = 0;
  for (int k = 0; k < n_; ++k) sum += C_[k] * flow / (1 + gamma_[k] * flow);
  return sum;
}

double BackstressLaw::growth_slope(double flow) const {
  double sum = 0;
  for (int k = 0; k < n_; ++k) sum += C_[k] / std::pow(1 + gamma_[k] * flow, 2);
  return sum;
}

Backstress BackstressLaw::next(const Backstress &old, double flow, const Tensor6 &n) const {
  Backstress result = old;
  for (int k = 0; k < n_; ++k) result[k] = (old[k] + std::sqrt(2.0 / 3.0) * C_[k] * flow * n) / (1 + gamma_[k] * flow);
  return result;
}

} // namespace rimpact::fe
