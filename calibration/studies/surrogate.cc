#include "calibration/studies/surrogate.h"
#include <algorithm>
#include <cmath>
#include <Eigen/QR>

namespace rimpact::calibration {

namespace {

/// Smallest share of the largest pivot at which inputs count as independent.
constexpr double independent = 1e-6;

void measure_left_out(Surrogate &s, const Eigen::MatrixXd &A, const Eigen::VectorXd &residual) {
  const Eigen::MatrixXd hat = A * (A.transpose() * A).ldlt().solve(A.transpose());
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    // the residual of row i of a fit without it: r_i / (1 - h_ii)
    const double error = std::expm1(std::abs(residual(i)) / std::max(1 - hat(i, i), 1e-12));
    s.left_out_rms += error * error / static_cast<double>(A.rows());
    s.left_out_largest = std::max(s.left_out_largest, error);
  }
  s.left_out_rms = std::sqrt(s.left_out_rms);
}

} // namespace

double Surrogate::at(const std::vector<double> &x) const {
  double y = coefficient;
  for (std::size_t j = 0; j < x.size(); ++j) y *= std::pow(x[j] / centre[j], exponents[j]);
  return y;
}

bool Surrogate::covers(const std::vector<double> &x) const {
  for (std::size_t j = 0; j < x.size(); ++j)
    if (x[j] < low[j] * (1 - 1e-9) || x[j] > high[j] * (1 + 1e-9)) return false;
  return true;
}

std::optional<Surrogate> power_surrogate(const std::vector<std::vector<double>> &x, const std::vector<double> &y) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < y.size(); ++i)
    if (y[i] > 0) rows.push_back(i);
  const auto n_inputs = static_cast<Eigen::Index>(x.empty() ? 0 : x[0].size());
  const auto n = static_cast<Eigen::Index>(rows.size());
  if (n_inputs == 0 || n < n_inputs + 3) return {};
  Surrogate s;
  s.n_rows = static_cast<int>(n);
  Eigen::MatrixXd A(n, n_inputs + 1);
  Eigen::VectorXd b(n);
  A.col(0).setOnes();
  for (Eigen::Index j = 0; j < n_inputs; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) A(i, j + 1) = std::log(x[rows[i]][j]);
    const double mean = A.col(j + 1).mean();
    s.centre.push_back(std::exp(mean));
    s.low.push_back(std::exp(A.col(j + 1).minCoeff())), s.high.push_back(std::exp(A.col(j + 1).maxCoeff()));
    A.col(j + 1).array() -= mean;
  }
  for (Eigen::Index i = 0; i < n; ++i) b(i) = std::log(y[rows[i]]);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  qr.setThreshold(independent);
  if (qr.rank() < n_inputs + 1) return {};
  const Eigen::VectorXd fitted = qr.solve(b);
  s.coefficient = std::exp(fitted(0));
  s.exponents.assign(fitted.data() + 1, fitted.data() + fitted.size());
  measure_left_out(s, A, b - A * fitted);
  return s;
}

} // namespace rimpact::calibration
