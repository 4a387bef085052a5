#include "fe_contact/drive/path_course.h"

#include <algorithm>
#include <memory>

namespace rimpact::fe {

TopTarget beyond_touch(const RimFrame &frame, const reduced::PhysicalModel *dish, double way) {
  const double out = frame.lateral_capacity + way, height = dish ? dish->height(out, 0).z : frame.touch_height;
  RimFrame ahead = frame;
  ahead.direction = 0;
  const Eigen::Vector3d at = ahead.master({out, 0, height});
  return {at.head<2>(), at.z()};
}

PathCourse course_from_touch(const scene::Scene &scene) {
  constexpr int steps_in = 32, steps_out = 64; // unloading is nearly elastic and short: fine steps until the walls part
  const scene::Excitation &e = scene.excitation;
  const auto model = std::make_shared<reduced::PhysicalModel>(scene);
  const double capacity = scene.bearing.lateral_capacity(), travel = e.travel * e.scale, deepest = e.unload ? 0.5 : 1.0;
  const RimFrame frame = RimFrame::of(scene.bearing, e.direction_deg * M_PI / 180, model->height(capacity, 0).z, false);
  const auto phase = [&](double from, double to, int steps) {
    const double per_metre = (to - from) / travel, longest = (to - from) / steps;
    return PathCourse::Phase{to, std::min(first_push_step * per_metre, longest), smallest_push_step * per_metre,
                             longest};
  };
  PathCourse course{{phase(0, deepest, steps_in)}, push_growth, {}, frame, deepest, deepest};
  if (e.unload) course.phases.push_back(phase(deepest, 1, steps_out));
  course.top = [=](double s) {
    const double way = s <= deepest ? travel * s / deepest : travel * (1 - s) / (1 - deepest);
    return beyond_touch(frame, model.get(), way);
  };
  return course;
}

double PathCourse::duration(double s, double ds) const {
  const auto from = instant ? instant(s) : std::nullopt, to = instant ? instant(s + ds) : std::nullopt;
  return from && to ? *to - *from : 0.0;
}

namespace {

/// Of a push: out to the rim, into it, back. Of a path from a file: from turn to turn.
std::vector<PathCourse::Phase> phases_on_dish(const scene::Scene &scene, double cycles) {
  constexpr double steps_a_cycle = 160, longest_slide = 0.025; // [m]
  constexpr double steps_in = 32, steps_back = 32;
  const auto phase = [](double end, double first, double largest) {
    return PathCourse::Phase{end, first, 1e-8 * largest, largest};
  };
  std::vector<double> ends = scene::prescribed_breakpoints(scene.excitation);
  if (scene.excitation.kind != scene::ExcitationKind::push) {
    const double largest = 1 / (steps_a_cycle * cycles);
    std::vector<PathCourse::Phase> result;
    for (const double end : ends) result.push_back(phase(end, 1e-3 * largest, largest));
    result.push_back(phase(1, 1e-3 * largest, largest));
    return result;
  }
  ends.push_back(1);
  const double slide = ends[0] * longest_slide / scene.bearing.lateral_capacity(), in = (ends[1] - ends[0]) / steps_in;
  std::vector<PathCourse::Phase> result{phase(ends[0], 1e-3 * slide, slide), phase(ends[1], 1e-2 * in, in)};
  if (ends.size() > 2) result.push_back(phase(1, 0.1 * (1 - ends[1]) / steps_back, (1 - ends[1]) / steps_back));
  return result;
}

} // namespace

PathCourse course_on_dish(const scene::Scene &scene) {
  const scene::Excitation e = scene.excitation;
  const double capacity = scene.bearing.lateral_capacity(),
               cycles = e.kind == scene::ExcitationKind::figure_eight || !e.stays_on_dish() ? 1.0 : e.rounds();
  const int dishes = scene.bearing.dishes();
  const auto top = [=](double s) { return TopTarget{scene::prescribed_displacement(e, capacity, s) / dishes, {}}; };
  return {.phases = phases_on_dish(scene, cycles),
          .growth = 2,
          .top = top,
          .frame = {},
          .picture = 0.25 / cycles,
          .instant = [=](double s) { return scene::prescribed_instant(e, s); }};
}

} // namespace rimpact::fe
