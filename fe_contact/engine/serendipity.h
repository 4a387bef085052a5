/// Serendipity cells: hexahedra with the shapes of 20 nodes (Zienkiewicz and Taylor 2000, volume 1, section 8.7), made
/// of cells with 27. The nodes in the middles of their faces and of themselves have no displacement of their own, but
/// the one that the shapes of 20 nodes have there.
///
/// A face keeps its middle where its other cell has 27 nodes, and where contacts or loads may act on it; a cell keeps
/// its own where one of its faces does. So neighbours of both kinds fit together, and what serendipity cells can do is
/// a part of what cells of 27 nodes can do.
#pragma once
#include <array>
#include <utility>
#include <vector>

namespace rimpact::fe {

/// Places of a cell's local nodes along its axes: 0, 1 or 2.
using NodePlaces = std::vector<std::array<int, 3>>;

/// Along how many axes a node lies in the middle: 0 corner, 1 edge, 2 face, 3 cell.
int middles_of(const std::array<int, 3> &place);

/// Of one cell of 27 nodes: shapes with values at the left-out nodes become those that are left.
class SerendipityShapes {
public:
  /// `left_out`: of the local nodes; all of them middles.
  SerendipityShapes(const NodePlaces &places, const std::array<bool, 27> &left_out);
  bool any() const { return !steps_.empty(); }
  /// Values or derivatives of the 27 shapes at a point: those of left-out nodes go to the others and become nil.
  void apply(double *shapes) const;
  /// What a left-out node takes of the local nodes that are left.
  std::vector<std::pair<int, double>> weights(int left_out) const;

private:
  struct Step {
    int from;
    std::vector<std::pair<int, double>> to;
  };
  std::vector<Step> steps_; ///< the cell's middle first: it gives to the middles of faces
};

} // namespace rimpact::fe
