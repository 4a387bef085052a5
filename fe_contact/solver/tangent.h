/// The tangent of a system, of this rank's cells and faces: the solids' symmetric part by its upper triangle, and what
/// contact with friction adds, whole, in a matrix of its own, which is small. Where nothing is unsymmetric the triangle
/// holds all, and is factorised for half the price.
#pragma once
#include "fe_contact/solver/linear_solver.h"
#include <optional>

namespace rimpact::fe {

enum class Symmetry { symmetric, general };

class Tangent {
public:
  /// What is filled into `symmetric()` is coupled by `solids`, what is added afterwards by `contacts` too.
  Tangent(int n, const Couplings &solids, const Couplings &contacts, Symmetry symmetry, TimeSplit &times);

  /// Before it is filled anew.
  void set_zero();
  SymmetricMatrix &symmetric() { return symmetric_; }
  const SymmetricMatrix &symmetric() const { return symmetric_; }
  /// Entry (row, column), among the contacts' couplings. What is added by both triangles of a symmetric tangent is
  /// taken by its symmetric part. Throws std::logic_error outside the pattern.
  void add(int row, int column, double value);
  /// A dense block of some equations in ascending order, which may repeat; likewise.
  void add_block(const std::vector<int> &equations, const Eigen::MatrixXd &block);
  double diagonal(int i) const { return symmetric_.diagonal(i) + (contact_ ? contact_->diagonal(i) : 0.0); }
  /// The equation becomes diagonal * change = -diagonal * miss, `miss` its value less what it is driven to. Its column
  /// goes from the symmetric part: `moved` gains what the change -miss does to the other equations' residuals by it.
  void drive(int equation, double diagonal, double miss, Eigen::VectorXd &moved);
  /// The dense tangent of some equations, others held; of all ranks.
  Eigen::MatrixXd block(const std::vector<int> &equations) const;
  Symmetry symmetry() const { return contact_ ? Symmetry::general : Symmetry::symmetric; }
  Eigen::VectorXd multiply(const Eigen::VectorXd &x) const;
  LinearSolver &solver() { return *solver_; }

private:
  SymmetricMatrix symmetric_;
  std::optional<GeneralMatrix> contact_; ///< none: symmetric
  std::unique_ptr<LinearSolver> solver_;
};

} // namespace rimpact::fe
