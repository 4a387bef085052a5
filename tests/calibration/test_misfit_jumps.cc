// Nothing in a misfit may jump with the model's sampling (decision 5).
#include "calibration/answer/calibration.h"
#include "calibration/fit/problem.h"
#include <cmath>
#include <gtest/gtest.h>

namespace rimpact::calibration {
namespace {

std::vector<StoredRun> references() {
  std::vector<StoredRun> runs;
  for (const char *speed : {"0.07", "0.20", "0.50"})
    runs.push_back(read_run(std::string(RIMPACT_REFERENCES) + "/window-" + speed, {}));
  return runs;
}

struct Case {
  const char *law;
  std::map<std::string, double> at; ///< parameters and values, reported units
};

/// Where fits of these windows end.
const Case cases[] = {
    {"elastoplastic", {{"k_i", 991333}, {"yield_force", 714.81}, {"hardening", 0.1397}, {"unloading_gain", 0.4862}}},
    {"no-tension", {{"k_i", 248000}, {"e", 0.18}}},
    {"signed", {{"k_i", 352000}, {"e", 0.33}}},
    {"hunt-crossley", {{"k_i", 5e6}, {"e", 0.3}}},
};

/// Largest second difference of any residual of the block in parameter `i` within 3e-4 of `x`: a smooth residual's is
/// curvature times step^2, a jump is itself.
double largest_jump(const Problem &problem, const ResidualBlock &block, const Eigen::VectorXd &x, int i) {
  constexpr double step = 5e-6;
  constexpr int n = 60;
  std::vector<std::vector<double>> rows;
  for (int k = -n; k <= n; ++k) {
    Eigen::VectorXd y = x;
    y(i) += k * step;
    rows.emplace_back(block.size());
    EXPECT_TRUE(problem.residuals(block, y.data(), nullptr, rows.back().data()));
  }
  double largest = 0;
  for (std::size_t k = 1; k + 1 < rows.size(); ++k)
    for (std::size_t j = 0; j < rows[k].size(); ++j)
      largest = std::max(largest, std::abs(rows[k + 1][j] - 2 * rows[k][j] + rows[k - 1][j]));
  return largest;
}

TEST(MisfitJumps, NoResidualJumpsBesideAFit) {
  const auto runs = references();
  for (const auto &c : cases) {
    FitOptions options;
    options.law = c.law, options.parameters.clear();
    for (const auto &[name, value] : c.at) options.parameters.push_back(name);
    const Problem problem({&runs[0], &runs[1], &runs[2]}, options);
    Eigen::VectorXd x(problem.n_parameters());
    for (int i = 0; i < x.size(); ++i) x(i) = problem.to_variable(i, c.at.at(problem.parameter(i).name));
    for (std::size_t b = 0; b < problem.blocks().size(); ++b)
      for (int i = 0; i < x.size(); ++i)
        EXPECT_LT(largest_jump(problem, *problem.blocks()[b], x, i), 2e-4)
            << c.law << ", " << problem.parameter(i).name << ", window " << b;
  }
}

// what a fit says must not hang on the step its differences are taken with
TEST(MisfitJumps, AFitIsTheSameByEveryStepOfItsDifferences) {
  const auto runs = references();
  std::vector<FitResult> fits;
  for (const double step : {1e-3, 1e-4, 1e-5}) {
    FitOptions options;
    options.law = "elastoplastic", options.parameters = {"k_i", "yield_force", "hardening", "unloading_gain"};
    options.n_starts = 1, options.difference_step = step;
    fits.push_back(fit({&runs[0], &runs[1], &runs[2]}, options));
  }
  for (const auto &[name, estimate] : fits[0].parameters)
    for (const auto &other : fits) {
      EXPECT_NEAR(other.parameters.at(name).value / estimate.value, 1, 1e-4) << name;
      EXPECT_NEAR(other.parameters.at(name).standard_error / estimate.standard_error, 1, 3e-3) << name;
    }
}

} // namespace
} // namespace rimpact::calibration
