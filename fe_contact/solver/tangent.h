/// The tangent of a system, kept by its upper triangle where nothing in it is unsymmetric, else whole. A symmetric one
/// is factorised and multiplied for about half the price. What is added by both triangles is taken by its symmetric
/// part there.
#pragma once
#include "fe_contact/solver/linear_solver.h"

namespace rimpact::fe {

enum class Symmetry { symmetric, general };

class Tangent {
public:
  /// Each clique is a list of equations coupled with one another (-1 entries are skipped).
  Tangent(int n, const std::vector<std::vector<int>> &couplings, Symmetry symmetry, TimeSplit &times);

  /// The symmetric part, filled first; then `close_symmetric`, and the rest by `add`.
  SymmetricMatrix &symmetric() { return symmetric_; }
  void close_symmetric() {
    if (general_) general_->assign(symmetric_);
  }
  /// Entry (row, column). Throws std::logic_error outside the pattern.
  void add(int row, int column, double value);
  /// Entries of one row at columns in ascending order, which may repeat.
  void add_row(int row, const std::vector<int> &columns, const double *values);
  double diagonal(int i) const { return general_ ? general_->diagonal(i) : symmetric_.diagonal(i); }
  /// The equation becomes diagonal * change = -diagonal * miss, `miss` its value less what it is driven to. In a
  /// symmetric tangent its column goes too: `moved` gains what the change -miss does to the other equations' residuals.
  void drive(int equation, double diagonal, double miss, Eigen::VectorXd &moved);
  /// The dense tangent of some equations, others held; of all ranks.
  Eigen::MatrixXd block(const std::vector<int> &equations) const;
  Symmetry symmetry() const { return general_ ? Symmetry::general : Symmetry::symmetric; }
  Eigen::VectorXd multiply(const Eigen::VectorXd &x) const {
    return general_ ? general_->multiply(x) : symmetric_.multiply(x);
  }
  LinearSolver &solver() { return *solver_; }

private:
  SymmetricMatrix symmetric_;
  std::unique_ptr<GeneralMatrix> general_; ///< null: symmetric
  std::unique_ptr<LinearSolver> solver_;
};

} // namespace rimpact::fe
