#include "fe_contact/engine/solid.h"

#include "fe_contact/engine/solid_kernel.h"
#include "fe_contact/engine/threads.h"
#include "fe_contact/solver/ranks.h"
#include <algorithm>
#include <stdexcept>

namespace rimpact::fe {
namespace {

/// The system's matrix is symmetric: Newton's rate bears the rest.
void make_symmetric(Matrix6 &tangent) {
  tangent = (0.5 * (tangent + tangent.transpose())).eval();
}

} // namespace

Vector6 SolidLaw::stress_at_rest(const HenckyJ2 &resting, const J2State &state, const Matrix3 &F) const {
  return resting.step(loss.none() ? state : J2State{}, F, 0, false).response.stress;
}

Solid::Solid(const Discretisation &space, const scene::Bearing &bearing, double pad_retardation)
    : Solid(space, {{meshes::Volume::plate, bearing.steel_of(scene::SteelPart::dish)},
                    {meshes::Volume::rim, bearing.rim_steel()},
                    {meshes::Volume::foot, bearing.steel_of(scene::SteelPart::slider)},
                    {meshes::Volume::upper_slider, bearing.steel_of(scene::SteelPart::slider)},
                    {meshes::Volume::pad, bearing.ertalyte}}) {
  laws_.at(meshes::Volume::pad).loss = {pad_retardation};
}

Solid::Solid(const Discretisation &space, const std::map<meshes::Volume, scene::Material> &materials)
    : space_(space), kept_(space.n_cells) {
  for (const auto &[volume, material] : materials)
    laws_.emplace(volume, SolidLaw{HenckyJ2::from(material), HenckyVolumetric::from(material),
                                   CrackMeasure(material.fracture), material.density});
}

std::vector<int> Solid::equations_of(std::size_t cell, const Equations &equations) const {
  std::vector<int> result;
  for (int a = 0; a < space_.nodes_per_cell; ++a)
    for (int i = 0; i < 3; ++i)
      result.push_back(equations.of_dof[3 * space_.cell_nodes[cell * space_.nodes_per_cell + a] + i]);
  return result;
}

Couplings Solid::couplings(const Equations &equations) const {
  Couplings result;
  for (std::size_t c = 0; c < space_.n_cells; ++c) result.push_back(equations_of(c, equations));
  return result;
}

Couplings Solid::own_couplings(const Equations &equations) const {
  Couplings result;
  for (const unsigned c : own_cells(equations)) result.push_back(equations_of(c, equations));
  return result;
}

std::vector<unsigned> Solid::own_cells(const Equations &equations) const {
  const std::vector<unsigned> cells = moving_cells(equations);
  const std::vector<std::size_t> offsets = ranks().offsets(cells.size());
  return {cells.begin() + offsets[ranks().own], cells.begin() + offsets[ranks().own + 1]};
}

std::vector<unsigned> Solid::moving_cells(const Equations &equations) const {
  std::vector<unsigned> result;
  const int n = space_.nodes_per_cell;
  for (std::size_t c = 0; c < space_.n_cells; ++c)
    for (int k = 0; k < 3 * n; ++k)
      if (equations.of_dof[3 * space_.cell_nodes[c * n + k / 3] + k % 3] >= 0) {
        result.push_back(c);
        break;
      }
  return result;
}

const std::vector<int> &Solid::places_in(const SymmetricMatrix &matrix, const Equations &equations) const {
  if (places_of_ == matrix.pattern_id()) return places_;
  const std::size_t m = 3 * space_.nodes_per_cell, pairs = m * (m + 1) / 2;
  places_.assign(space_.n_cells * pairs, -1); // of what is held, and of other ranks' cells
  plain_.assign(space_.n_cells, 0);
  for (const unsigned c : own_cells(equations)) {
    const std::vector<int> own = equations_of(c, equations);
    std::size_t place = c * pairs;
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = i; j < m; ++j, ++place)
        if (own[i] >= 0 && own[j] >= 0) {
          places_[place] = matrix.find(std::min(own[i], own[j]), std::max(own[i], own[j]));
          if (places_[place] < 0) throw std::logic_error("a cell's entry outside the sparsity pattern");
        }
    std::vector<int> of_shapes;
    for (std::size_t dof = 0; dof < m; ++dof)
      if (!space_.is_interpolated[space_.cell_nodes[c * space_.nodes_per_cell + dof / 3]])
        of_shapes.push_back(own[dof]);
    std::sort(of_shapes.begin(), of_shapes.end());
    plain_[c] = of_shapes.front() >= 0 && std::adjacent_find(of_shapes.begin(), of_shapes.end()) == of_shapes.end();
    for (std::size_t dof = 0; dof < m; ++dof) plain_[c] = plain_[c] && weight_of(c, dof, equations) == 1;
  }
  places_of_ = matrix.pattern_id();
  return places_;
}

