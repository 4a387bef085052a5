/// What the cases share: boxes with graded cells, round bars, and a system with its parts in one place.
#pragma once
#include "../../fe_contact/box_mesh.h"
#include "fe_contact/drive/motion.h"
#include "fe_contact/engine/supports.h"
#include "meshes/section.h"
#include "table.h"

namespace rimpact::verification {

using Eigen::Vector3d;
using fe::ContactSystem;
using fe::SystemState;
using meshes::Surface;
using meshes::Volume;

inline scene::Material elastic(double E, double nu, double density = 1.0) {
  return {E, nu, density, {}, {}};
}

/// A discretised body with its law; `supports` is to be filled before `make`.
struct Setup {
  Setup(const meshes::HexMesh &mesh, const scene::Material &material, int degree = 2)
      : Setup(mesh, {{Volume::rim, material}}, degree) {}
  Setup(const meshes::HexMesh &mesh, const std::map<Volume, scene::Material> &materials, int degree = 2)
      : space(mesh, degree), solid(space, materials), supports(space) {}
  void make() { system.emplace(space, solid, supports.number()); }
  int equation(unsigned node, int component) const { return system->equations().of_dof[3 * node + component]; }

  fe::Discretisation space;
  fe::Solid solid;
  fe::Supports supports;
  std::optional<ContactSystem> system;
};

/// Penalties of `factor` E / h on both directions.
inline fe::SurfaceContactOptions contact_options(double E, double h, double mu, double factor = 1.0, int carrier = -1) {
  fe::SurfaceContactOptions options{{factor * E / h, factor * E / h, fe::FrictionCoefficient::constant(mu)}};
  options.carrier_dof = carrier;
  return options;
}

/// Of a unit cube that stands on z0: inner nodes moved, so that cells are no parallelepipeds; outer faces stay plane.
std::function<std::array<double, 3>(std::array<double, 3>)> bumped(double z0);
/// A uniform pressure [Pa] on the top's reference faces, by equation [N].
Eigen::VectorXd pressed_top(const ContactSystem &system, double pressure);
/// [0, 1] -> [0, 1], the first of n cells being `first` long.
std::function<double(double)> graded(int n, double first);
/// Quarter of a round bar, 0 <= x, y, along z from `bottom`: an O-grid of three blocks of n by n cells, nz
/// layers. Groups: bottom plane `slave`, x = 0 and y = 0 planes are held by position.
meshes::HexMesh quarter_bar(double radius, double bottom, double length, int n, int nz, Surface slave);
/// Largest departure of a series from its average over one period of `window` samples, over the mean of its middle
/// half, which is also given: the ripple of a force as a body crosses elements.
double ripple(const std::vector<double> &force, int window, double &mean);
/// Mass centre's velocity along an axis from momenta [m/s]; mass [kg].
double momentum(const ContactSystem &system, const SystemState &state, int component);

} // namespace rimpact::verification
