#include "setups.h"

#include <cmath>

namespace rimpact::verification {

std::function<std::array<double, 3>(std::array<double, 3>)> bumped(double z0) {
  return [z0](std::array<double, 3> x) {
    const double z = x[2] - z0, bump = 0.25 * x[0] * (1 - x[0]) * x[1] * (1 - x[1]) * z * (1 - z);
    return std::array<double, 3>{x[0] + bump, x[1] - bump, x[2] + 2 * bump};
  };
}

Eigen::VectorXd pressed_top(const ContactSystem &system, double pressure) {
  return system.surface_load(Surface::top,
                             [=](const Vector3d &, const Vector3d &normal) { return Vector3d(-pressure * normal); });
}

std::function<double(double)> graded(int n, double first) {
  // Exponential: x(s) = (e^{g s} - 1)/(e^g - 1), g by bisection so that x(1/n) = first.
  double low = 1e-6, high = 30;
  for (int i = 0; i < 100; ++i) {
    const double g = 0.5 * (low + high);
    (std::expm1(g / n) / std::expm1(g) > first ? low : high) = g;
  }
  return [g = low](double s) { return std::expm1(g * s) / std::expm1(g); };
}

meshes::HexMesh quarter_bar(double radius, double bottom, double length, int n, int nz, Surface slave) {
  meshes::HexMesh mesh;
  meshes::Body body(mesh);
  const double square = 0.5 * radius; // side of the inner block, its corner drawn a little outwards
  const auto inner = [=](double s, double t) {
    const double bulge = 1.0 + 0.15 * s * t;
    return std::array<double, 2>{square * s * bulge, square * t * bulge};
  };
  // Outer blocks join the square's far sides to the arc.
  const auto outer = [=](bool first, double s, double t) { // s: outwards, t: along the arc from its axis
    const auto from = first ? inner(1.0, t) : inner(t, 1.0);
    const double angle = first ? t * M_PI / 4 : M_PI / 2 - t * M_PI / 4;
    return std::array<double, 2>{(1 - s) * from[0] + s * radius * std::cos(angle),
                                 (1 - s) * from[1] + s * radius * std::sin(angle)};
  };
  for (int block = 0; block < 3; ++block)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < nz; ++k) {
          const auto place = [&](int a, int b, int c) -> std::array<double, 3> {
            const double s = (i + 0.5 * a) / n, t = (j + 0.5 * b) / n;
            const auto p = block == 0 ? inner(s, t) : block == 1 ? outer(true, s, t) : outer(false, t, s);
            return {p[0], p[1], bottom + length * (k + 0.5 * c) / nz};
          };
          std::map<int, Surface> groups;
          if (k == 0) groups[4] = slave;
          body.add_cell(place, Volume::rim, groups);
        }
  return mesh;
}

double ripple(const std::vector<double> &force, int window, double &mean) {
  const int first = force.size() / 4, last = 3 * force.size() / 4;
  double worst = 0;
  mean = 0;
  for (int k = first; k < last; ++k) {
    double average = 0;
    for (int j = 0; j <= window; ++j) // trapezoid over one element, centred
      average += (j == 0 || j == window ? 0.5 : 1.0) * force[k + j - window / 2] / window;
    worst = std::max(worst, std::abs(force[k] - average));
    mean += force[k] / (last - first);
  }
  return worst / std::abs(mean);
}

double momentum(const ContactSystem &system, const SystemState &state, int component) {
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(state.v.size());
  const auto &equations = system.equations();
  for (std::size_t dof = component; dof < equations.of_dof.size(); dof += 3)
    if (equations.of_dof[dof] >= 0) unit[equations.of_dof[dof]] = 1.0;
  return unit.dot(system.mass_times(state.v));
}

} // namespace rimpact::verification
