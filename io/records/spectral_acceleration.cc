#include "io/records/spectral_acceleration.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rimpact {
namespace {

/// u'' + 2 xi w u' + w^2 u = -(a + b t): the exact motion over h as a linear map of (u, u', a, b).
struct Transfer {
  double u[4], v[4];
  Transfer(double w, double xi, double h) {
    const double wd = w * std::sqrt(1 - xi * xi), e = std::exp(-xi * w * h), c = std::cos(wd * h), s = std::sin(wd * h);
    // free vibration from (u, u')
    const double uu = e * (c + xi * w / wd * s), uv = e * s / wd;
    const double vu = -e * w * w / wd * s, vv = e * (c - xi * w / wd * s);
    // particular: u_p = -(a + b t) / w^2 + 2 xi b / w^3; the rest of the start decays freely
    const double w2 = w * w, w3 = w2 * w;
    u[0] = uu, u[1] = uv, v[0] = vu, v[1] = vv;
    u[2] = (uu - 1) / w2, v[2] = vu / w2;
    u[3] = -h / w2 + 2 * xi / w3 - 2 * xi / w3 * uu + uv / w2;
    v[3] = -1 / w2 - 2 * xi / w3 * vu + vv / w2;
  }
};

/// Calls visit(u) at every instant.
template <class Visit>
void fly_oscillator(const SampledSignal &record, double period, double damping, const Visit &visit) {
  const double w = 2 * std::numbers::pi / period;
  const int parts = std::max(1, static_cast<int>(std::ceil(100 * record.dt / period)));
  const double h = record.dt / parts;
  const Transfer over(w, damping, h);
  double u = 0, v = 0;
  const auto advance = [&](double a, double b) {
    const double next = over.u[0] * u + over.u[1] * v + over.u[2] * a + over.u[3] * b;
    v = over.v[0] * u + over.v[1] * v + over.v[2] * a + over.v[3] * b;
    u = next;
    visit(u);
  };
  for (std::size_t i = 0; i + 1 < record.values.size(); ++i) {
    const double slope = (record.values[i + 1] - record.values[i]) / record.dt;
    for (int part = 0; part < parts; ++part) advance(record.values[i] + part * h * slope, slope);
  }
  for (double t = 0; t < period; t += h) advance(0, 0);
}

} // namespace

double spectral_acceleration(const SampledSignal &record, double period, double damping) {
  if (record.values.empty()) return 0;
  double largest = 0;
  fly_oscillator(record, period, damping, [&](double u) { largest = std::max(largest, std::abs(u)); });
  const double w = 2 * std::numbers::pi / period;
  return w * w * largest;
}

std::vector<double> oscillator_travel(const SampledSignal &record, double period, double damping) {
  std::vector<double> travel;
  if (!record.values.empty()) fly_oscillator(record, period, damping, [&](double u) { travel.push_back(u); });
  return travel;
}

} // namespace rimpact
