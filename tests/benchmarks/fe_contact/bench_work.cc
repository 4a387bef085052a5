// What one Newton iteration of a bearing at its rim costs, counted: the same on every machine. `bench_work [MESH...]`,
// alone or under mpirun; the seconds beside the counts are this machine's. Of several ranks the busiest one's share
// is what the others wait for. The error is the residual that GMRES leaves in double precision. `of sgemm`: what an
// operation of the factor costs in operations of a plain dense product on one thread here: 9 for the smallest factor, 3
// for a large one. Far above, the factor is held up (threads that spin, a slow BLAS).
#include "fe_contact/drive/mpi_start.h"
#include "fe_contact/rungs/bearing_model.h"
#include "fe_contact/rungs/full.h"
#include "fe_contact/rungs/rigid_dish.h"
#include "fe_contact/rungs/rim.h"
#include "fe_contact/solver/ranks.h"
#include "fe_contact/solver/sgemm.h"
#include "fe_contact/solver/stopwatch.h"
#include "io/files/library_threads.h"
#include <algorithm>
#include <fmt/core.h>
#include <petscsys.h>
#include <stdexcept>
#include <string>
#include <vector>

using namespace rimpact;

namespace {

constexpr auto head =
    "rung       mesh ranks unknowns  cells  matrix M  busiest  factor M  busiest    Gflop  busiest GMRES assemb s "
    "factor s  solve s    error of sgemm";
constexpr double overlap = 5e-4; ///< of slider and rim [m]
constexpr double dt = 2e-4;      ///< a step in contact [s]
constexpr double mass = 80e3;    ///< [kg]

/// The slider at the rim, a little into it.
fe::SystemState at_the_rim(fe::BearingSystem &system) {
  const scene::Bearing &bearing = system.model().bearing;
  fe::SystemState state = system.at_rest();
  Eigen::Vector3d top = Eigen::Vector3d::Zero();
  if (system.model().rung.dish != fe::DishKind::law)
    top << bearing.lateral_capacity(), 0, scene::lift(bearing, bearing.lateral_capacity());
  top.x() += system.wall_gap(state, top) + overlap;
  system.set_position(state, top, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  system.start_afresh_at(state);
  return state;
}

double largest(double value) {
  Eigen::VectorXd one = Eigen::VectorXd::Constant(1, value);
  fe::ranks().all_reduce_max(one);
  return one[0];
}

/// Of an operation of a dense product in single precision [s]; the best of three, each of some tenths of a second.
double dense_operation() {
  const int n = 1500;
  const float one = 1, none = 0;
  const std::vector<float> a(n * n, 1), b(n * n, 0.5f);
  std::vector<float> c(n * n);
  double best = 1e300;
  for (int i = 0; i < 3; ++i) {
    double seconds = 0;
    {
      const fe::Stopwatch watch(seconds);
      sgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &none, c.data(), &n);
    }
    best = std::min(best, seconds);
  }
  return best / (2.0 * n * n * n);
}

void measure(const fe::Rung &rung, const std::string &name, int mesh, double dense) {
  const fe::BearingModel model(rung, scene::Bearing{}, {.level = mesh, .rim = true});
  fe::BearingSystem system(model, mass);
  const fe::SystemState state = at_the_rim(system);
  fe::StepTerms terms{Eigen::VectorXd::Zero(system.equations().n)};
  const fe::Inertia inertia(fe::GeneralizedAlpha::from(0.5), dt, state);
  terms.dt = dt;
  terms.inertia = &inertia;
  system.prepare(state, terms);
  constexpr double relative = 1e-8;
  constexpr int most = 50;
  double assembly = 0, factor = 0, solve = 0;
  const auto go = [&] {
    {
      const fe::Stopwatch watch(assembly = 0);
      system.evaluate(state.u, true);
    }
    {
      const fe::Stopwatch watch(factor = 0);
      system.solver().solve_anew(system.residual(), relative, most);
    }
    const fe::Stopwatch watch(solve = 0);
    return system.solver().solve(system.residual(), relative, most).size() > 0;
  };
  go(); // grows the pattern where it must, orders the equations
  system.solid().forget_tangents();
  if (!go()) throw std::runtime_error("GMRES does not get there");
  factor -= solve; // which it does as well
  const fe::FactorWork own = system.solver().factor_work();
  const auto both = [](double value) {
    return fmt::format(" {:9.3f} {:8.3f}", fe::ranks().all_reduce_sum(value), largest(value));
  };
  const std::string counts = both(1e-6 * own.handed_in) + both(1e-6 * own.entries) + both(1e-9 * own.operations);
  if (fe::ranks().first())
    fmt::print("{:10} {:4} {:5} {:8} {:6} {} {:5} {:8.3f} {:8.3f} {:8.3f} {:8.0e} {:8.1f}\n", name, mesh,
               fe::ranks().size, system.equations().n, model.space.n_cells, counts, system.solver().last_iterations(),
               assembly, factor, solve, relative, factor / (own.operations * dense));
}

} // namespace

int main(int argc, char **argv) {
  begin_with_one_library_thread(argv); // as rimpact-fe does
  fe::start_mpi_alone_unless_launched();
  PetscInitialize(nullptr, nullptr, nullptr, nullptr);
  std::vector<int> meshes;
  for (int i = 1; i < argc; ++i) meshes.push_back(std::stoi(argv[i]));
  if (meshes.empty()) meshes = {0, 1};
  if (fe::ranks().first()) fmt::print("{}\n", head);
  const double dense = dense_operation();
  for (const auto &[rung, name] :
       {std::pair{&fe::rungs::rim, "rim"}, {&fe::rungs::rigid_dish, "rigid-dish"}, {&fe::rungs::full, "full"}})
    for (const int mesh : meshes) measure(*rung, name, mesh, dense);
  PetscFinalize();
}
