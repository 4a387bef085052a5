/// One isolated impact against a contact that remembers: what a mass does on the exported spring as the target program
/// integrates it, and on the law itself. An integrator of its own, apart from the reduced models'.
#pragma once
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace rimpact::calibration {

/// Force of a rim on the slider over penetration; > 0 pushes back.
class RimContact {
public:
  virtual ~RimContact() = default;
  virtual double force(double penetration, double rate) const = 0; ///< [N] at d [m], d' [m/s], from the accepted state
  virtual void accept(double penetration) = 0;                     ///< a step ended there
  virtual bool pulls() const { return false; }                     ///< false: lets go where the force ends
};

/// The law itself, one arc of the rim that no impact has touched before.
class LawContact : public RimContact {
public:
  explicit LawContact(const laws::RimElement &rim) : rim_(rim) {}
  double force(double d, double rate) const override;
  void accept(double d) override { deepest_ = std::max(deepest_, d); }
  bool pulls() const override { return !rim_.law->unilateral; }

private:
  laws::RimElement rim_;
  double deepest_ = 0;
};

/// Spring and dashpot, k d + c d': ViscoelasticGap of OpenSees (pulls before release), or in series with a gap (never
/// pulls).
class DashpotContact : public RimContact {
public:
  DashpotContact(double stiffness, double damping, bool pulls) : k_(stiffness), c_(damping), pulls_(pulls) {}
  double force(double d, double rate) const override {
    return pulls_ || k_ * d + c_ * rate > 0 ? k_ * d + c_ * rate : 0;
  }
  void accept(double) override {}
  bool pulls() const override { return pulls_; }

private:
  double k_, c_;
  bool pulls_;
};

/// Hertzdamp of OpenSees: K d^n (1 + xi d' / v), v the speed of this impact's touch.
class HertzdampContact : public RimContact {
public:
  HertzdampContact(double K, double xi, double exponent, double touch_speed)
      : K_(K), xi_(xi), n_(exponent), v_(touch_speed) {}
  double force(double d, double rate) const override {
    return d > 0 ? std::max(0.0, K_ * std::pow(d, n_) * (1 + xi_ * rate / v_)) : 0;
  }
  void accept(double) override {}

private:
  double K_, xi_, n_, v_;
};

/// A fresh contact as the target program integrates it; `speed` is that of the touch (read by Hertzdamp).
using MakeContact = std::function<std::unique_ptr<RimContact>(double speed)>;

struct Bounce {
  double peak_force;  ///< [N]
  double penetration; ///< deepest [m]
  double rebound;     ///< over the approach speed [-]
  double duration;    ///< touch to release [s]
};
/// `mass` [kg] meets the contact at `speed` [m/s]; `stiffness` [N/m], the contact's largest, sets the step: pi sqrt(m /
/// k) / 4000, by Runge-Kutta's fourth order within a step. Throws DataError where the mass never comes back.
Bounce fly(RimContact &contact, double mass, double speed, double stiffness);

/// `n` speeds from `from` to `to` in equal ratios; one where they are the same.
std::vector<double> speeds_between(double from, double to, int n);

} // namespace rimpact::calibration
