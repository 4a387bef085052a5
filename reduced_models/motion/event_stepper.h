/// Dormand-Prince steps with error control on one smooth branch after another, each shortened to the first event in it.
/// An event is located by repeating the step with other lengths, so its accuracy is the integrator's own and not that
/// of an interpolant. SI units.
///
/// What it moves, a System, has
///   Vector, Watch            a state; an event that can end a branch
///   rhs(t, y, dy)            rates; NaN where y is inadmissible, which cuts the step
///   value(watch, t, y)       positive before the event, through zero at it
///   value_at_end(watch, s)   the same at the end of the step last tried, whose rates were the last that `rhs` gave
///   begins_at_zero(watch)    whether a branch that begins at the event's zero can end by it
///   largest_step()           [s]
///   give_up(t, y)            throws SolverStopped: the steps have become too small there
#pragma once
#include "io/files/error.h"
#include "reduced_models/motion/dormand_prince.h"
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace rimpact::reduced {

template <class System> class EventStepper {
public:
  using Vector = typename System::Vector;
  using Watch = typename System::Watch;

  explicit EventStepper(System &system) : system_(system) {}

  /// Before the first step: y0 and the scales by which errors are judged; 0 leaves a component out. `breaks`: instants
  /// that end a step, ascending; empty: none. They must outlive the steps.
  void begin(double t, const Vector &y0, const Vector &inverse_scale, const std::vector<double> &breaks) {
    step.resize(y0.size());
    step.t = t, step.y0 = y0;
    inverse_scale_ = inverse_scale, breaks_ = &breaks, next_break_ = 0, h_ = 1e-3, n_short_ = 0;
  }

  /// One accepted step towards t_end, shortened to the first of `events` in it: its place among them, or -1. step.k[0]
  /// must hold the rates at its start.
  template <class Events> int advance(const Events &events, double t_end) {
    attempt_until_accepted(break_before(t_end));
    return first_of(events);
  }
  void try_step(double h) {
    step.advance([&](double t, const Vector &y, Vector &dy) { system_.rhs(t, y, dy); }, h);
  }
  bool accurate() const { return step.error(inverse_scale_) <= 1; }
  /// The next step begins where this one ends, at y.
  void move_on(const Vector &y) {
    n_short_ = step.h < shortest ? n_short_ + 1 : 0;
    step.t += step.h, step.y0 = y;
  }
  /// More zero-length steps than `most` have followed one another: branches change to and fro.
  bool chatters(int most) const { return n_short_ > most; }

  DormandPrince<Vector> step; ///< the one last tried

private:
  static constexpr double shortest = 1e-10; ///< [s]

  double break_before(double t_end) {
    while (next_break_ < breaks_->size() && (*breaks_)[next_break_] <= step.t + 1e-12) ++next_break_;
    return next_break_ < breaks_->size() ? std::min((*breaks_)[next_break_], t_end) : t_end;
  }

  void attempt_until_accepted(double t_limit) {
    for (;;) {
      const double room = std::min(system_.largest_step(), t_limit - step.t), h = h_ < 0.999 * room ? h_ : room;
      try_step(h);
      const double error = step.error(inverse_scale_);
      if (error <= 1) {
        const double grown = h * std::min(4.0, 0.9 * std::pow(std::max(error, 1e-10), -0.2));
        h_ = h < h_ ? std::max(h_, grown) : grown; // a step cut short by a limit says nothing against a longer one
        return;
      }
      h_ = std::isfinite(error) ? h * std::max(0.2, 0.9 * std::pow(error, -0.2)) : h / 4;
      if (h_ < 1e-13) system_.give_up(step.t, step.y0);
    }
  }

  /// A watch that is positive at the step's start, and its place.
  struct Falling {
    const Watch *watch;
    double before;
    int place;
  };

  template <class Events> int first_of(const Events &events) {
    std::vector<Falling> falling;
    std::vector<char> seen(std::distance(events.begin(), events.end()), 0);
    std::vector<std::pair<const Watch *, int>> at_zero; // or beyond it from the start
    const auto look = [&] {
      falling.clear();
      for (int place = 0; const Watch &watch : events) {
        if (!seen[place] && !(system_.value_at_end(watch, step) > 0)) {
          seen[place] = 1;
          const double before = system_.value(watch, step.t, step.y0);
          if (before > 0)
            falling.push_back({&watch, before, place});
          else if (system_.begins_at_zero(watch))
            at_zero.emplace_back(&watch, place);
        }
        ++place;
      }
      return !falling.empty();
    };
    int first = -1;
    while (look()) first = locate_first(falling); // the shortened step may end where others have fallen for a while
    for (std::size_t i = 0; i < at_zero.size(); ++i) { // which may grow
      const auto [watch, place] = at_zero[i];
      if (!(system_.value_at_end(*watch, step) < 0)) continue;
      if (holds_at_start(*watch)) return place;
      first = -1; // what was found lies beyond the shortened step
      while (look()) first = locate_first(falling);
    }
    return first;
  }

  /// A branch that began exactly at the zero: whether no shorter step finds a positive value; then the step's length is
  /// zero.
  bool holds_at_start(const Watch &watch) {
    for (double h = step.h / 4; h > shortest; h /= 4) {
      try_step(h);
      if (system_.value(watch, step.t + h, step.y1) > 0) return false;
    }
    try_step(0);
    return true;
  }

  /// The smallest of the values over those at the step's start, and whose it is.
  template <class Value> std::pair<double, int> lowest(const std::vector<Falling> &falling, const Value &value) const {
    std::pair<double, int> result{std::numeric_limits<double>::infinity(), -1};
    for (const auto &[watch, before, place] : falling)
      if (const double share = value(*watch) / before; share < result.first || std::isnan(share)) {
        result = {share, place};
        if (std::isnan(share)) break; // as one that has fallen: the step becomes shorter
      }
    return result;
  }

  /// A falling function's zero lies between; Illinois' rule, and now and then the middle.
  struct Bracket {
    double low, high, f_low, f_high;
    int last_side = 0, n_guesses = 0;

    double guess() {
      const double h = (low * f_high - high * f_low) / (f_high - f_low);
      return ++n_guesses % 12 && h > low && h < high ? h : (low + high) / 2;
    }
    void put(double h, double f) {
      const int side = f > 0 ? 1 : -1;
      (f > 0 ? low : high) = h;
      (f > 0 ? f_low : f_high) = f;
      if (side == last_side) (f > 0 ? f_high : f_low) /= 2; // the weight of the end that stays
      last_side = side;
    }
  };

  /// Where the step's interpolant first has an event [s], to about a millionth of the step.
  double first_of_interpolant(const std::vector<Falling> &falling) const {
    const auto f = [&](double h) {
      const Vector y = step.at(h / step.h);
      return lowest(falling, [&](const Watch &watch) { return system_.value(watch, step.t + h, y); }).first;
    };
    Bracket zero{0, step.h, 1, f(step.h)};
    while (zero.high - zero.low > 1e-7 * step.h && zero.f_high < 0 && zero.n_guesses < 40) {
      const double h = zero.guess();
      zero.put(h, f(h));
    }
    return zero.high;
  }

  /// Shortens the step to the first of the events, by steps of other lengths from its start: two about that of the
  /// interpolant, then to rounding. Its place.
  int locate_first(const std::vector<Falling> &falling) {
    constexpr double about = 1e-6; // of the step: how far an interpolant errs
    auto [f_high, first] = lowest_at_end(falling);
    Bracket zero{0, step.h, 1, f_high};
    const auto attempt = [&](double h) {
      try_step(h);
      const auto [f, place] = lowest_at_end(falling);
      zero.put(h, f);
      if (!(f > 0)) first = place;
    };
    const double whole = step.h, near = first_of_interpolant(falling);
    for (const double h : {near + about * whole, near - about * whole})
      if (h > zero.low && h < zero.high) attempt(h);
    while (zero.high - zero.low > 1e-15 + 1e-16 * step.t && zero.f_high != 0 && zero.n_guesses < 100)
      attempt(zero.guess());
    if (step.h != zero.high) try_step(zero.high);
    return first;
  }
  std::pair<double, int> lowest_at_end(const std::vector<Falling> &falling) const {
    return lowest(falling, [&](const Watch &watch) { return system_.value_at_end(watch, step); });
  }

  System &system_;
  Vector inverse_scale_;
  const std::vector<double> *breaks_ = nullptr;
  std::size_t next_break_ = 0;
  double h_ = 1e-3;
  int n_short_ = 0;
};

} // namespace rimpact::reduced
