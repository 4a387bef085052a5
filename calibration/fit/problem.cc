#include "calibration/fit/problem.h"
#include "calibration/fit/first_guess.h"
#include "calibration/fit/halton.h"
#include "io/files/error.h"
#include "laws/impact/catalogue.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact::calibration {

namespace {

/// Bounds of the gain's error, in standard errors.
constexpr double widest_gain = 10;
/// Share of the bounds' range within which a value counts as standing at the bound.
constexpr double at_bound = 1e-6;
/// Of central differences, in standard errors of what is differenced.
constexpr double nuisance_step = 0.1;

bool any_flight(const std::vector<const Parameter *> &parameters) {
  return std::any_of(parameters.begin(), parameters.end(), [](const Parameter *p) { return p->seen_in_flight; });
}

} // namespace

Problem::Problem(const std::vector<const StoredRun *> &runs, const FitOptions &options) : options_(options) {
  const auto n = static_cast<Eigen::Index>(options.parameters.size());
  lower_.resize(n), upper_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Parameter &p = calibration::parameter(options.parameters[i]);
    parameters_.push_back(&p);
    const auto given = options.bounds.find(p.name);
    const Bounds bounds = given == options.bounds.end() ? Bounds{p.lower, p.upper} : given->second;
    lower_(i) = to_variable(static_cast<int>(i), bounds.lower);
    upper_(i) = to_variable(static_cast<int>(i), bounds.upper);
  }
  add_blocks(runs);
  if (std::none_of(blocks_.begin(), blocks_.end(), [](const auto &block) { return block->gain_error() > 0; })) return;
  blocks_.push_back(gain_block(blocks_.front()->scene()));
  lower_.conservativeResize(n + 1), upper_.conservativeResize(n + 1);
  lower_(n) = -widest_gain, upper_(n) = widest_gain;
}

void Problem::add_blocks(const std::vector<const StoredRun *> &runs) {
  int n_clear = 0, n_grazing = 0;
  for (const StoredRun *run : runs)
    for (const auto &w : run->impacts) ++(w.grazing ? n_grazing : n_clear);
  all_grazing_ = n_clear == 0 && n_grazing > 0;
  const bool drop = n_clear > 0 && !options_.keep_grazing;
  if (drop && n_grazing > 0)
    notes_.push_back(fmt::format("{} grazing impact{} left out: a slightly different flight would miss the rim",
                                 n_grazing, n_grazing > 1 ? "s" : ""));
  for (const StoredRun *run : runs) {
    for (const auto &w : run->impacts) {
      if (drop && w.grazing) continue;
      blocks_.push_back(impact_block(*run, w, options_));
      windows_.push_back(&w);
      ++n_impacts_;
    }
    if (any_flight(parameters_) && !run->is_window()) blocks_.push_back(flight_block(*run, options_));
  }
  std::erase_if(blocks_, [](const auto &block) { return block->size() == 0; });
  if (blocks_.empty()) throw DataError("no impact is left to fit");
}

double Problem::to_variable(int i, double reported) const {
  return parameters_[i]->to_variable(reported);
}
double Problem::to_reported(int i, double x) const {
  return parameters_[i]->to_reported(x);
}
double Problem::per_relative_change(int i, double x) const {
  return parameters_[i]->logarithmic ? 1.0 : size(i, x);
}
double Problem::size(int i, double reported) const {
  const Parameter &p = *parameters_[i];
  if (p.lower > 0) return std::abs(reported);
  return std::max(std::abs(reported), 0.05 * std::max(std::abs(p.lower), std::abs(p.upper)));
}

std::vector<int> Problem::free(const Eigen::VectorXd &x) const {
  std::vector<int> inside;
  for (int i = 0; i < n_unknowns(); ++i)
    if (std::min(x(i) - lower_(i), upper_(i) - x(i)) >= at_bound * (upper_(i) - lower_(i))) inside.push_back(i);
  return inside;
}

scene::Scene Problem::apply(scene::Scene scene, const double *x) const {
  for (int i = 0; i < n_parameters(); ++i) parameters_[i]->set(scene, to_reported(i, x[i]) * parameters_[i]->si);
  return scene;
}

