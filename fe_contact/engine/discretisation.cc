#include "fe_contact/engine/discretisation.h"

#include "fe_contact/engine/curved_mesh.h"
#include "io/files/error.h"
#include <algorithm>
#include <cmath>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/data_out.h>
#include <fstream>
#include <limits>
#include <utility>

namespace rimpact::fe {
namespace {

using namespace dealii;

void fill(QuadratureData &data, const FESystem<3> &fe, const DoFHandler<3> &dofs, const Mapping<3> &mapping, int n_1d,
          int n, const std::vector<unsigned> &dof_of_node) {
  const QGauss<3> quadrature(n_1d);
  FEValues<3> values(mapping, fe, quadrature, update_gradients | update_JxW_values);
  data.n_points = quadrature.size();
  data.gradients.reserve(dofs.get_triangulation().n_active_cells() * data.n_points * 3 * n);
  for (const auto &cell : dofs.active_cell_iterators()) {
    values.reinit(cell);
    for (int q = 0; q < data.n_points; ++q) {
      data.weights.push_back(values.JxW(q));
      if (!(values.JxW(q) > 0)) throw DataError("mesh: a cell is inverted at a quadrature point");
      for (int d = 0; d < 3; ++d)
        for (int a = 0; a < n; ++a) data.gradients.push_back(values.shape_grad(dof_of_node[a], q)[d]);
    }
  }
}

/// Weights of the values at one point or two of a direction at another place of it.
std::vector<double> line_weights(const std::vector<Point<1>> &points, double x) {
  if (points.size() == 1) return {1.0};
  const double share = (x - points[0][0]) / (points[1][0] - points[0][0]);
  return {1 - share, share};
}

std::vector<double> carried_on(int n_from, int n_to) {
  const QGauss<1> from(n_from);
  const QGauss<3> reduced(n_from), full(n_to);
  std::vector<double> weights;
  for (const auto &x : full.get_points())
    for (unsigned r = 0; r < reduced.size(); ++r) {
      const unsigned place[3] = {r % n_from, r / n_from % n_from, r / n_from / n_from};
      double weight = 1;
      for (int k = 0; k < 3; ++k) weight *= line_weights(from.get_points(), x[k])[place[k]];
      weights.push_back(weight);
    }
  return weights;
}

/// deal.II's writer interpolates, so that one NaN of a cell would be all its points': a number far below every field's
/// goes in instead, and what comes out so becomes NaN.
class OutputWithNone : public DataOut<3> {
public:
  static constexpr double none = -1e6;
  static double in(double value) { return std::isnan(value) ? none : value; }
  void put_none() {
    for (auto &patch : patches)
      for (unsigned i = 0; i < patch.data.size(0); ++i)
        for (unsigned j = 0; j < patch.data.size(1); ++j)
          if (patch.data(i, j) < none / 2) patch.data(i, j) = std::numeric_limits<float>::quiet_NaN();
  }
};

/// Not where the mesh is held or cut: on the others contacts and loads act, by the shapes of their nine nodes.
bool may_be_loaded(meshes::Surface group) {
  using meshes::Surface;
  constexpr std::array others{Surface::fixed, Surface::symmetry, Surface::sector_end};
  return std::find(others.begin(), others.end(), group) == others.end();
}

} // namespace

struct Discretisation::DealII {
  Triangulation<3> triangulation;
  std::unique_ptr<FESystem<3>> fe;
  DoFHandler<3> dof_handler;
  MappingQCache<3> mapping{2};
  std::vector<unsigned> dof_of_node; ///< local x-dof of each local node
  std::vector<Point<3>> unit_points; ///< of the local nodes
};

Discretisation::Discretisation(const meshes::HexMesh &mesh, int degree, const CellChoice &serendipity)
    : degree(degree), nodes_per_cell((degree + 1) * (degree + 1) * (degree + 1)), dealii_(std::make_unique<DealII>()) {
  auto &d = *dealii_;
  make_curved_mesh(mesh, d.triangulation, d.mapping);
  d.fe = std::make_unique<FESystem<3>>(FE_Q<3>(degree), 3);
  d.dof_handler.reinit(d.triangulation);
  d.dof_handler.distribute_dofs(*d.fe);
  n_nodes = d.dof_handler.n_dofs() / 3;
  n_cells = d.triangulation.n_active_cells();
  for (unsigned i = 0; i < d.fe->dofs_per_cell; ++i)
    if (d.fe->system_to_component_index(i).first == 0) {
      d.dof_of_node.push_back(i);
      d.unit_points.push_back(d.fe->unit_support_point(i));
      std::array<int, 3> place;
      for (int k = 0; k < 3; ++k) place[k] = static_cast<int>(std::lround(degree * d.unit_points.back()[k]));
      node_places.push_back(place);
    }
  read_cells();
  fill(full, *d.fe, d.dof_handler, d.mapping, degree + 1, nodes_per_cell, d.dof_of_node);
  fill(reduced, *d.fe, d.dof_handler, d.mapping, degree, nodes_per_cell, d.dof_of_node);
  const QGauss<3> quadrature(degree + 1);
  for (const auto &point : quadrature.get_points())
    for (int a = 0; a < nodes_per_cell; ++a) full_values.push_back(d.fe->shape_value(d.dof_of_node[a], point));
  reduced_to_full = carried_on(degree, degree + 1);
  read_faces();
  is_interpolated.assign(n_nodes, 0);
  if (serendipity && degree == 2) leave_middles_out(serendipity(*this));
}

void Discretisation::read_cells() {
  const auto &d = *dealii_;
  positions.resize(n_nodes);
  std::vector<types::global_dof_index> indices(d.fe->dofs_per_cell);
  for (const auto &cell : d.dof_handler.active_cell_iterators()) {
    cell->get_dof_indices(indices);
    volumes.push_back(static_cast<meshes::Volume>(cell->material_id()));
    for (int a = 0; a < nodes_per_cell; ++a) {
      const unsigned i = d.dof_of_node[a], node = indices[i] / 3;
      AssertThrow(indices[i] % 3 == 0 && indices[i + 1] == indices[i] + 1, ExcInternalError());
      cell_nodes.push_back(node);
      const Point<3> p = d.mapping.transform_unit_to_real_cell(cell, d.unit_points[a]);
      positions[node] = {p[0], p[1], p[2]};
    }
  }
}

void Discretisation::read_faces() {
  const auto &d = *dealii_;
  // A face's nodes: the cell's with one fixed unit coordinate, sorted by the other two.
  for (const auto &cell : d.dof_handler.active_cell_iterators())
    for (unsigned f = 0; f < 6; ++f) {
      if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() == 0) continue;
      const int fixed = f / 2, first = (fixed + 1) % 3, second = (fixed + 2) % 3;
      Face face{static_cast<meshes::Surface>(cell->face(f)->boundary_id()),
                cell->active_cell_index(),
                {},
                f % 2 ? 1.0 : -1.0};
      std::vector<std::pair<std::pair<double, double>, unsigned>> sorted;
      for (int a = 0; a < nodes_per_cell; ++a)
        if (std::abs(d.unit_points[a][fixed] - (f % 2)) < 1e-12)
          sorted.push_back({{d.unit_points[a][second], d.unit_points[a][first]},
                            cell_nodes[cell->active_cell_index() * nodes_per_cell + a]});
      std::sort(sorted.begin(), sorted.end());
      for (const auto &entry : sorted) face.nodes.push_back(entry.second);
      faces.push_back(face);
    }
}

