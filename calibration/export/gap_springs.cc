#include "calibration/export/gap_springs.h"
#include <algorithm>
#include <ceres/ceres.h>
#include <fmt/format.h>

namespace rimpact::calibration {

double GapSpring::force(double d) const {
  const double yield = yield_force / stiffness, x = std::max(0.0, d - start);
  return x < yield ? stiffness * x : yield_force + hardening * stiffness * (x - yield);
}

double GapSpring::work(double d) const {
  const double yield = yield_force / stiffness, x = std::max(0.0, d - start), beyond = x - yield;
  return x < yield ? stiffness * x * x / 2
                   : yield_force * yield / 2 + beyond * (yield_force + hardening * stiffness * beyond / 2);
}

GapSpringsContact::GapSpringsContact(std::vector<GapSpring> springs) : springs_(std::move(springs)) {
  for (const auto &spring : springs_) {
    open_.push_back(spring.start);
    furthest_.push_back(spring.start + spring.yield_force / spring.stiffness);
  }
}

double GapSpringsContact::force(double d, double) const {
  double sum = 0;
  for (std::size_t j = 0; j < springs_.size(); ++j)
    sum += d > furthest_[j] ? springs_[j].force(d) : d < open_[j] ? 0 : springs_[j].stiffness * (d - open_[j]);
  return sum;
}

void GapSpringsContact::accept(double d) {
  for (std::size_t j = 0; j < springs_.size(); ++j)
    if (d > furthest_[j]) furthest_[j] = d, open_[j] = d - springs_[j].force(d) / springs_[j].stiffness;
}

double GapSpringsContact::work(double d) const {
  double sum = 0;
  for (std::size_t j = 0; j < springs_.size(); ++j) {
    const auto &spring = springs_[j];
    const double elastic = std::max(0.0, std::min(d, furthest_[j]) - open_[j]);
    sum += spring.stiffness * elastic * elastic / 2;
    if (d > furthest_[j]) sum += spring.work(d) - spring.work(furthest_[j]);
  }
  return sum;
}

double total_stiffness(const std::vector<GapSpring> &springs) {
  double sum = 0;
  for (const auto &spring : springs) sum += spring.stiffness;
  return sum;
}

namespace {

constexpr int n_springs = 4, per_spring = 4;

struct Target {
  double energy; ///< of the approaching mass [J]
  Bounce law, again;
};

/// Penetration [m] at which the springs have taken `energy`; their work is convex, so Newton's method falls to it.
double stop_of(const GapSpringsContact &springs, double energy, double deepest) {
  double d = deepest;
  while (springs.work(d) < energy) d *= 2;
  for (int i = 0; i < 40; ++i) {
    const double off = springs.work(d) - energy;
    if (off <= 1e-12 * energy) break;
    d -= off / springs.force(d, 0);
  }
  return d;
}

/// Of each spring: log E, log of the yield displacement, log eta, start over the deepest penetration.
std::vector<GapSpring> springs_of(const double *p, double deep) {
  std::vector<GapSpring> springs;
  for (int j = 0; j < n_springs; ++j) {
    const double *q = p + per_spring * j, E = std::exp(q[0]);
    springs.push_back({E, E * std::exp(q[1]), std::exp(q[2]), j == 0 ? 0 : deep * q[3]}); // one begins with the rim
  }
  return springs;
}

/// Peak force, rebound and penetration against the law's, and the peak force of a second hit on the dent; one unit is 5
/// % of the force, 0.07 of the approach speed, 10 % of the depth, 10 % of the second force.
struct Misfit {
  const std::vector<Target> *targets;
  bool operator()(double const *const *p, double *residuals) const {
    const auto springs = springs_of(p[0], targets->back().law.penetration);
    for (const auto &[energy, law, again] : *targets) {
      GapSpringsContact contact(springs);
      const double d = stop_of(contact, energy, law.penetration);
      double force = 0, returned = 0;
      for (const auto &spring : springs) force += spring.force(d), returned += spring.returned(d);
      contact.accept(d);
      const double second = contact.force(stop_of(contact, energy, d), 0);
      *residuals++ = (force / law.peak_force - 1) / 0.05;
      *residuals++ = (std::sqrt(returned / energy) - law.rebound) / 0.07;
      *residuals++ = std::log(d / law.penetration) / 0.10;
      *residuals++ = (second / again.peak_force - 1) / 0.10;
    }
    return true;
  }
};

/// What the four are tuned to, and where they may lie.
struct Range {
  double k, shallow, deep; ///< the law's stiffness [N/m]; its least and deepest penetration [m]
};

/// Yield displacements `spread` over the range; springs that begin one after the other up to `late` of it.
std::vector<double> guess(const Range &range, double spread, double late) {
  std::vector<double> p;
  for (int j = 0; j < n_springs; ++j) {
    const double at = double(j) / (n_springs - 1),
                 yield = spread * 0.1 * range.shallow * std::pow(5 * range.deep / range.shallow, at);
    p.insert(p.end(),
             {std::log(1.5 * range.k / n_springs),
              std::log(std::clamp(yield, 0.011 * range.shallow, 0.99 * range.deep)), std::log(0.02), late * at});
  }
  return p;
}

/// The misfit it comes to from there; p becomes the best of its valley. Infinite where none was found.
double tune(std::vector<double> &p, const Range &range, const std::vector<Target> &targets) {
  auto *cost = new ceres::DynamicNumericDiffCostFunction<Misfit>(new Misfit{&targets});
  cost->AddParameterBlock(per_spring * n_springs);
  cost->SetNumResiduals(static_cast<int>(4 * targets.size()));
  ceres::Problem problem;
  problem.AddResidualBlock(cost, nullptr, p.data());
  const double lower[per_spring] = {std::log(0.01 * range.k), std::log(0.01 * range.shallow), std::log(1e-4), 0},
               upper[per_spring] = {std::log(10 * range.k), std::log(range.deep), std::log(0.98), 1};
  for (int i = 0; i < per_spring * n_springs; ++i) {
    problem.SetParameterLowerBound(p.data(), i, lower[i % per_spring]);
    problem.SetParameterUpperBound(p.data(), i, upper[i % per_spring]);
  }
  ceres::Solver::Options options;
  options.max_num_iterations = 200, options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.IsSolutionUsable() ? summary.final_cost : INFINITY;
}

} // namespace

std::vector<GapSpring> gap_springs(const ExportedRim &rim) {
  std::vector<Target> targets;
  const double k = rim.settings.k_i;
  constexpr double below = 0.5; // of the slowest: weight and friction stop a slider on its dish the sooner
  for (const double v : speeds_between(below * rim.from, rim.tuned_to, 12)) {
    LawContact law(rim.element());
    const Bounce first = fly(law, rim.mass, v, k);
    targets.push_back({rim.mass * v * v / 2, first, fly(law, rim.mass, v, k)});
  }
  const Range range{k, targets.front().law.penetration, targets.back().law.penetration};
  std::vector<double> best;
  double least = INFINITY;
  for (const double spread : {0.3, 1.0, 3.0})
    for (const double late : {0.0, 0.1, 0.3}) {
      auto p = guess(range, spread, late);
      if (const double misfit = tune(p, range, targets); misfit < least) least = misfit, best = std::move(p);
    }
  if (best.empty()) throw std::logic_error("no springs were found for the elastoplastic law");
  auto springs = springs_of(best.data(), range.deep);
  std::sort(springs.begin(), springs.end(), [](const GapSpring &a, const GapSpring &b) {
    return a.start + a.yield_force / a.stiffness < b.start + b.yield_force / b.stiffness;
  });
  return springs;
}

} // namespace rimpact::calibration