bool Problem::residuals(const ResidualBlock &block, const double *x, const double *nuisance, double *r) const {
  ++n_evaluations_;
  const std::span<double> values(r, block.size());
  try {
    block.evaluate(apply(block.scene(), x),
                   {.nuisance = {nuisance, static_cast<std::size_t>(block.n_nuisance())},
                    .gain = fits_gain() ? x[n_parameters()] : 0},
                   values);
  } catch (const Error &) { // values the reduced model refuses: the search steps back
    return false;
  }
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool Problem::jacobian(const ResidualBlock &block, const double *x, const double *nuisance, const double *r,
                       double *jacobian) const {
  const int n = n_unknowns(), m = block.size();
  std::vector<double> ahead(m), behind(m);
  for (int i = 0; i < n_parameters(); ++i) {
    const double h = options_.difference_step;
    Eigen::VectorXd a = Eigen::Map<const Eigen::VectorXd>(x, n), b = a;
    a(i) = std::min(x[i] + h, upper_(i)), b(i) = std::max(x[i] - h, lower_(i));
    if (!residuals(block, a.data(), nuisance, ahead.data()) || !residuals(block, b.data(), nuisance, behind.data()))
      return false;
    for (int j = 0; j < m; ++j) jacobian[j * n + i] = (ahead[j] - behind[j]) / (a(i) - b(i));
  }
  if (!fits_gain()) return true;
  const Eigen::VectorXd slope = block.gain_slope(x[n_parameters()], Eigen::Map<const Eigen::VectorXd>(r, m));
  for (int j = 0; j < m; ++j) jacobian[j * n + n - 1] = slope(j);
  return true;
}

bool Problem::nuisance_jacobian(const ResidualBlock &block, const double *x, const double *nuisance,
                                double *jacobian) const {
  const int n = block.n_nuisance(), m = block.size();
  std::vector<double> ahead(m), behind(m);
  for (int i = 0; i < n; ++i) {
    Eigen::VectorXd a = Eigen::Map<const Eigen::VectorXd>(nuisance, n), b = a;
    a(i) += nuisance_step, b(i) -= nuisance_step;
    if (!residuals(block, x, a.data(), ahead.data()) || !residuals(block, x, b.data(), behind.data())) return false;
    for (int j = 0; j < m; ++j) jacobian[j * n + i] = (ahead[j] - behind[j]) / (2 * nuisance_step);
  }
  return true;
}

Eigen::VectorXd Problem::clamped(const Eigen::VectorXd &x) const {
  const Eigen::VectorXd margin = 0.01 * (upper_ - lower_);
  return x.cwiseMax(lower_ + margin).cwiseMin(upper_ - margin);
}

/// Of the parameters' values in `scene`; the gain is what it says.
Eigen::VectorXd Problem::point(const scene::Scene &scene) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n_unknowns());
  for (int i = 0; i < n_parameters(); ++i) x(i) = to_variable(i, parameters_[i]->get(scene) / parameters_[i]->si);
  return clamped(x);
}

Eigen::VectorXd Problem::spread_point(int index) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n_unknowns());
  for (int i = 0; i < n_parameters(); ++i)
    x(i) = lower_(i) + radical_inverse(index, halton_bases[i % std::size(halton_bases)]) * (upper_(i) - lower_(i));
  return clamped(x);
}

std::vector<Eigen::VectorXd> Problem::starts() const {
  std::vector<Eigen::VectorXd> points;
  const Eigen::VectorXd own = point(first_guess(blocks_.front()->scene(), windows_, parameters_));
  if (!options_.start.empty()) {
    Eigen::VectorXd x = own;
    for (int i = 0; i < n_parameters(); ++i)
      if (const auto given = options_.start.find(parameters_[i]->name); given != options_.start.end())
        x(i) = std::clamp(to_variable(i, given->second), lower_(i), upper_(i));
    points.push_back(x);
  }
  if (options_.n_starts > 0) points.push_back(own);
  for (int i = 1; i < options_.n_starts; ++i) points.push_back(spread_point(i));
  return points;
}

std::vector<Eigen::VectorXd> Problem::more_starts(int count) const {
  std::vector<Eigen::VectorXd> points;
  for (int i = 0; i < count; ++i) points.push_back(spread_point(std::max(1, options_.n_starts) + i));
  return points;
}

} // namespace rimpact::calibration
