#include "fe_contact/model/supports.h"

namespace rimpact::fe {

void Supports::fix(meshes::Surface group, int component) {
  for (const unsigned node : space_.nodes_of(group)) of_dof_[3 * node + component] = -1;
}

void Supports::fix(int component, const std::function<bool(const Eigen::Vector3d &)> &where) {
  for (std::size_t node = 0; node < space_.n_nodes; ++node)
    if (where(space_.positions[node])) of_dof_[3 * node + component] = -1;
}

void Supports::fix(meshes::Volume volume) {
  const int n = space_.nodes_per_cell;
  for (std::size_t c = 0; c < space_.n_cells; ++c)
    for (int k = 0; k < 3 * n && space_.volumes[c] == volume; ++k)
      of_dof_[3 * space_.cell_nodes[c * n + k / 3] + k % 3] = -1;
}

int Supports::tie(meshes::Surface group, int component) {
  for (const unsigned node : space_.nodes_of(group)) of_dof_[3 * node + component] = n_;
  return n_++;
}

int Supports::tie(int component, const std::function<bool(const Eigen::Vector3d &)> &where) {
  for (std::size_t node = 0; node < space_.n_nodes; ++node)
    if (where(space_.positions[node])) of_dof_[3 * node + component] = n_;
  return n_++;
}

int Supports::add_body() {
  const int first = static_cast<int>(of_dof_.size());
  of_dof_.insert(of_dof_.end(), 3, unnumbered);
  weight_.insert(weight_.end(), 3, 1.0);
  return first;
}

Equations Supports::number() {
  for (int &equation : of_dof_)
    if (equation == unnumbered) equation = n_++;
  Equations result;
  result.of_dof = of_dof_;
  result.weight = weight_;
  result.n = n_;
  return result;
}

} // namespace rimpact::fe
