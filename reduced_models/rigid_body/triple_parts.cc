#include "reduced_models/rigid_body/triple_parts.h"
#include "scene/face_friction.h"
#include <cmath>
#include <numbers>

namespace rimpact::reduced::rigid {

namespace {

constexpr char set_names[] = {'B', 'C', 'D', 'A'};

/// Coefficients as the scene gives them, of the faces or of loops.
FaceFriction given_friction(const scene::Scene &scene, double scene::FaceCoefficients::*which) {
  FaceFriction mu{};
  const auto faces = scene::face_coefficients(scene);
  for (std::size_t i = 0; i < mu.size(); ++i) mu[i] = faces[i].*which;
  return mu;
}

/// Pressed against all four rims, the relative turns t_i that cost the rims least under a given travel sum R_eff t_i
/// press each with a_i = R_eff,i / R_i of the bearing's force: in series they have the flexibility sum a_i^2 / k_i.
/// Those without a rim, k_i = 0, are left out.
double flexibility(const std::array<scene::TripleFace, 4> &faces, const std::vector<Joint> &joints,
                   const scene::Scene &scene) {
  double sum = 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (const double k = element_of(scene, joints[i]).k_i; k > 0)
      sum += std::pow(faces[i].effective_radius() / faces[i].radius, 2) / k;
  return sum;
}

/// Dashpots in the proportion of the stiffnesses where the rims have one e: all of them together then return it with
/// the supported mass. By (3-46) each has the bearing's own mass.
void damp_rims(const scene::Scene &scene, const std::array<scene::TripleFace, 4> &faces, Parts &parts) {
  const auto &b = scene.isolator;
  const bool own = b.damped_mass == scene::DampedMass::bearing;
  const double softness = flexibility(faces, parts.joints, scene);
  for (auto &joint : parts.joints)
    joint.rim_mass = own ? b.own_reduced_mass() : scene.load.mass * element_of(scene, joint).k_i * softness;
  parts.stop_stiffness = softness > 0 ? 1 / softness : 0;
}

} // namespace

double moment_factor(const scene::Isolator &b, const scene::TripleFace &face) {
  double moment = 0, load = 0;
  for (const auto &p : point_layout(b, face.half)) {
    const double r = p.norm() / face.radius, across = p[1] / face.radius;
    moment += std::sqrt(1 - r * r) * std::sqrt(1 - across * across), load += 1 - r * r;
  }
  return moment / load;
}

FaceFriction face_friction(const scene::Isolator &b, const FaceFriction &loops) {
  const auto f = scene::triple_faces(b);
  const auto R_eff = [&](int i) { return f[i].effective_radius(); };
  // Moments over the load, by the equilibrium of inner slider and slide plates.
  const FaceFriction moment{loops[0] * (R_eff(0) - R_eff(1)) + loops[1] * R_eff(1), loops[1] * R_eff(1),
                            loops[2] * R_eff(2), loops[3] * (R_eff(3) - R_eff(2)) + loops[2] * R_eff(2)};
  FaceFriction mu;
  for (int i = 0; i < 4; ++i) mu[i] = moment[i] / (f[i].radius * moment_factor(b, f[i]));
  return mu;
}

Parts triple_parts(const scene::Scene &scene, bool slow) {
  const auto &b = scene.isolator;
  const auto faces = scene::triple_faces(b);
  FaceFriction mu_slow = given_friction(scene, &scene::FaceCoefficients::slow),
               mu_fast = slow ? mu_slow : given_friction(scene, &scene::FaceCoefficients::fast);
  if (b.mu_of == scene::FrictionOf::loops) mu_slow = face_friction(b, mu_slow), mu_fast = face_friction(b, mu_fast);
  Parts parts;
  const double D = b.slider_diameter;
  parts.sliders = {{b.slider_mass, D, b.bottom_height - b.inner.bottom_height},
                   {b.inner.mass, b.inner.diameter, b.inner.bottom_height + b.inner.top_height},
                   {b.slider_mass, D, b.top_height - b.inner.top_height}};
  for (int i = 0; i < 4; ++i) {
    const auto &f = faces[i];
    const bool inner = i == 1 || i == 2;
    Joint j{.points_above = i < 2, .radius = f.radius, .effective_radius = f.effective_radius(), .half = f.half};
    j.inner = inner;
    j.wall = f.rim_radius(), j.wall_height = f.rim_height, j.tilt = f.tilt(), j.name = set_names[i];
    j.face = inner ? f.half : scene::contact_radius(scene);
    j.friction = scene::sliding_law(scene, mu_slow[i], mu_fast[i]);
    if (inner) j.friction.table = nullptr, j.friction.area = std::numbers::pi * f.half * f.half;
    parts.joints.push_back(j);
  }
  damp_rims(scene, faces, parts);
  return parts;
}

} // namespace rimpact::reduced::rigid
