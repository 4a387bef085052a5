#include "fe_contact/engine/serendipity.h"

namespace rimpact::fe {
namespace {

/// The cell's middle of a field without the bubble of 27 nodes: faces, edges and corners around it.
double weight_in_cell(int middles) {
  constexpr std::array of_corner_edge_face{1.0 / 8, -1.0 / 4, 1.0 / 2};
  return of_corner_edge_face[middles];
}

/// A face's middle of a field without its bubble: edges and corners around it.
double weight_in_face(int middles) {
  constexpr std::array of_corner_edge{-1.0 / 4, 1.0 / 2};
  return of_corner_edge[middles];
}

bool on_face_of(const std::array<int, 3> &face_middle, const std::array<int, 3> &place) {
  for (int i = 0; i < 3; ++i)
    if (face_middle[i] != 1 && place[i] != face_middle[i]) return false;
  return place != face_middle;
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
        if (const int middles = middles_of(places[b]); kind == 3 && b != a)
          step.to.emplace_back(b, weight_in_cell(middles));
        else if (kind == 2 && on_face_of(places[a], places[b]))
          step.to.emplace_back(b, weight_in_face(middles));
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
