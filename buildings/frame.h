/// A linear frame in space: nodes, elastic beam-columns, rigid diaphragms, supports. SI units, z upwards.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace rimpact::buildings {

struct Node {
  Eigen::Vector3d at;       ///< [m]
  double vertical_mass = 0; ///< tributary, moves up and down with the node [kg], >= 0
  bool supported = false;   ///< a bearing stands under it
  std::string bearing = {}; ///< its name or file; empty: the scene's
};

/// Elastic properties of a member's section, local axes of Element.
struct Section {
  std::string name;
  double E, G;                     ///< [Pa], > 0
  double area;                     ///< [m^2]
  double Iy, Iz;                   ///< bending with displacements along local z, along local y [m^4]
  double torsion;                  ///< Saint-Venant constant [m^4]
  double shear_y = 0, shear_z = 0; ///< shear areas [m^2] (Timoshenko); 0: rigid in shear (Euler-Bernoulli)
};
/// A solid rectangle, `y` and `z` its sides along the local axes [m]; shear areas 5/6 of it.
Section rectangle(const std::string &name, double y, double z, double E, double nu);

/// Local x runs from node i to j, local z lies in the plane of x and `up`, local y = z cross x.
struct Element {
  int i, j, section;
  Eigen::Vector3d up;
};
/// Rows: the local axes x, y, z of a member from `from` to `to`.
Eigen::Matrix3d local_axes(const Eigen::Vector3d &from, const Eigen::Vector3d &to, const Eigen::Vector3d &up);

/// Nodes that move in the plane as one body.
struct Diaphragm {
  std::vector<int> nodes;
  double mass;            ///< [kg], > 0
  Eigen::Vector2d centre; ///< of mass [m]; off the nodes' middle: eccentric
  double inertia;         ///< about the vertical through `centre` [kg m^2], > 0
};

struct Frame {
  std::string name;
  std::vector<Node> nodes;
  std::vector<Section> sections;
  std::vector<Element> elements;
  std::vector<Diaphragm> diaphragms; ///< the base first, then from below upwards
  double damping_ratio = 0.02;       ///< of every mode of the building with its base held [-], 0..1
  /// Throws InputError naming node, element or diaphragm and what is wrong with it.
  void validate() const;
};

} // namespace rimpact::buildings