SerendipityShapes Discretisation::shapes_of(std::size_t cell) const {
  std::array<bool, 27> left_out;
  for (int a = 0; a < 27; ++a) left_out[a] = is_interpolated[cell_nodes[27 * cell + a]];
  return {node_places, left_out};
}

std::vector<double> Discretisation::displacement_values(std::size_t cell) const {
  std::vector<double> values = full_values;
  if (degree != 2) return values;
  const SerendipityShapes shapes = shapes_of(cell);
  for (int q = 0; q < full.n_points; ++q) shapes.apply(&values[std::size_t(27) * q]);
  return values;
}

bool Discretisation::keeps_a_face(std::size_t cell) const {
  for (int a = 0; a < 27; ++a)
    if (middles_of(node_places[a]) == 2 && !is_interpolated[cell_nodes[27 * cell + a]]) return true;
  return false;
}

/// A cell that turns as it is has no strain only where the geometry, too, is what the nodes around a middle make of it.
void Discretisation::keep_middles_off_their_edges() {
  constexpr double allowed = 1e-3; // of the cell's size
  std::array<bool, 27> middles;
  for (int a = 0; a < 27; ++a) middles[a] = middles_of(node_places[a]) >= 2;
  const SerendipityShapes shapes(node_places, middles);
  for (std::size_t c = 0; c < n_cells; ++c) {
    const unsigned *nodes = &cell_nodes[27 * c];
    double size = 0;
    for (int a = 0; a < 27; ++a) size = std::max(size, (positions[nodes[a]] - positions[nodes[0]]).norm());
    for (int a = 0; a < 27; ++a) {
      if (!is_interpolated[nodes[a]]) continue;
      Eigen::Vector3d off = positions[nodes[a]];
      for (const auto &[other, weight] : shapes.weights(a)) off -= weight * positions[nodes[other]];
      if (off.norm() > allowed * size) is_interpolated[nodes[a]] = 0;
    }
  }
}

