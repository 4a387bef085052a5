#include "fe_contact/laws/hardening.h"

#include "scene/flow_curve.h"
#include <algorithm>
#include <cmath>

namespace rimpact::fe {

using scene::HardeningLaw;

Hardening::Hardening(const scene::Material &material)
    : law_(material.hardening.law), yield_(material.yield.value_or(0)), K_(material.hardening.K),
      e0_(material.hardening.e0), n_(material.hardening.n), Q_(material.hardening.Q), b_(material.hardening.b) {
  if (law_ == HardeningLaw::bilinear) modulus_ = scene::hardening_modulus(material);
  if (law_ != HardeningLaw::table) return;
  rows_ = scene::flow_curve(material).rows;
  work_.push_back(0);
  for (std::size_t i = 1; i < rows_.size(); ++i)
    work_.push_back(work_.back() + (rows_[i][0] - rows_[i - 1][0]) * (rows_[i][1] + rows_[i - 1][1]) / 2);
}

Hardening::Point Hardening::between_rows(double alpha) const {
  const auto above = std::upper_bound(rows_.begin(), rows_.end(), alpha,
                                      [](double strain, const auto &row) { return strain < row[0]; });
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - rows_.begin(), 1) - 1);
  const double beyond = alpha - rows_[i][0],
               slope = above == rows_.end() ? 0 : (rows_[i + 1][1] - rows_[i][1]) / (rows_[i + 1][0] - rows_[i][0]);
  return {rows_[i][1] + slope * beyond, slope, work_[i] + beyond * (rows_[i][1] + slope * beyond / 2)};
}

Hardening::Point Hardening::curve(double alpha) const {
  switch (law_) {
  case HardeningLaw::bilinear:
    return {stress(alpha), modulus_, work(alpha)};
  case HardeningLaw::table:
    return between_rows(alpha);
  case HardeningLaw::swift: {
    const double strain = e0_ + alpha, stress = K_ * std::pow(strain, n_);
    return {stress, n_ * stress / strain, (stress * strain - K_ * std::pow(e0_, n_ + 1)) / (n_ + 1)};
  }
  case HardeningLaw::voce: {
    const double left = std::exp(-b_ * alpha), grown = -std::expm1(-b_ * alpha);
    return {yield_ + Q_ * grown, Q_ * b_ * left, (yield_ + Q_) * alpha - Q_ * grown / b_};
  }
  case HardeningLaw::ludwik: {
    const double growth = K_ * std::pow(alpha, n_);
    return {yield_ + growth, alpha > 0 ? n_ * growth / alpha : HUGE_VAL, alpha * (yield_ + growth / (n_ + 1))};
  }
  }
  return {};
}

} // namespace rimpact::fe
