#include "calibration/export/gap_springs.h"
#include <ceres/ceres.h>
#include <fmt/format.h>

namespace rimpact::calibration {

double GapSpring::force(double d) const {
  const double yield = yield_force / stiffness;
  return d < yield ? stiffness * d : yield_force + hardening * stiffness * (d - yield);
}

double GapSpring::work(double d) const {
  const double yield = yield_force / stiffness, beyond = d - yield;
  return d < yield ? stiffness * d * d / 2
                   : yield_force * yield / 2 + beyond * (yield_force + hardening * stiffness * beyond / 2);
}

GapSpringsContact::GapSpringsContact(std::vector<GapSpring> springs)
    : springs_(std::move(springs)), open_(springs_.size(), 0.0) {
  for (const auto &spring : springs_) furthest_.push_back(spring.yield_force / spring.stiffness);
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

double total_stiffness(const std::vector<GapSpring> &springs) {
  double sum = 0;
  for (const auto &spring : springs) sum += spring.stiffness;
  return sum;
}

namespace {

constexpr int n_springs = 4;

struct Target {
  double energy; ///< of the approaching mass [J]
  Bounce law;
};

/// Penetration [m] at which the springs have taken `energy`, bracketed from below by zero.
double stop_of(const std::vector<GapSpring> &springs, double energy, double deepest) {
  const auto work = [&](double d) {
    double sum = 0;
    for (const auto &spring : springs) sum += spring.work(d);
    return sum;
  };
  double low = 0, high = deepest;
  while (work(high) < energy) high *= 2;
  for (int i = 0; i < 60; ++i) (work((low + high) / 2) < energy ? low : high) = (low + high) / 2;
  return (low + high) / 2;
}

std::vector<GapSpring> springs_of(const double *p) {
  std::vector<GapSpring> springs;
  for (int j = 0; j < n_springs; ++j) {
    const double E = std::exp(p[3 * j]);
    springs.push_back({E, E * std::exp(p[3 * j + 1]), std::exp(p[3 * j + 2])});
  }
  return springs;
}

/// Peak force, rebound and penetration against the law's; one unit is 5 % of the force, 0.1 of the approach speed, 10 %
/// of the depth.
struct Misfit {
  const std::vector<Target> *targets;
  bool operator()(double const *const *p, double *residuals) const {
    const auto springs = springs_of(p[0]);
    for (const auto &[energy, law] : *targets) {
      const double d = stop_of(springs, energy, law.penetration);
      double force = 0, returned = 0;
      for (const auto &spring : springs) force += spring.force(d), returned += spring.returned(d);
      *residuals++ = (force / law.peak_force - 1) / 0.05;
      *residuals++ = (std::sqrt(returned / energy) - law.rebound) / 0.10;
      *residuals++ = std::log(d / law.penetration) / 0.10;
    }
    return true;
  }
};

} // namespace

std::vector<GapSpring> gap_springs(const ExportedRim &rim) {
  std::vector<Target> targets;
  const double k = rim.settings.k_i;
  for (const double v : speeds_between(rim.from, rim.to, 10)) {
    LawContact law(rim.element());
    targets.push_back({rim.mass * v * v / 2, fly(law, rim.mass, v, k)});
  }
  const double shallow = targets.front().law.penetration, deep = targets.back().law.penetration;
  std::vector<double> best;
  double least = INFINITY;
  for (const double spread : {0.3, 1.0, 3.0}) { // three starts: yield displacements crowded low, over the range, high
    std::vector<double> p;
    for (int j = 0; j < n_springs; ++j) {
      const double y = spread * 0.1 * shallow * std::pow(5 * deep / shallow, double(j) / (n_springs - 1));
      p.insert(p.end(),
               {std::log(1.5 * k / n_springs), std::log(std::clamp(y, 0.011 * shallow, 0.99 * deep)), std::log(0.02)});
    }
    auto *cost = new ceres::DynamicNumericDiffCostFunction<Misfit>(new Misfit{&targets});
    cost->AddParameterBlock(3 * n_springs);
    cost->SetNumResiduals(static_cast<int>(3 * targets.size()));
    ceres::Problem problem;
    problem.AddResidualBlock(cost, nullptr, p.data());
    for (int j = 0; j < n_springs; ++j) {
      const double lower[] = {std::log(0.01 * k), std::log(0.01 * shallow), std::log(1e-4)},
                   upper[] = {std::log(10 * k), std::log(deep), std::log(0.98)};
      for (int i = 0; i < 3; ++i)
        problem.SetParameterLowerBound(p.data(), 3 * j + i, lower[i]),
            problem.SetParameterUpperBound(p.data(), 3 * j + i, upper[i]);
    }
    ceres::Solver::Options options;
    options.max_num_iterations = 200, options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (summary.IsSolutionUsable() && summary.final_cost < least) least = summary.final_cost, best = p;
  }
  if (best.empty()) throw std::logic_error("no springs were found for the elastoplastic law");
  auto springs = springs_of(best.data());
  std::sort(springs.begin(), springs.end(), [](const GapSpring &a, const GapSpring &b) {
    return a.yield_force / a.stiffness < b.yield_force / b.stiffness;
  });
  return springs;
}

} // namespace rimpact::calibration
