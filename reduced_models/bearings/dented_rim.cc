#include "reduced_models/bearings/dented_rim.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rimpact::reduced {
namespace {

using Eigen::Vector2d;

constexpr double same_place = 1e-11; ///< along the wall [m]: the rounding of a straight path

double beside(const Dent &dent, const Vector2d &u, const DentShape &shape) {
  return along_wall(dent.direction, u, shape.wall);
}

/// Dented at `tau` from the touch, `s` beside the dent's own place [m]; < 0: not at all.
double seen(double deepest, double s, double tau, double flank) {
  return deepest - (s * s + 2 * tau * s) / (2 * flank);
}

/// Half the touch's length along the wall.
double half_touch(double depth, double flank) {
  return std::sqrt(2 * flank * depth);
}

/// Places over the half touch and their weights: Gauss's for an ellipse (Chebyshev, second kind).
struct Places {
  static constexpr int n = 9;
  std::array<double, n> at, weight;
  Places() {
    for (int i = 0; i < n; ++i) {
      const double angle = (i + 1) * std::numbers::pi / (n + 1);
      at[i] = std::cos(angle);
      weight[i] = 2.0 / (n + 1) * std::pow(std::sin(angle), 2);
    }
  }
};

/// Largest distance of a stroke's places from a touch at `from_start` along the wall from its first one [m].
double farthest(const WallStroke &stroke, double from_start) {
  return std::max(std::abs(from_start - stroke.low()), std::abs(from_start - stroke.high()));
}

} // namespace

DentShape dent_shape(const scene::Scene &scene) {
  const scene::Bearing &b = scene.bearing; // two rims in series are pressed half as deep each
  return {b.wall_radius(), b.slider.diameter / 2, scene.reduced.dent_spread / b.dishes()};
}

double DentedRim::deepest_at(const Vector2d &u, const DentShape &shape, const WallStroke *present) const {
  const double flank = shape.flank();
  double deepest = 0;
  for (const Dent &dent : dents_) deepest = std::max(deepest, seen(dent.deepest, beside(dent, u, shape), 0, flank));
  const auto look = [&](const WallStroke &stroke) {
    deepest = stroke.seen(along_wall(stroke.direction(), u, shape.wall), 0, flank, deepest);
  };
  for (const WallStroke &stroke : strokes_) look(stroke);
  if (present) look(*present);
  return deepest;
}

/// How far from a dent's place, along the wall, what it leaves may be looked at [m]: twice half the longest touch so
/// far.
double DentedRim::reach(double d, const DentShape &shape) const {
  double deepest = std::max(d, 0.0);
  for (const Dent &dent : dents_) deepest = std::max(deepest, dent.deepest);
  for (const WallStroke &stroke : strokes_) deepest = std::max(deepest, stroke.deepest());
  return 2 * half_touch(deepest, shape.flank());
}

/// As far as `reach` from u one dent, or one end of a stroke, is everywhere as deep as a press to d: the two differ by
/// a straight line over tau, so its ends decide.
bool DentedRim::covered(const Vector2d &u, double d, double reach, const DentShape &shape) const {
  const double flank = shape.flank();
  const auto covers = [&](double deepest, double s) { return seen(deepest, std::abs(s), reach, flank) >= d; };
  for (const Dent &dent : dents_)
    if (covers(dent.deepest, beside(dent, u, shape))) return true;
  for (const WallStroke &stroke : strokes_)
    if (covers(stroke.end_depth(), along_wall(stroke.direction(), u, shape.wall) - stroke.end_place())) return true;
  return false;
}

/// Drops what a press at u to d hides for good: as far as `reach` from its own place, s aside.
void DentedRim::forget_covered(const Vector2d &u, double d, const DentShape &shape) {
  const double flank = shape.flank(), wide = reach(d, shape);
  const auto hidden = [&](double deepest, double s) { return seen(deepest, s, -(s + wide), flank) <= d; };
  std::erase_if(dents_, [&](const Dent &dent) { return hidden(dent.deepest, std::abs(beside(dent, u, shape))); });
  std::erase_if(strokes_, [&](const WallStroke &stroke) {
    return hidden(stroke.deepest(), farthest(stroke, along_wall(stroke.direction(), u, shape.wall)));
  });
}

