#include "fe_contact/engine/nonlinear_elimination.h"

#include "fe_contact/solver/ranks.h"
#include <algorithm>
#include <Eigen/LU>

namespace rimpact::fe {

struct NonlinearElimination::Block {
  std::vector<int> equations;
  std::vector<std::size_t> cells;
  std::vector<int> place; ///< of each equation of the whole in the block, -1: held
  std::size_t size() const { return equations.size(); }
};

namespace {

struct Moving {
  int dof, place; ///< of the cell; in the block
  double weight;
};

} // namespace

NonlinearElimination::NonlinearElimination(const Solid &solid, const Equations &equations)
    : solid_(solid), equations_(equations), equations_of_cell_(solid.couplings(equations)),
      scratch_(solid.initial_history()) {}

NonlinearElimination::Block NonlinearElimination::block(const Stand &stand) const {
  constexpr std::size_t most_equations = 600;                 // the block's tangent is dense
  constexpr double smallest_share = 0.1, largest_share = 0.5; // of the largest residual: those are the block's cells
  Eigen::VectorXd moving = stand.residual.cwiseAbs();
  for (const int e : stand.held)
    if (e >= 0) moving[e] = 0;
  const double largest = moving.maxCoeff();
  for (double share = smallest_share; share < largest_share; share *= 1.5) {
    Block result{{}, {}, std::vector<int>(equations_.n, -1)};
    const auto heavy = [&](int e) { return e >= 0 && moving[e] > share * largest; };
    for (const auto &cell : equations_of_cell_)
      if (std::ranges::any_of(cell, heavy)) result.equations.insert(result.equations.end(), cell.begin(), cell.end());
    auto &all = result.equations;
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::erase_if(all, [&](int e) { return e < 0 || std::ranges::find(stand.held, e) != stand.held.end(); });
    if (all.size() > most_equations) continue;
    for (std::size_t i = 0; i < all.size(); ++i) result.place[all[i]] = static_cast<int>(i);
    for (std::size_t c = 0; c < equations_of_cell_.size(); ++c)
      if (std::ranges::any_of(equations_of_cell_[c], [&](int e) { return e >= 0 && result.place[e] >= 0; }))
        result.cells.push_back(c);
    return result;
  }
  return {};
}

bool NonlinearElimination::assemble(const Block &block, const Eigen::VectorXd &u, const Stand &stand,
                                    Eigen::VectorXd &forces, Eigen::MatrixXd &stiffness) const {
  const Eigen::VectorXd displacements = equations_.expand(u);
  forces.setZero(block.size());
  stiffness.setZero(block.size(), block.size());
  CellResponse response;
  for (const std::size_t cell : block.cells) {
    if (!solid_.assemble_cell(cell, displacements, stand.old, scratch_, stand.dt, response)) return false;
    const auto &of_dof = equations_of_cell_[cell];
    std::vector<Moving> moving;
    for (std::size_t i = 0; i < of_dof.size(); ++i)
      if (of_dof[i] >= 0 && block.place[of_dof[i]] >= 0)
        moving.push_back({static_cast<int>(i), block.place[of_dof[i]], solid_.weight_of(cell, i, equations_)});
    for (const Moving &a : moving) {
      forces[a.place] += a.weight * response.forces[a.dof];
      for (const Moving &b : moving)
        stiffness(a.place, b.place) += a.weight * b.weight * response.stiffness(a.dof, b.dof);
    }
  }
  return true;
}

bool NonlinearElimination::solve(Eigen::VectorXd &u, const Stand &stand) const {
  constexpr int most_iterations = 4, most_halvings = 3;
  constexpr double enough = 0.02; // of the residual, left in the block
  const Block block = this->block(stand);
  if (block.size() == 0) return false;
  const Eigen::VectorXd start = u(block.equations);
  Eigen::VectorXd residual = stand.residual(block.equations), forces, solid_start;
  Eigen::MatrixXd stiffness;
  if (ranks().any(!assemble(block, u, stand, solid_start, stiffness))) return false;
  const Eigen::VectorXd residual_start = residual;
  const Eigen::MatrixXd others = stand.tangent.block(block.equations) - stiffness;
  const double before = residual.norm();
  double reached = before;
  for (int k = 0; k < most_iterations && reached > enough * before; ++k) {
    const Eigen::VectorXd last = u(block.equations), change = (stiffness + others).partialPivLu().solve(-residual);
    double factor = 1;
    bool falls = false;
    for (int halving = 0; halving <= most_halvings && !falls; ++halving, factor /= 2) {
      u(block.equations) = last + factor * change;
      if (!assemble(block, u, stand, forces, stiffness)) continue;
      residual = residual_start + forces - solid_start + others * (u(block.equations) - start);
      falls = residual.norm() < reached; // false for what is not finite, too
    }
    if (!falls) {
      u(block.equations) = last;
      break;
    }
    reached = residual.norm();
  }
  return reached < before;
}

} // namespace rimpact::fe
