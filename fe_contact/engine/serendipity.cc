#include "fe_contact/engine/serendipity.h"

namespace rimpact::fe {
namespace {

/// What the middle of a face or of a cell takes of a node around it, by middles_of() of both, where the field has no
/// bubble there.
double weight(int of_middle, int of_node) {
  constexpr std::array in_face{-1.0 / 4, 1.0 / 2};
  constexpr std::array in_cell{1.0 / 8, -1.0 / 4, 1.0 / 2};
  return of_middle == 2 ? in_face.at(of_node) : in_cell.at(of_node);
}

/// Whether a node is on the face of that middle, or in the cell of that one.
bool is_around(const std::array<int, 3> &middle, const std::array<int, 3> &place) {
  for (int i = 0; i < 3; ++i)
    if (middle[i] != 1 && place[i] != middle[i]) return false;
  return place != middle;
}

} // namespace

int middles_of(const std::array<int, 3> &place) {
  return (place[0] == 1) + (place[1] == 1) + (place[2] == 1);
}

SerendipityShapes::SerendipityShapes(const NodePlaces &places, const std::array<bool, 27> &left_out) {
  for (const int kind : {3, 2})
    for (int a = 0; a < 27; ++a) {
      if (!left_out[a] || middles_of(places[a]) != kind) continue;
      Step step{a, {}};
      for (int b = 0; b < 27; ++b)
        if (is_around(places[a], places[b])) step.to.emplace_back(b, weight(kind, middles_of(places[b])));
      steps_.push_back(std::move(step));
    }
}

void SerendipityShapes::apply(double *shapes) const {
  for (const Step &step : steps_) {
    for (const auto &[to, weight] : step.to) shapes[to] += weight * shapes[step.from];
    shapes[step.from] = 0;
  }
}

std::vector<std::pair<int, double>> SerendipityShapes::weights(int left_out) const {
  std::array<double, 27> shapes{};
  shapes[left_out] = 1;
  apply(shapes.data());
  std::vector<std::pair<int, double>> result;
  for (int a = 0; a < 27; ++a)
    if (shapes[a] != 0) result.emplace_back(a, shapes[a]);
  return result;
}

} // namespace rimpact::fe
