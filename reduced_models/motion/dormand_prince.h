/// Dormand-Prince 5(4): one step, its error estimate and its continuous extension of order four.
/// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I (1993), II.4-II.6.
#pragma once
#include "reduced_models/motion/state.h"
#include <array>
#include <cmath>

namespace rimpact::reduced {

/// A step from (t, y0) over h; k[0] must hold f(t, y0). After `advance` y1 and k[6] = f(t + h, y1) are set.
/// `Vector`: made by its length, indexed from 0.
template <class Vector> struct DormandPrince {
  double t = 0, h = 0;
  Vector y0, y1;
  std::array<Vector, 7> k; ///< as long as y0 (resize)

  void resize(int n_state) {
    y0 = y1 = Vector(n_state);
    k.fill(y0);
  }

  template <class Rhs> void advance(const Rhs &f, double step) {
    h = step;
    const int n = static_cast<int>(y0.size());
    Vector y(n);
    const auto stage = [&](int i, double c, auto... a) {
      const double weights[] = {a...};
      for (int j = 0; j < n; ++j) {
        double sum = 0;
        for (int s = 0; s < int(sizeof...(a)); ++s) sum += weights[s] * k[s][j];
        y[j] = y0[j] + h * sum;
      }
      f(t + c * h, y, k[i]);
    };
    stage(1, 1. / 5, 1. / 5);
    stage(2, 3. / 10, 3. / 40, 9. / 40);
    stage(3, 4. / 5, 44. / 45, -56. / 15, 32. / 9);
    stage(4, 8. / 9, 19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729);
    stage(5, 1., 9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656);
    stage(6, 1., 35. / 384, 0., 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84);
    y1 = y;
  }

  /// Largest component of the embedded error over its scale; 0 in `scale` leaves a component out.
  double error(const Vector &inverse_scale) const {
    constexpr double e[] = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40};
    double largest = 0;
    for (int j = 0; j < y0.size(); ++j) {
      double sum = 0;
      for (int s = 0; s < 7; ++s) sum += e[s] * k[s][j];
      const double scaled = std::abs(h * sum) * inverse_scale[j];
      if (!(scaled <= largest)) // keeps a NaN
        largest = scaled;
      if (std::isnan(largest)) return largest;
    }
    return largest;
  }

  /// Continuous extension at t + theta h, theta in [0, 1].
  Vector at(double theta) const {
    constexpr double d[] = {-12715105075. / 11282082432.,  0,
                            87487479700. / 32700410799.,   -10690763975. / 1880347072.,
                            701980252875. / 199316789632., -1453857185. / 822651844.,
                            69997945. / 29380423.};
    Vector y(y0.size());
    const double rest = 1 - theta;
    for (int j = 0; j < y0.size(); ++j) {
      const double dy = y1[j] - y0[j], b = h * k[0][j] - dy, c = dy - h * k[6][j] - b;
      double sum = 0;
      for (int s = 0; s < 7; ++s) sum += d[s] * k[s][j];
      y[j] = y0[j] + theta * (dy + rest * (b + theta * (c + rest * h * sum)));
    }
    return y;
  }
};
using DormandPrinceStep = DormandPrince<State>;

} // namespace rimpact::reduced
