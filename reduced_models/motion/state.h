/// What the integrators of the physical model advance: the bearing's state and, behind it, the building's; then the
/// modes of its heat, where friction goes by them.
#pragma once
#include "laws/friction/sliding_heat.h"
#include <algorithm>
#include <array>

namespace rimpact::reduced {

/// u, v, eta, then energies gathered along the way: work of the ground (external), lost in friction, taken by
/// the rim, and by what supports the mass: lost in the pad (`pad`), work against the pendular force (only read for
/// `constant`, where it is not W h). A building
/// adds what its dashpots have lost, the work of its hysteretic springs, and `n_floor` numbers a floor.
enum Index { iX, iY, iZ, iVX, iVY, iVZ, iEX, iEY, iExternal, iFriction, iImpact, iSupport, n_bearing };
enum BuildingIndex { iDamping = n_bearing, iHysteretic, iFloors };
/// Of a floor: displacement relative to the ground (z from the statically compressed building), velocity,
/// Bouc-Wen state of the storey below.
enum FloorIndex { fX, fY, fZ, fVX, fVY, fVZ, fEX, fEY, n_floor };
inline constexpr int max_floors = 12, max_state = iFloors + max_floors * n_floor + friction::n_heat_modes;

constexpr int state_size(int n_floors) {
  return n_floors > 0 ? iFloors + n_floors * n_floor : n_bearing;
}

/// A vector whose length is known at run time and bounded at compile time: only the part in use is copied.
class State {
public:
  explicit State(int size = n_bearing) : size_(size) { fill(0.0); }
  State(const State &other) : size_(other.size_) { std::copy(other.begin(), other.end(), begin()); }
  State &operator=(const State &other) {
    size_ = other.size_;
    std::copy(other.begin(), other.end(), begin());
    return *this;
  }
  int size() const { return size_; }
  double &operator[](int i) { return values_[i]; }
  double operator[](int i) const { return values_[i]; }
  double *begin() { return values_.data(); }
  double *end() { return begin() + size_; }
  const double *begin() const { return values_.data(); }
  const double *end() const { return begin() + size_; }
  void fill(double value) { std::fill(begin(), end(), value); }

private:
  int size_;
  std::array<double, max_state> values_;
};

} // namespace rimpact::reduced
