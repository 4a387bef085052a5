// Time of one assembly (forces, tangent, history) of quadratic J2 cells beside the tangent's error against
// differences of the forces, everything plastic: `bench_fe_contact`.
#include "../../fe_contact/box_mesh.h"
#include "fe_contact/engine/solid.h"
#include "fe_contact/engine/supports.h"
#include "fe_contact/engine/threads.h"
#include <algorithm>
#include <benchmark/benchmark.h>
#include <random>

using namespace rimpact;

namespace {

/// range(0): cells a side; range(1): degree.
void assembly(benchmark::State &state) {
  const int n = state.range(0);
  meshes::HexMesh mesh;
  test::add_box(mesh, {{0, 0, 0}, {1, 1, 1}, {n, n, n}, meshes::Volume::rim, {}});
  const fe::Discretisation space(mesh, state.range(1));
  const fe::Solid solid(space, {{meshes::Volume::rim, scene::Material{200e9, 0.3, 7850, 235e6, 2e9}}});
  fe::Supports supports(space);
  const fe::Equations equations = supports.number();
  fe::SymmetricMatrix tangent(equations.n, solid.couplings(equations));
  // One per cent of stretch, well past yield, and a little noise.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  Eigen::VectorXd u(equations.n), direction(equations.n);
  for (std::size_t a = 0; a < space.n_nodes; ++a)
    u.segment<3>(3 * a) = 0.01 * Eigen::Vector3d(-0.5, -0.5, 1).cwiseProduct(space.positions[a]);
  for (int i = 0; i < equations.n; ++i) {
    u[i] += 1e-4 / n * unit(random);
    direction[i] = unit(random);
  }
  const fe::SolidHistory old = solid.initial_history();
  fe::SolidHistory next;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(equations.n);
  while (state.KeepRunning()) {
    fe::SolidEnergies energies;
    forces.setZero();
    tangent.set_zero();
    if (!solid.assemble(u, old, next, equations, forces, &tangent, energies)) state.SkipWithError("inverted cell");
  }
  const auto at = [&](double step) {
    fe::SolidEnergies energies;
    Eigen::VectorXd result = Eigen::VectorXd::Zero(equations.n);
    solid.assemble(u + step * direction, old, next, equations, result, nullptr, energies);
    return result;
  };
  const double h = 1e-7 / n;
  const Eigen::VectorXd difference = (at(h) - at(-h)) / (2 * h);
  state.counters["tangent_error"] = (tangent.multiply(direction) - difference).norm() / difference.norm();
  state.counters["dofs"] = equations.n;
  state.counters["threads"] = fe::assembly_threads();
  state.counters["plastic_share"] =
      static_cast<double>(std::count_if(next.begin(), next.end(), [](const auto &p) { return p.alpha > 0; })) /
      next.size();
}

} // namespace

BENCHMARK(assembly)->Args({6, 2})->Args({12, 2})->Args({25, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_MAIN();
