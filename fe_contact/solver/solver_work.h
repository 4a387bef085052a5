/// What solutions cost, counted: the same on every machine.
#pragma once

namespace rimpact::fe {

struct SolverWork {
  long iterations = 0;        ///< of Newton
  long backtracks = 0;        ///< evaluations beyond one an iteration
  long eliminations = 0;      ///< of a few equations, solved by themselves
  long linear_iterations = 0; ///< of GMRES
  long factorisations = 0;
  long augmentations = 0; ///< of the multipliers
  long cuts = 0;          ///< steps that were solved, or tried to be, and not taken

  SolverWork &operator+=(const SolverWork &other) {
    iterations += other.iterations;
    backtracks += other.backtracks;
    eliminations += other.eliminations;
    linear_iterations += other.linear_iterations;
    factorisations += other.factorisations;
    augmentations += other.augmentations;
    cuts += other.cuts;
    return *this;
  }
};

} // namespace rimpact::fe