void Discretisation::leave_middles_out(const std::vector<char> &serendipity) {
  for (std::size_t c = 0; c < n_cells; ++c)
    for (int a = 0; a < 27; ++a)
      if (serendipity[c] && middles_of(node_places[a]) >= 2) is_interpolated[cell_nodes[27 * c + a]] = 1;
  for (std::size_t c = 0; c < n_cells; ++c)
    for (int a = 0; a < 27 && !serendipity[c]; ++a) is_interpolated[cell_nodes[27 * c + a]] = 0;
  for (const Face &face : faces)
    if (may_be_loaded(face.group)) is_interpolated[face.nodes[4]] = 0;
  keep_middles_off_their_edges();
  for (std::size_t c = 0; c < n_cells; ++c)
    if (keeps_a_face(c))
      for (int a = 0; a < 27; ++a)
        if (middles_of(node_places[a]) == 3) is_interpolated[cell_nodes[27 * c + a]] = 0;
  std::vector<char> done(n_nodes, 0);
  for (std::size_t c = 0; c < n_cells; ++c) {
    const SerendipityShapes shapes = shapes_of(c);
    if (!shapes.any()) continue;
    const unsigned *nodes = &cell_nodes[27 * c];
    for (int a = 0; a < 27; ++a) {
      if (!is_interpolated[nodes[a]] || std::exchange(done[nodes[a]], 1)) continue;
      interpolated.push_back({nodes[a], {}});
      for (const auto &[other, weight] : shapes.weights(a)) interpolated.back().from.emplace_back(nodes[other], weight);
    }
    for (QuadratureData *data : {&full, &reduced})
      for (int row = 0; row < 3 * data->n_points; ++row)
        shapes.apply(&data->gradients[27 * (3 * data->n_points * c + row)]);
  }
}

Discretisation::~Discretisation() = default;

std::vector<const Face *> Discretisation::faces_of(meshes::Surface group) const {
  std::vector<const Face *> result;
  for (const auto &face : faces)
    if (face.group == group) result.push_back(&face);
  return result;
}

std::vector<unsigned> Discretisation::nodes_of(meshes::Surface group) const {
  std::vector<unsigned> result;
  for (const auto *face : faces_of(group)) result.insert(result.end(), face->nodes.begin(), face->nodes.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void Discretisation::write_vtu(const std::string &path, const std::vector<Field> &fields) const {
  const auto &d = *dealii_;
  using Interpretation = DataComponentInterpretation::DataComponentInterpretation;
  OutputWithNone out;
  out.attach_triangulation(d.triangulation);
  const FE_Q<3> scalar_fe(degree);
  DoFHandler<3> scalar(d.triangulation);
  scalar.distribute_dofs(scalar_fe);
  std::vector<types::global_dof_index> scalar_indices(scalar_fe.dofs_per_cell);
  std::vector<Vector<double>> kept;
  kept.reserve(fields.size());
  for (const auto &field : fields) {
    if (field.per_cell) {
      kept.emplace_back(field.values.begin(), field.values.end());
      out.add_data_vector(kept.back(), field.name, DataOut<3>::type_cell_data);
    } else if (field.components == 3) {
      kept.emplace_back(field.values.begin(), field.values.end());
      out.add_data_vector(d.dof_handler, kept.back(), std::vector<std::string>(3, field.name),
                          std::vector<Interpretation>(3, DataComponentInterpretation::component_is_part_of_vector));
    } else {
      kept.emplace_back(n_nodes);
      for (const auto &cell : scalar.active_cell_iterators()) {
        cell->get_dof_indices(scalar_indices);
        for (int a = 0; a < nodes_per_cell; ++a)
          kept.back()(scalar_indices[a]) =
              OutputWithNone::in(field.values[cell_nodes[cell->active_cell_index() * nodes_per_cell + a]]);
      }
      out.add_data_vector(scalar, kept.back(), field.name);
    }
  }
  DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = true; // as curved as they are
  out.set_flags(flags);
  out.build_patches(d.mapping, degree, DataOut<3>::curved_inner_cells);
  out.put_none();
  std::ofstream file(path);
  out.write_vtu(file);
  if (!file) throw IoError("cannot write " + path);
}

} // namespace rimpact::fe
