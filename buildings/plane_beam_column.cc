#include "buildings/plane_beam_column.h"
#include <cmath>
#include <Eigen/LU>
#include <limits>
#include <numbers>

namespace rimpact::buildings {

using Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Vector2d;

Matrix2d PlaneBeamColumn::interior() const {
  const double EI = bending.stiffness(), L = length();
  Matrix2d F;
  F << 2, -1, -1, 2;
  return F * (L / (6 * EI)) - Matrix2d::Identity() * (hinge_length / EI);
}

PlaneBeamColumn::Bent PlaneBeamColumn::bent(const DegradingBoucWen &law, const Vector2d &rotations,
                                            const SectionPoints &base, const SectionPoints &guess,
                                            SectionPoints &points) const {
  constexpr int most = 40;
  Bent b{false, Vector2d::Zero(), Matrix2d::Zero(), Vector2d::Zero()};
  const double L = length(), sag = load * L * L * L / (24 * law.stiffness());
  const Matrix2d F = interior();
  const Vector2d phi(rotations[0] + sag, rotations[1] - sag);
  Vector2d kappa(guess[0].d, guess[1].d);
  Matrix2d D = Matrix2d::Zero();
  const auto imbalance = [&](const Vector2d &at) -> Vector2d {
    for (int end = 0; end < 2; ++end) {
      const auto step = law.implicit_step(base[end], at[end], points[end]);
      b.moment[end] = step.force, D(end, end) = step.slope, points[end] = step.at;
    }
    return phi - F * b.moment - hinge_length * at;
  };
  Vector2d g = imbalance(kappa);
  const double size = phi.lpNorm<Eigen::Infinity>(), small = 1e-14 * size + 1e-18;
  for (int i = 0; i < most && g.lpNorm<Eigen::Infinity>() > small; ++i) {
    const Matrix2d J = F * D + hinge_length * Matrix2d::Identity();
    const Vector2d correction = J.inverse() * g;
    if (!correction.allFinite()) return b;
    double share = 1;
    Vector2d next = imbalance(kappa + correction);
    const bool settled = correction.lpNorm<Eigen::Infinity>() < 1e-13 * kappa.lpNorm<Eigen::Infinity>();
    while (!settled && !(next.norm() < g.norm()) && share > 1e-3)
      share /= 2, points = guess, next = imbalance(kappa + share * correction);
    kappa += share * correction, g = next;
    if (settled) break;
  }
  b.found = g.lpNorm<Eigen::Infinity>() < 1e-9 * (size + 1e-6);
  const Matrix2d inverse = (F * D + hinge_length * Matrix2d::Identity()).inverse();
  b.slopes = D * inverse;
  if (!interaction) return b;
  Vector2d explicitly; // of the moments at held curvatures
  for (int end = 0; end < 2; ++end) {
    DegradingBoucWen more = law;
    more.capacity->value *= 1 + 1e-6;
    explicitly[end] =
        (more.implicit_step(base[end], kappa[end], points[end]).force - b.moment[end]) / (1e-6 * law.capacity->value);
  }
  b.by_capacity = explicitly - D * inverse * F * explicitly;
  return b;
}

PlaneBeamColumn::Basic PlaneBeamColumn::basic(const Vector3 &v, const SectionPoints &base, const SectionPoints &guess,
                                              double dt) const {
  Basic b{Vector3::Constant(std::numeric_limits<double>::quiet_NaN()), Matrix3d::Zero(), guess};
  const auto stretch = axial.implicit_step(base[2], v[0] / length(), guess[2]);
  DegradingBoucWen law = bending;
  const auto factor = interaction ? interaction->factor(stretch.force) : AxialBending::Factor{1, 0};
  if (interaction) law.capacity = {factor.value, dt};
  const Bent ends = bent(law, v.tail<2>(), base, guess, b.points);
  if (!ends.found) return b;
  b.points[2] = stretch.at;
  b.force << stretch.force, ends.moment;
  b.slopes(0, 0) = stretch.slope / length();
  b.slopes.bottomRightCorner<2, 2>() = ends.slopes;
  b.slopes.bottomLeftCorner<2, 1>() = ends.by_capacity * (factor.slope * b.slopes(0, 0));
  return b;
}

PlaneBeamColumn::Answer PlaneBeamColumn::at(const PlaneVector &u, const SectionPoints &base, const SectionPoints &guess,
                                            double dt) const {
  const Vector2d rest = to - from, chord = rest + u.segment<2>(3) - u.segment<2>(0);
  const double L = rest.norm(), l = chord.norm(), c = chord[0] / l, s = chord[1] / l;
  const double turn = std::atan2(rest[0] * chord[1] - rest[1] * chord[0], rest.dot(chord));
  // Ends that have turned by more than half a turn: the chord's angle follows their mean.
  const double mean = (u[2] + u[5]) / 2,
               psi = turn + 2 * std::numbers::pi * std::round((mean - turn) / (2 * std::numbers::pi));
  const Vector2d stretch = u.segment<2>(3) - u.segment<2>(0);
  const double elongation = (2 * rest.dot(stretch) + stretch.squaredNorm()) / (l + L);
  Answer a;
  a.inner = basic({elongation, u[2] - psi, u[5] - psi}, base, guess, dt);
  PlaneVector r, z; // d l / du, l d psi / du
  r << -c, -s, 0, c, s, 0;
  z << s, -c, 0, -s, c, 0;
  Eigen::Matrix<double, 3, 6> B;
  B.row(0) = r.transpose(), B.row(1) = B.row(2) = -z.transpose() / l;
  B(1, 2) += 1, B(2, 5) += 1;
  const Vector3 &f = a.inner.force;
  a.force = B.transpose() * f;
  a.tangent = B.transpose() * a.inner.slopes * B + f[0] / l * z * z.transpose() +
              (f[1] + f[2]) / (l * l) * (r * z.transpose() + z * r.transpose());
  return a;
}

double PlaneBeamColumn::stored(const SectionPoints &p) const {
  const Vector2d M(bending.force(p[0]), bending.force(p[1]));
  return 0.5 * M.dot(interior() * M) + hinge_length * (bending.stored(p[0]) + bending.stored(p[1])) +
         length() * axial.stored(p[2]);
}

double PlaneBeamColumn::loss(const SectionPoints &p, const SectionPoints &r) const {
  return hinge_length * (bending.loss(p[0], r[0]) + bending.loss(p[1], r[1])) + length() * axial.loss(p[2], r[2]);
}

double PlaneBeamColumn::plastic_rotation(int end, const SectionPoints &p) const {
  return hinge_length * (p[end].d - bending.force(p[end]) / bending.stiffness());
}

} // namespace rimpact::buildings
