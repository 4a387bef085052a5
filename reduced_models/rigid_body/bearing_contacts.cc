#include "reduced_models/rigid_body/bearing_contacts.h"
#include "scene/spherical_cap.h"

namespace rimpact::reduced::rigid {

using Eigen::Vector2d;

namespace {

/// Which body carries the points of a joint, which the sphere or plane, and where their faces are in their frames.
struct Sides {
  int body, master;
  double face, master_face, up; ///< up: +1 where the sphere opens upwards
};

Sides sides_of(const Parts &parts, int joint) {
  const int low = joint == 0 ? ground : joint - 1;
  if (parts.joints[joint].points_above) return {joint, low, parts.face_below(joint), parts.face_above(low), 1};
  return {low, joint, parts.face_above(low), parts.face_below(joint), -1};
}

Contact point(const Parts &parts, int joint, const Vector2d &at) {
  const Joint &j = parts.joints[joint];
  const Sides s = sides_of(parts, joint);
  const double curved = j.surface == Surface::dish ? scene::cap_height(j.radius, at.norm()) : 0;
  return {.surface = j.surface,
          .body = s.body,
          .master = s.master,
          .point = {at[0], at[1], s.face + s.up * curved},
          .centre = {0, 0, s.master_face + s.up * j.radius},
          .radius = j.radius,
          .set = joint};
}

Contact rim(const Parts &parts, int joint, const Vector2d &at, double reach) {
  const Joint &j = parts.joints[joint];
  const Sides s = sides_of(parts, joint);
  return {.surface = Surface::rim,
          .body = s.body,
          .master = s.master,
          .point = {at[0], at[1], s.face + s.up * scene::cap_height(j.radius, j.half)},
          .centre = {0, 0, s.master_face + s.up * scene::cap_height(j.radius, j.wall)},
          .radius = j.wall,
          .reach = reach,
          .wall_height = j.wall_height,
          .upward = s.up,
          .set = joint};
}

Contact stop(const Parts &parts, int joint) {
  const Joint &j = parts.joints[joint];
  const Sides s = sides_of(parts, joint);
  return {.surface = Surface::stop,
          .body = s.body,
          .master = s.master,
          .point = {0, 0, s.face},
          .centre = {0, 0, s.master_face},
          .radius = j.wall,
          .reach = j.half,
          .wall_height = j.wall_height,
          .set = joint};
}

/// Where edges may meet rims, in half diameters: both ends in the plane; in space the whole edge, or its points.
std::vector<Vector2d> places(const scene::Isolator &b) {
  if (b.space == scene::Space::planar) return {{-1, 0}, {1, 0}};
  if (b.rim == scene::RimTouch::circle) return {{0, 0}};
  return point_layout(b, 1);
}

} // namespace

std::vector<Contact> contacts_of(const Parts &parts, const scene::Isolator &b) {
  std::vector<Contact> contacts;
  const int n = static_cast<int>(parts.joints.size());
  const bool circle = b.space == scene::Space::spatial && b.rim == scene::RimTouch::circle;
  for (int j = 0; j < n; ++j)
    for (const auto &at : point_layout(b, parts.joints[j].half)) contacts.push_back(point(parts, j, at));
  for (const auto &place : places(b))
    for (int j = 0; j < n; ++j)
      if (const double half = parts.joints[j].half; parts.joints[j].surface == Surface::dish)
        contacts.push_back(rim(parts, j, half * place, circle ? half : 0));
  for (int j = 0; j < n; ++j)
    if (parts.joints[j].surface == Surface::interface) contacts.push_back(stop(parts, j));
  return contacts;
}

} // namespace rimpact::reduced::rigid