void DentedRim::press(const Vector2d &u, double d, const DentShape &shape) {
  if (d <= 0 || covered(u, d, reach(d, shape), shape)) return;
  forget_covered(u, d, shape);
  dents_.push_back({u.normalized(), d});
}

std::optional<WallStroke> DentedRim::under_way(double t, const WallPoint &at, const DentShape &shape) const {
  if (!from_ || !(t > since_)) return std::nullopt;
  return WallStroke(*from_, at, t - since_, shape.wall);
}

void DentedRim::arrive(double t, const WallPoint &at, const DentShape &shape) {
  const auto stroke = under_way(t, at, shape);
  from_.reset();
  if (!stroke) return press(at.direction, at.d, shape);
  const double length = stroke->high() - stroke->low(), flank = shape.flank();
  if (length < same_place) return press(at.direction, at.d, shape);
  if (!(stroke->deepest() > 0)) return;
  // From its last place no point of it is farther than `length`, so none leaves more than this anywhere.
  const double wide = reach(stroke->deepest(), shape) + length;
  if (covered(at.direction, stroke->deepest() + wide * length / flank, wide, shape)) return;
  if (at.d > 0) forget_covered(at.direction, at.d, shape);
  strokes_.push_back(*stroke);
}

RimPush DentedRim::push(const laws::RimElement &rim, const Vector2d &u, const laws::RimMotion &motion,
                        const DentShape &shape, const WallStroke *present) const {
  static const Places places;
  const double flank = shape.flank();
  laws::RimMotion at = motion;
  at.deepest = deepest_at(u, shape, present);
  const double half = half_touch(std::max({at.deepest, motion.d, 0.0}), flank);
  // What lies aside is met over the touch; without it, the law as it stands.
  struct Seen {
    double deepest, s;
    const WallStroke *stroke;
  };
  std::vector<Seen> aside;
  aside.reserve(dents_.size() + strokes_.size() + 1);
  for (const Dent &dent : dents_) aside.push_back({dent.deepest, beside(dent, u, shape), nullptr});
  const auto add = [&](const WallStroke &stroke) {
    aside.push_back({stroke.deepest(), along_wall(stroke.direction(), u, shape.wall), &stroke});
  };
  for (const WallStroke &stroke : strokes_) add(stroke);
  if (present) add(*present);
  const auto is_aside = [&](const Seen &piece) {
    const double far = piece.stroke ? farthest(*piece.stroke, piece.s) : std::abs(piece.s),
                 near = piece.stroke ? far - (piece.stroke->high() - piece.stroke->low()) : far;
    return far > same_place && near < half + std::sqrt(half * half + 2 * flank * piece.deepest);
  };
  if (!(half > 0) || std::none_of(aside.begin(), aside.end(), is_aside)) {
    const double force = rim.trial(at);
    return {std::max(0.0, force), 0, force};
  }
  RimPush result;
  double nearest = -INFINITY;
  for (int i = 0; i < Places::n; ++i) {
    const double tau = half * places.at[i];
    at.deepest = 0;
    for (const Seen &piece : aside)
      at.deepest = piece.stroke ? piece.stroke->seen(piece.s, tau, flank, at.deepest)
                                : std::max(at.deepest, seen(piece.deepest, piece.s, tau, flank));
    const double force = rim.trial(at);
    nearest = std::max(nearest, force);
    if (force <= 0) continue;
    result.inwards += places.weight[i] * force;
    result.along -= places.weight[i] * force * tau / shape.slider;
  }
  result.trial = nearest > 0 ? result.inwards : nearest;
  return result;
}

} // namespace rimpact::reduced
