/// Linear equations of bodies in a chain: each is coupled to the one below and above it only, as the sliders, the plate
/// and the floors of a bearing are. Block elimination from the last body down, n unknowns a body.
#pragma once
#include "reduced_models/rigid_body/system.h"
#include <Eigen/LU>

namespace rimpact::reduced::rigid {

template <int n> class Chain {
public:
  using Block = Eigen::Matrix<double, n, n>;
  using Part = Eigen::Matrix<double, n, 1>;

  Block &diagonal(int body) { return diagonal_[body]; }
  Block &below(int body) { return below_[body]; } ///< of the equations of `body`, by the unknowns of body - 1
  Block &above(int body) { return above_[body]; } ///< of the equations of `body`, by the unknowns of body + 1

  /// Takes the blocks' place; before `solve`.
  void eliminate(int n_bodies) {
    for (int b = n_bodies - 1; b >= 0; --b) {
      diagonal_[b] = diagonal_[b].inverse().eval();
      if (b == 0) break;
      above_[b - 1] = (above_[b - 1] * diagonal_[b]).eval();
      diagonal_[b - 1] -= above_[b - 1] * below_[b];
    }
  }
  /// The right-hand side becomes the solution.
  void solve(int n_bodies, std::array<Part, max_bodies> &x) const {
    for (int b = n_bodies - 1; b > 0; --b) x[b - 1] -= above_[b - 1] * x[b];
    for (int b = 0; b < n_bodies; ++b) {
      if (b > 0) x[b] -= below_[b] * x[b - 1];
      x[b] = (diagonal_[b] * x[b]).eval();
    }
  }

private:
  std::array<Block, max_bodies> diagonal_, below_, above_;
};

} // namespace rimpact::reduced::rigid
