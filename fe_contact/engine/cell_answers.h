/// What each cell answered when a solution was last evaluated: a cell whose nodes have not moved since answers the
/// same. Most do not where only a few equations moved, or none, because other multipliers are tried.
#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace rimpact::fe {

struct SolidEnergies {
  double elastic = 0.0; ///< [J]
  double plastic = 0.0; ///< plastic work, hardening and viscous part included [J]; a function of the history alone
  double damping = 0.0; ///< lost in the pad as it strains [J]; likewise

  SolidEnergies &operator+=(const SolidEnergies &other) {
    elastic += other.elastic, plastic += other.plastic, damping += other.damping;
    return *this;
  }
};

class CellAnswers {
public:
  /// Of one cell; forces and displacements by direction and node.
  struct Cell {
    std::vector<double> displacements{}, forces{}; ///< [m], [N]; empty: none kept
    SolidEnergies energies{};
    bool has_tangent = false; ///< was made with one
  };

  /// A step begins, from another history.
  void begin() {
    fresh_ = true;
    for (Cell &cell : cells_) cell.displacements.clear();
  }
  /// Whether nothing was assembled since the step began; from then on something is.
  bool take_fresh(std::size_t n_cells) {
    cells_.resize(n_cells);
    return std::exchange(fresh_, false);
  }
  /// Null: not asked with these displacements, or without the tangent that is wanted now.
  const Cell *recall(std::size_t cell, const double *displacements, std::size_t n, bool with_tangent) const {
    const Cell &kept = cells_[cell];
    const bool same = kept.displacements.size() == n &&
                      std::equal(kept.displacements.begin(), kept.displacements.end(), displacements);
    return same && (kept.has_tangent || !with_tangent) ? &kept : nullptr;
  }
  Cell &of(std::size_t cell) { return cells_[cell]; }

private:
  bool fresh_ = true;
  std::vector<Cell> cells_;
};

} // namespace rimpact::fe
