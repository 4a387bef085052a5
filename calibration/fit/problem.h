/// The fit as numbers: unknowns x, residual blocks, differences. First of x are the fitted parameters (logarithms where
/// the catalogue says so); where a record states an error of its force channel's gain, that error follows, in standard
/// errors and known beforehand to +-1.
#pragma once
#include "calibration/fit/residuals.h"
#include <Eigen/Core>

namespace rimpact::calibration {

class Problem {
public:
  Problem(const std::vector<const StoredRun *> &runs, const FitOptions &options);

  int n_parameters() const { return static_cast<int>(parameters_.size()); }
  int n_unknowns() const { return static_cast<int>(lower_.size()); }
  bool fits_gain() const { return n_unknowns() > n_parameters(); }
  const Parameter &parameter(int i) const { return *parameters_[i]; }
  const Eigen::VectorXd &lower() const { return lower_; }
  const Eigen::VectorXd &upper() const { return upper_; }
  const std::vector<std::unique_ptr<ResidualBlock>> &blocks() const { return blocks_; }
  int n_impacts() const { return n_impacts_; }
  bool all_grazing() const { return all_grazing_; }
  int n_evaluations() const { return n_evaluations_; }
  const std::vector<std::string> &notes() const { return notes_; }

  double to_variable(int i, double reported) const;
  double to_reported(int i, double x) const;
  /// d x / d ln(value): turns a Jacobian in x into one in relative changes. Of a value that may vanish: relative to
  /// what its bounds admit, `size`.
  double per_relative_change(int i, double x) const;
  /// What a reported value's error is a share of: the value, of one that may vanish at least 5 % of its bounds.
  double size(int i, double reported) const;
  /// Unknowns that did not end at a bound; the fit cannot move the others.
  std::vector<int> free(const Eigen::VectorXd &x) const;
  scene::Scene apply(scene::Scene scene, const double *x) const;

  /// False where the reduced model refuses the values.
  bool residuals(const ResidualBlock &block, const double *x, const double *nuisance, double *r) const;
  /// Central differences (one-sided at a bound). `r`: the residuals there. `jacobian` is row-major, size() x
  /// n_unknowns().
  bool jacobian(const ResidualBlock &block, const double *x, const double *nuisance, const double *r,
                double *jacobian) const;
  /// The same by the block's own unknowns, size() x n_nuisance().
  bool nuisance_jacobian(const ResidualBlock &block, const double *x, const double *nuisance, double *jacobian) const;

  /// Where searches begin: the given start, what the hardest impact's curve says (first_guess.h), then points spread
  /// over the bounds; n_starts in all (the given one comes on top).
  std::vector<Eigen::VectorXd> starts() const;
  /// Further points spread over the bounds.
  std::vector<Eigen::VectorXd> more_starts(int count) const;

private:
  void add_blocks(const std::vector<const StoredRun *> &runs);
  Eigen::VectorXd clamped(const Eigen::VectorXd &x) const;
  Eigen::VectorXd point(const scene::Scene &scene) const;
  Eigen::VectorXd spread_point(int index) const;

  FitOptions options_;
  std::vector<const Parameter *> parameters_;
  Eigen::VectorXd lower_, upper_;
  std::vector<std::unique_ptr<ResidualBlock>> blocks_;
  std::vector<const ImpactWindow *> windows_;
  int n_impacts_ = 0;
  bool all_grazing_ = false;
  std::vector<std::string> notes_;
  mutable int n_evaluations_ = 0;
};

} // namespace rimpact::calibration