void Solid::remember(std::size_t c, const SolidHistory &old, SolidHistory &next, const double *mises,
                     const double *mean) const {
  const int n_points = space_.full.n_points, n_reduced = space_.reduced.n_points;
  const CrackMeasure &crack = law_of(c).crack;
  for (int q = 0; q < n_points; ++q) {
    const J2State &before = old[c * n_points + q];
    J2State &now = next[c * n_points + q];
    const double flow = now.alpha - before.alpha;
    if (!(flow > 0)) continue;
    double at_point = 0;
    for (int r = 0; r < n_reduced; ++r) at_point += space_.reduced_to_full[q * n_reduced + r] * mean[r];
    const double triaxiality = at_point / mises[q];
    now.triaxiality += triaxiality * flow;
    now.damage += flow / crack.fracture_strain(triaxiality);
    now.locus_damage += flow / crack.locus_strain(triaxiality);
  }
}

double Solid::work_beside_the_curve(std::size_t c, const SolidHistory &history) const {
  double sum = 0;
  for (std::size_t point = c * space_.full.n_points; point < (c + 1) * space_.full.n_points; ++point)
    sum += space_.full.weights[point] * (history[point].viscous_work + history[point].back_work);
  return sum;
}

template <int n>
Solid::Answer Solid::answer(std::size_t c, const std::array<Matrix3, n> &F, const SolidHistory &old, SolidHistory &next,
                            double dt, CellKernel<n> &kernel, bool with_tangent) const {
  Answer result;
  const SolidLaw &law = law_of(c);
  const int n_reduced = space_.reduced.n_points, m = 3 * n;
  std::array<double, n> mises, mean; // the reduced points are fewer
  kernel.clear(with_tangent);
  for (int q = 0; q < n; ++q) {
    const std::size_t point = c * n + q;
    const double weight = space_.full.weights[point];
    IsochoricResult isochoric = law.step(old[point], F[q], dt, with_tangent);
    if (!isochoric.admissible) return result;
    next[point] = isochoric.state;
    // The tangent of a dashpot changes with the step's length: it is made anew as that of steel that flows.
    result.flows = result.flows || isochoric.state.alpha > old[point].alpha || !law.loss.none();
    mises[q] = isochoric.mises;
    result.energies.elastic += weight * isochoric.energy;
    result.energies.plastic += weight * law.isochoric.hardening.work(isochoric.state.alpha);
    if (with_tangent && !law.isochoric.backstress.none()) make_symmetric(isochoric.response.tangent);
    kernel.add(&space_.full.gradients[point * m], F[q], weight, isochoric.response, with_tangent);
  }
  for (int q = 0; q < n_reduced; ++q) {
    const std::size_t point = c * n_reduced + q;
    const double *G = &space_.reduced.gradients[point * m], weight = space_.reduced.weights[point];
    const Matrix3 at_point = kernel.deformation_gradient(G);
    const VolumetricResult volumetric = law.volumetric.at(at_point.determinant());
    if (!volumetric.admissible) return result;
    mean[q] = volumetric.response.stress[0];
    result.energies.elastic += weight * volumetric.energy;
    kernel.add(G, at_point, weight, volumetric.response, with_tangent);
  }
  kernel.finish();
  if (!law.loss.none())
    result.energies.damping += work_beside_the_curve(c, next);
  else if (!law.isochoric.follows_its_curve())
    result.energies.plastic += work_beside_the_curve(c, next);
  if (result.flows) remember(c, old, next, mises.data(), mean.data());
  result.admissible = true;
  return result;
}

template <int n> void Solid::set_displacements(std::size_t c, const Eigen::VectorXd &u, CellKernel<n> &kernel) const {
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i) kernel.u[i][a] = u[3 * space_.cell_nodes[c * n + a] + i];
}

template <int n> std::array<Matrix3, n> Solid::deformation_gradients(std::size_t c, const CellKernel<n> &kernel) const {
  std::array<Matrix3, n> F;
  for (int q = 0; q < n; ++q) F[q] = kernel.deformation_gradient(&space_.full.gradients[(c * n + q) * 3 * n]);
  return F;
}

