// How often the 95 % intervals hold the truth: an isolated impact at 0.3 m/s, k_i = 3e5 kN/m, e = 0.4, each
// repetition with errors of its own (synthetic.h: 1 % on the force, its gain and every sample). Prints the
// table; fails outside 92..98 %. Seeds are 1..n, so that it can be made again; coverage.txt holds what it gave.
#include "calibration/fit.h"
#include "synthetic.h"
#include <chrono>
#include <cstdio>

namespace {
using namespace rimpact::calibration;

struct Count {
  std::string name;
  double truth;
  int inside = 0;
  double square = 0, stated = 0; ///< of relative errors, found and stated
};

void add(Count &c, const Estimate &e) {
  c.inside += e.interval_low <= c.truth && c.truth <= e.interval_high;
  c.square += std::pow(e.value / c.truth - 1, 2);
  c.stated += std::pow(e.standard_error / c.truth, 2);
}

} // namespace

int main(int argc, char **argv) {
  const int n = argc > 1 ? std::atoi(argv[1]) : 1000;
  const Uncertainty noise{.force = 0.01, .displacement = 0.001, .speed = 0.01};
  const auto scene = rimpact::calibration::testing::window(0.3);
  std::vector<Count> counts = {{"k_i", 3e5}, {"e", 0.4}};
  const auto begin = std::chrono::steady_clock::now();
  for (int seed = 1; seed <= n; ++seed) {
    const StoredRun run = rimpact::calibration::testing::noisy(scene, seed, noise);
    FitOptions options;
    options.n_starts = 1;
    const auto result = fit({&run}, options);
    for (auto &c : counts) add(c, result.parameters.at(c.name));
  }
  bool good = true;
  for (const auto &c : counts) {
    const double share = double(c.inside) / n;
    good = good && share >= 0.92 && share <= 0.98;
    std::printf("%-4s covered %5.1f %%  error found %.3f %%, stated %.3f %%\n", c.name.c_str(), 100 * share,
                100 * std::sqrt(c.square / n), 100 * std::sqrt(c.stated / n));
  }
  std::printf("%d repetitions in %.1f s\n", n,
              std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  return good ? 0 : 1;
}
