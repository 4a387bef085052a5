/// TR-BDF2, one step of length h in two implicit stages: the trapezoidal rule as far as 2 d h, then the end by what the
/// start, the middle and the end itself give,
///   y(2 d h) = y0 + d h (y0' + y1'),      y(h) = y0 + w h (y0' + y1') + d h y2',      d = 1 - sqrt(1/2), w =
///   sqrt(2)/4.
/// Second order, L-stable, with a third-order error estimate. Source: Bank et al. (1985); coefficients as Hosea and
/// Shampine (1996). Whoever moves something by it (rigid bodies, a building and its bearings) solves the stages; what
/// they weigh stands here. SI units.
#pragma once
#include <cmath>

namespace rimpact::reduced {

/// A stage weighs the rates at the step's start by w1, those of the middle stage by w2, its own by `own`.
struct ImplicitStage {
  double t, h;               ///< of the stage; of the whole step [s]
  double w1, w2, own, reach; ///< [s]; reach: from the step's start to the stage
  bool last = false;
};

/// A position or velocity as a stage starts from it.
template <class Vector> struct StageStart {
  Vector moved;    ///< of a position: by all but the stage's own velocity [m]
  Vector base;     ///< of a velocity: by all but the stage's own acceleration [m/s]
  Vector velocity; ///< to begin with [m/s]
};

namespace tr_bdf2 {

inline const double own = 1 - std::sqrt(0.5), outer = std::sqrt(2.0) / 4;

inline ImplicitStage middle(double t, double h) {
  const double d = h * own;
  return {.t = t + 2 * d, .h = h, .w1 = d, .w2 = 0, .own = d, .reach = 2 * d};
}
inline ImplicitStage end(double t, double h) {
  const double w = h * outer;
  return {.t = t + h, .h = h, .w1 = w, .w2 = w, .own = h * own, .reach = h, .last = true};
}

/// What a stage takes of a quantity and its rates at the step's start and (read by the last stage alone) its middle.
template <class Vector>
Vector base(const ImplicitStage &s, const Vector &from, const Vector &from_rate, const Vector &middle_rate) {
  Vector sum = from + s.w1 * from_rate;
  if (s.last) sum += s.w2 * middle_rate;
  return sum;
}

/// By the states at the step's start and (read by the last stage alone) its middle.
template <class Vector, class Moving>
StageStart<Vector> start(const ImplicitStage &s, const Moving &from, const Moving &middle) {
  StageStart<Vector> r{
      s.w1 * from.velocity, base<Vector>(s, from.velocity, from.acceleration, middle.acceleration), {}};
  if (s.last) {
    r.moved += s.w2 * middle.velocity;
    r.velocity = middle.velocity + (1 - 2 * own) * s.h * middle.acceleration;
  } else {
    r.velocity = from.velocity + s.reach * from.acceleration;
  }
  return r;
}

/// At the step's end, of what has these rates at its start, middle and end.
template <class Value>
Value total(double h, const Value &from, const Value &start, const Value &middle, const Value &end) {
  return from + h * outer * (start + middle) + h * own * end;
}
/// Local error of the same.
template <class Rate> Rate error(double h, const Rate &start, const Rate &middle, const Rate &end) {
  const double e1 = h * (4 * outer - 1) / 3, e2 = -h / 3, e3 = h * 2 * own / 3;
  return e1 * start + e2 * middle + e3 * end;
}

} // namespace tr_bdf2
} // namespace rimpact::reduced
