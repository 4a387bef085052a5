// degrading_loop: rows "t d F e" of the degrading law under a growing path, for degrading_loop.py.
#include "buildings/degrading_bouc_wen.h"
#include <cmath>
#include <cstdio>

int main() {
  const rimpact::buildings::DegradingBoucWen law{.yield_force = 350,
                                                 .yield_deformation = 0.003,
                                                 .post_yield = 0.04,
                                                 .exponent = 1.5,
                                                 .beta = 0.7,
                                                 .strength_loss = 0.03,
                                                 .stiffness_loss = 0.08};
  constexpr int n = 400000;
  rimpact::buildings::DegradingBoucWen::Point p{};
  for (int i = 1; i <= n; ++i) {
    const double t = 10.0 * i / n, d = 0.004 * t * std::sin(2 * t);
    const auto step = law.implicit_step(p, d, p);
    p = step.at;
    if (i % 4000 == 0) std::printf("%.10g %.10g %.10g %.10g\n", t, d, step.force, p.e);
  }
}
