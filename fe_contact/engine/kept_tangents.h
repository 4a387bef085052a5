/// Tangents of cells that hardly deform: a cell that moves, or strains elastically by less than `as_before`, keeps the
/// one it was last made for. Newton's residuals stay exact; its rate bears an error of that size, which is large where
/// a body is slender: a solution that takes its time makes them all anew. Cells that flow get a new one every time.
#pragma once
#include "fe_contact/engine/solid_kernel.h"
#include <array>
#include <vector>

namespace rimpact::fe {

class KeptTangents {
public:
  static constexpr double as_before = 1e-3; ///< largest change of a component of the deformation gradient [-]

  explicit KeptTangents(std::size_t n_cells) : cells_(n_cells) {}
  void forget() {
    for (Cell &cell : cells_) cell.block.clear(); // its memory stays: solutions that take their time come here often
  }
  bool has(std::size_t cell) const { return !cells_[cell].block.empty(); }
  /// Whether the cell's tangent serves at these deformation gradients, one a point.
  template <std::size_t n> bool serves(std::size_t cell, const std::array<Matrix3, n> &F) const {
    const Cell &kept = cells_[cell];
    if (kept.block.empty() || kept.flows) return false;
    for (std::size_t q = 0; q < n; ++q)
      if ((F[q] - kept.F[q]).cwiseAbs().maxCoeff() > as_before) return false;
    return true;
  }
  template <int nodes, std::size_t n>
  void keep(std::size_t cell, const std::array<Matrix3, n> &F, bool flows, const CellKernel<nodes> &made) {
    Cell &kept = cells_[cell];
    kept.F.assign(F.begin(), F.end());
    kept.flows = flows;
    kept.block.resize(3 * nodes * (3 * nodes + 1) / 2);
    double *value = kept.block.data();
    for (int a = 0; a < nodes; ++a)
      for (int i = 0; i < 3; ++i)
        for (int b = a; b < nodes; ++b)
          for (int k = b == a ? i : 0; k < 3; ++k) *value++ = made.block[i][k][a][b];
  }
  /// Upper triangle by rows, of the cell's dofs [N/m].
  const double *block(std::size_t cell) const { return cells_[cell].block.data(); }

private:
  struct Cell {
    std::vector<Matrix3> F{};
    std::vector<double> block{};
    bool flows = false;
  };
  std::vector<Cell> cells_;
};

} // namespace rimpact::fe
