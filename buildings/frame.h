/// A frame of beam-columns, rigid diaphragms, supports: linear in space, or inelastic in the plane of x and z. SI
/// units, z upwards.
#pragma once
#include "buildings/axial_bending.h"
#include "io/files/choice.h"
#include "io/files/error.h"
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace rimpact::buildings {

enum class FramePart { node, element, diaphragm };
constexpr auto choices(FramePart) {
  using enum FramePart;
  return choices_of<FramePart>({{node, "node"}, {element, "element"}, {diaphragm, "diaphragm"}});
}

/// What is wrong with one part of a frame; says its number, from 1.
class FrameFault : public InputError {
public:
  FrameFault(FramePart part, std::size_t index, const std::string &what) : InputError(what), part(part), index(index) {}
  FramePart part;
  std::size_t index; ///< from 0
};

struct Node {
  Eigen::Vector3d at;       ///< [m]
  double vertical_mass = 0; ///< tributary, moves up and down with the node [kg], >= 0
  bool supported = false;   ///< a bearing stands under it
  std::string bearing = {}; ///< its name or file; empty: the scene's
};

/// Whether the moment of a member's end knows its axial force.
enum class Interaction { none, stress_block };
constexpr auto choices(Interaction) {
  using enum Interaction;
  return choices_of<Interaction>(
      {{none, "none"}, {stress_block, "stress-block", "of concrete with two layers of steel"}});
}

/// What makes a member inelastic in the plane of x and z (plane_beam_column.h); wear as DegradingBoucWen.
struct InelasticSection {
  double yield_moment = 0, axial_yield = 0;            ///< of the end sections [N m], along the member [N], > 0
  Interaction interaction = Interaction::none;         ///< with one, yield_moment is that without an axial force
  double depth = 0;                                    ///< of the section in the plane [m], > 0; read by an interaction
  double hinge_length = 0.25;                          ///< of an end section [m], > 0, at most a sixth of the member
  double post_yield = 0.02;                            ///< [-], 0..1
  double exponent = 2, beta = 0.5;                     ///< [-], >= 1, 0.5..1
  double strength_loss = 0.004, stiffness_loss = 0.01; ///< a unit of normalised lost energy [-], 0..1, 0..2
  bool operator==(const InelasticSection &) const = default;
};

/// The diagram of a section that has one: crushed at its axial yield force.
inline AxialBending interaction_of(const InelasticSection &s) {
  return {.crush = s.axial_yield, .plain = s.yield_moment, .depth = s.depth};
}

/// Elastic properties of a member's section, local axes of Element.
struct Section {
  std::string name;
  double E, G;                     ///< [Pa], > 0
  double area;                     ///< [m^2]
  double Iy, Iz;                   ///< bending with displacements along local z, along local y [m^4]
  double torsion;                  ///< Saint-Venant constant [m^4]
  double shear_y = 0, shear_z = 0; ///< shear areas [m^2] (Timoshenko); 0: rigid in shear (Euler-Bernoulli)
  std::optional<InelasticSection> inelastic = {};
};
/// A solid rectangle, `y` and `z` its sides along the local axes [m]; shear areas 5/6 of it.
Section rectangle(const std::string &name, double y, double z, double E, double nu);

/// Local x runs from node i to j, local z lies in the plane of x and `up`, local y = z cross x.
struct Element {
  int i, j, section;
  Eigen::Vector3d up;
  /// Weight along it, which bends an inelastic member; as a weight it stands at the nodes [N/m]
  double load = 0;
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
  std::vector<std::string> assumed;  ///< "key = value" of an inelastic frame's numbers that no one has given
  bool inelastic() const;            ///< of its members one is; then all must be, in the plane y = 0
  /// Throws InputError naming node, element or diaphragm and what is wrong with it.
  void validate() const;
};

} // namespace rimpact::buildings
