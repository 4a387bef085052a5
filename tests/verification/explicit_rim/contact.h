/// Contact of two faces by penalty, in two passes: the nodes of each against the quadrilaterals of the other, each pass
/// with half the pressure. mm, N, MPa, s.
#pragma once
#include "solid.h"

namespace explicit_rim {

using Faces = std::vector<std::array<int, 4>>; ///< corners, counter-clockwise seen from outside the body

struct ContactOptions {
  double stiffness; ///< pressure per penetration [MPa/mm]
  double friction;  ///< Coulomb's [-], regularised below `creep`
  double creep = 1; ///< [mm/s]
  double reach = 3; ///< a node deeper than this has lost its face [mm]
};

class Contact {
public:
  Contact(Faces one, Faces other, const std::vector<Vec3> &x, const ContactOptions &options);
  /// Adds the forces; returns the sum on the nodes of `one`.
  Vec3 push(const std::vector<Vec3> &x, const std::vector<Vec3> &v, std::vector<Vec3> &force);

private:
  struct Pass {
    std::vector<int> nodes;
    std::vector<double> area; ///< of each node, at the start [mm^2]
    Faces faces;
    std::vector<std::vector<int>> near; ///< of each node, faces sorted by distance
  };
  void search(Pass &pass, const std::vector<Vec3> &x) const;
  Vec3 one_pass(const Pass &pass, const std::vector<Vec3> &x, const std::vector<Vec3> &v,
                std::vector<Vec3> &force) const;

  ContactOptions options_;
  std::array<Pass, 2> passes_;
  int calls_ = 0;
};

} // namespace explicit_rim
