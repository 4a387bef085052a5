#include "calibration/export/plastic_link.h"
#include "calibration/export/golden_section.h"

namespace rimpact::calibration {

PlasticLinkContact::PlasticLinkContact(const PlasticLink &link)
    : f_(link.force), unloading_(1 / (1 / link.unloading + 1 / link.gap_stiffness)) {
  for (std::size_t i = 0; i < f_.size(); ++i) d_.push_back(link.displacement[i] + f_[i] / link.gap_stiffness);
}

double PlasticLinkContact::backbone(double d) const {
  std::size_t i = 1;
  while (i + 1 < d_.size() && d > d_[i]) ++i;
  return f_[i - 1] + (f_[i] - f_[i - 1]) * (d - d_[i - 1]) / (d_[i] - d_[i - 1]);
}

double PlasticLinkContact::force(double d, double) const {
  if (d >= deepest_) return backbone(d);
  return std::max(0.0, backbone(deepest_) - unloading_ * (deepest_ - d));
}

void PlasticLinkContact::accept(double d) {
  deepest_ = std::max(deepest_, d);
}

namespace {

constexpr int n_vertices = 14;
constexpr double first_force = 0.02; ///< of the first vertex, over the force at the smallest penetration

PlasticLink link_of(const std::vector<double> &depth, const std::vector<double> &force, double unloading) {
  const double gap = 100 * unloading, own = 1 / (1 / unloading - 1 / gap);
  PlasticLink link{.gap_stiffness = gap,
                   .unloading = own,
                   .displacement = {0, first_force * force[0] / own},
                   .force = {0, first_force * force[0]}};
  for (std::size_t i = 0; i < depth.size(); ++i)
    link.displacement.push_back(depth[i] - force[i] / gap), link.force.push_back(force[i]);
  return link;
}

} // namespace

PlasticLink plastic_link(const ExportedRim &rim) {
  const auto element = rim.element();
  const double k = rim.settings.k_i;
  std::vector<Bounce> law;
  const auto speeds = speeds_between(rim.from, rim.tuned_to, 10);
  for (const double v : speeds) {
    LawContact contact(element);
    law.push_back(fly(contact, rim.mass, v, k));
  }
  std::vector<double> depth, force;
  const double from = law.front().penetration / 10, to = 1.5 * law.back().penetration;
  for (const double d : speeds_between(from, to, n_vertices))
    depth.push_back(d), force.push_back(element.trial({.d = d, .rate = 0}));
  // returned energy F^2 / (2 K) against the law's, in rebound speeds, over ln K: one minimum, for each term has one
  const auto misfit = [&](double log_unloading) {
    double sum = 0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const double e = law[i].peak_force / (speeds[i] * std::sqrt(rim.mass * std::exp(log_unloading))) - law[i].rebound;
      sum += e * e;
    }
    return sum;
  };
  return link_of(depth, force, std::exp(golden_section(std::log(1.001 * k), std::log(100 * k), misfit)));
}

} // namespace rimpact::calibration