template <int n>
bool Solid::assemble_one(std::size_t c, const Eigen::VectorXd &u, const SolidHistory &old, SolidHistory &next,
                         double dt, CellResponse &response) const {
  auto kernel = std::make_unique<CellKernel<n>>();
  set_displacements<n>(c, u, *kernel);
  if (!answer<n>(c, deformation_gradients<n>(c, *kernel), old, next, dt, *kernel, true).admissible) return false;
  response.forces.resize(3 * n);
  response.stiffness.resize(3 * n, 3 * n);
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < 3; ++i) {
      response.forces[3 * a + i] = kernel->force[i][a];
      for (int b = a; b < n; ++b)
        for (int k = 0; k < 3; ++k)
          response.stiffness(3 * a + i, 3 * b + k) = response.stiffness(3 * b + k, 3 * a + i) =
              kernel->block[i][k][a][b];
    }
  return true;
}

bool Solid::assemble_cell(std::size_t cell, const Eigen::VectorXd &u, const SolidHistory &old, SolidHistory &next,
                          double dt, CellResponse &response) const {
  return space_.degree == 2 ? assemble_one<27>(cell, u, old, next, dt, response)
                            : assemble_one<8>(cell, u, old, next, dt, response);
}

template <int n>
const CellAnswers::Cell *Solid::recall_or_make(std::size_t c, const SolidHistory &old, SolidHistory &next, double dt,
                                               CellKernel<n> &kernel, bool with_tangent, CellAnswers &answers) const {
  constexpr int m = 3 * n;
  if (const auto *kept = answers.recall(c, &kernel.u[0][0], m, with_tangent))
    if (!with_tangent || kept_.has(c)) return kept;
  const std::array<Matrix3, n> F = deformation_gradients<n>(c, kernel);
  bool anew = with_tangent && !kept_.serves(c, F);
  Answer made = answer<n>(c, F, old, next, dt, kernel, anew);
  if (with_tangent && !anew && made.admissible && made.flows) {
    anew = true;
    made = answer<n>(c, F, old, next, dt, kernel, true);
  }
  CellAnswers::Cell &cell = answers.of(c);
  cell.displacements.clear();
  if (!made.admissible) return nullptr;
  if (anew) kept_.keep(c, F, made.flows, kernel);
  cell.displacements.assign(&kernel.u[0][0], &kernel.u[0][0] + m);
  cell.forces.resize(m);
  for (int i = 0; i < 3; ++i) std::copy_n(kernel.force[i], n, cell.forces.data() + i * n);
  cell.energies = made.energies;
  cell.has_tangent = with_tangent;
  return &cell;
}

template <int n>
bool Solid::assemble_cells(const unsigned *begin, const unsigned *end, const Eigen::VectorXd &u,
                           const SolidHistory &old, SolidHistory &next, double dt, const Equations &equations,
                           Eigen::VectorXd &forces, const std::vector<int> *places, double *tangent,
                           SolidEnergies &energies, CellAnswers &answers) const {
  constexpr int m = 3 * n;
  auto kernel = std::make_unique<CellKernel<n>>();
  SolidEnergies sum; // not yet where other threads write beside it
  for (const unsigned *cell = begin; cell < end; ++cell) {
    const std::size_t c = *cell;
    set_displacements<n>(c, u, *kernel);
    const CellAnswers::Cell *made = recall_or_make<n>(c, old, next, dt, *kernel, tangent != nullptr, answers);
    if (!made) return false;
    sum += made->energies;
    double weights[m];
    int eqs[m];
    for (int k = 0; k < m; ++k) {
      const unsigned dof = 3 * space_.cell_nodes[c * n + k / 3] + k % 3;
      eqs[k] = equations.of_dof[dof];
      weights[k] = equations.weight[dof];
      if (eqs[k] >= 0) forces[eqs[k]] += weights[k] * made->forces[k % 3 * n + k / 3];
    }
    if (!tangent) continue;
    const double *value = kept_.block(c);
    const int *place = places->data() + c * (m * (m + 1) / 2);
    if (plain_[c]) {
      for (int k = 0; k < m * (m + 1) / 2; ++k)
        if (place[k] >= 0) tangent[place[k]] += value[k];
      continue;
    }
    for (int row = 0; row < m; ++row)
      for (int column = row; column < m; ++column, ++place, ++value) {
        if (*place < 0) continue;
        const double twice = row != column && eqs[row] == eqs[column] ? 2.0 : 1.0; // tied dofs share a diagonal
        tangent[*place] += twice * weights[row] * weights[column] * *value;
      }
  }
  energies = sum;
  return true;
}

