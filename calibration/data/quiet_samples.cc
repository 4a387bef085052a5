#include "calibration/data/quiet_samples.h"
#include "calibration/data/sample_noise.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace rimpact::calibration {

using Values = std::vector<double>;

double mean_of(const Values &v, std::size_t n) {
  return n > 0 ? std::accumulate(v.begin(), v.begin() + n, 0.0) / static_cast<double>(n) : 0;
}

std::size_t quiet_beginning(const Values &x, const Values &y) {
  double peak = 0;
  for (std::size_t i = 0; i < x.size(); ++i) peak = std::max(peak, std::hypot(x[i] - x[0], y[i] - y[0]));
  std::size_t n = 0;
  while (n < x.size() && std::hypot(x[n] - x[0], y[n] - y[0]) < 0.2 * peak) ++n;
  return n < x.size() ? n - n / 5 : 0;
}

void first_noise(ContactRecord &record, std::size_t beginning) {
  record.sigma = noise_of_differences(record.push);
  if (beginning < few_quiet) return;
  const Values off = about_line({record.push.begin(), record.push.begin() + static_cast<std::ptrdiff_t>(beginning)});
  record.sigma = std::max(record.sigma, scatter_of(off));
  record.inflation = correlation_of(off, std::vector<bool>(off.size(), true));
}

namespace {

/// Samples outside all contacts, and some way from them.
std::vector<bool> quiet_samples(const ContactRecord &record) {
  std::vector<bool> quiet(record.push.size(), true);
  for (const auto &c : record.contacts) {
    const std::size_t margin = (c.last - c.first) / 10 + 2, from = c.first - std::min(c.first, margin),
                      to = std::min(c.last + margin + 1, quiet.size());
    std::fill(quiet.begin() + from, quiet.begin() + to, false);
  }
  return quiet;
}

/// What the cell reads after the last contact beyond what it read before the first.
void find_left_over(ContactRecord &record, const std::vector<bool> &quiet) {
  if (record.contacts.empty()) return;
  double sum[2] = {}, n[2] = {};
  for (std::size_t i = 0; i < quiet.size(); ++i)
    if (const bool after = i > record.contacts.back().last; quiet[i] && (after || i < record.contacts.front().first))
      sum[after] += record.push[i], ++n[after];
  if (std::min(n[0], n[1]) < few_quiet) return;
  record.left_over = sum[1] / n[1] - sum[0] / n[0];
}

} // namespace

void measure_quiet(ContactRecord &record, const Values &x, const Values &y) {
  const std::vector<bool> is_quiet = quiet_samples(record);
  Values qx, qy, quiet;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (is_quiet[i]) qx.push_back(x[i]), qy.push_back(y[i]), quiet.push_back(record.push[i]);
  if (quiet.size() < few_quiet) return;
  const double centre = mean_of(quiet, quiet.size()), n = static_cast<double>(quiet.size());
  double square = 0;
  for (const double p : quiet) square += (p - centre) * (p - centre);
  record.sigma = std::sqrt(square / (n - 1)), record.n_quiet = static_cast<int>(quiet.size());
  record.inflation = correlation_of(record.push, is_quiet);
  find_left_over(record, is_quiet);
  if (std::abs(centre) > 4 * record.sigma * std::sqrt(record.inflation / n))
    record.zero_x = mean_of(qx, qx.size()), record.zero_y = mean_of(qy, qy.size());
}

} // namespace rimpact::calibration