bool Solid::assemble(const Eigen::VectorXd &u, const SolidHistory &old, SolidHistory &next, const Equations &equations,
                     Eigen::VectorXd &forces, SymmetricMatrix *tangent, SolidEnergies &energies, double dt,
                     CellAnswers *answers) const {
  const int workers = assembly_threads();
  const std::vector<int> *places = tangent ? &places_in(*tangent, equations) : nullptr;
  CellAnswers none;
  CellAnswers &known = answers ? *answers : none;
  if (known.take_fresh(space_.n_cells)) next = old; // cells that do not move keep theirs
  const std::vector<unsigned> own = own_cells(equations);
  std::vector<Eigen::VectorXd> part_forces(workers, Eigen::VectorXd::Zero(equations.n));
  part_values_.resize(workers);
  std::vector<SolidEnergies> part_energies(workers);
  std::vector<char> admissible(workers, 1);
  share(own.size(), workers, [&](std::size_t begin, std::size_t end, int w) {
    double *values = nullptr;
    if (tangent && w == 0) values = tangent->values().data();
    if (tangent && w > 0) {
      part_values_[w].assign(tangent->n_entries(), 0.0);
      values = part_values_[w].data();
    }
    const auto run = space_.degree == 2 ? &Solid::assemble_cells<27> : &Solid::assemble_cells<8>;
    admissible[w] = (this->*run)(own.data() + begin, own.data() + end, u, old, next, dt, equations, part_forces[w],
                                 places, values, part_energies[w], known);
  });
  if (ranks().any(std::find(admissible.begin(), admissible.end(), 0) != admissible.end())) return false;
  Eigen::VectorXd summed = Eigen::VectorXd::Zero(equations.n + 3); // forces, energies
  for (int w = 0; w < workers; ++w) {
    summed.head(equations.n) += part_forces[w];
    summed.tail<3>() += Eigen::Vector3d(part_energies[w].elastic, part_energies[w].plastic, part_energies[w].damping);
  }
  if (tangent)
    share(tangent->n_entries(), workers, [&](std::size_t begin, std::size_t end, int) {
      for (int w = 1; w < workers; ++w)
        for (std::size_t k = begin; k < end; ++k) tangent->values()[k] += part_values_[w][k];
    });
  ranks().all_reduce_sum(summed);
  forces += summed.head(equations.n);
  energies.elastic += summed[equations.n];
  energies.plastic += summed[equations.n + 1];
  energies.damping += summed[equations.n + 2];
  return true;
}

void Solid::all_gather(SolidHistory &history, const Equations &equations) const {
  if (ranks().size == 1) return;
  const std::vector<unsigned> cells = moving_cells(equations);
  const std::vector<std::size_t> offsets = ranks().offsets(cells.size());
  std::vector<std::size_t> points{0}; // of each rank's cells, and of those at rest between them
  for (int r = 1; r < ranks().size; ++r)
    points.push_back((offsets[r] < cells.size() ? cells[offsets[r]] : space_.n_cells) * space_.full.n_points);
  points.push_back(history.size());
  ranks().all_gather(history, points);
}

SymmetricMatrix Solid::mass(const Equations &equations) const {
  return mass(moving_cells(equations), equations);
}

SymmetricMatrix Solid::own_mass(const Equations &equations) const {
  return mass(own_cells(equations), equations);
}

SymmetricMatrix Solid::mass(std::span<const unsigned> cells, const Equations &equations) const {
  const int n = space_.nodes_per_cell, n_points = space_.full.n_points;
  const auto dof = [&](std::size_t c, int a, int i) { return 3 * space_.cell_nodes[c * n + a] + i; };
  Couplings couplings; // one a cell and direction
  for (const std::size_t c : cells)
    for (int i = 0; i < 3; ++i) {
      couplings.emplace_back();
      for (int a = 0; a < n; ++a) couplings.back().push_back(equations.of_dof[dof(c, a, i)]);
    }
  SymmetricMatrix result(equations.n, couplings);
  for (const std::size_t c : cells) {
    const double density = law_of(c).density;
    const std::vector<double> N = space_.displacement_values(c);
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b) {
        double value = 0.0;
        for (int q = 0; q < n_points; ++q)
          value += density * space_.full.weights[c * n_points + q] * N[q * n + a] * N[q * n + b];
        for (int i = 0; i < 3; ++i) {
          const unsigned row = dof(c, a, i), column = dof(c, b, i);
          const int eq_row = equations.of_dof[row], eq_column = equations.of_dof[column];
          if (eq_row < 0 || eq_column < 0) continue;
          const double twice = a != b && eq_row == eq_column ? 2.0 : 1.0;
          result.add(eq_row, eq_column, twice * equations.weight[row] * equations.weight[column] * value);
        }
      }
  }
  return result;
}

double Solid::mass_of(meshes::Volume volume) const {
  double mass = 0.0;
  for (std::size_t c = 0; c < space_.n_cells; ++c)
    for (int q = 0; q < space_.full.n_points && space_.volumes[c] == volume; ++q)
      mass += law_of(c).density * space_.full.weights[c * space_.full.n_points + q];
  return mass;
}

} // namespace rimpact::fe
