/// Where a quasi-static path leads the top face, in phases of the load parameter s from 0 to 1.
#pragma once
#include "fe_contact/drive/top_drive.h"
#include "fe_contact/rungs/rim_frame.h"
#include "reduced_models/bearings/physical_model.h"
#include "scene/scene.h"
#include <functional>

namespace rimpact::fe {

/// Steps of travel of a push onto the rim from touch [m].
inline constexpr double first_push_step = 1e-5;    ///< the first contact wants a small one
inline constexpr double smallest_push_step = 1e-8; ///< below it the push stops
inline constexpr double push_growth = 1.6;         ///< of the next step, at most

/// Where the top face is when what is carried has gone a way on from first touch, along the dish, or, without one, at
/// the height of first touch [m].
TopTarget beyond_touch(const RimFrame &frame, const reduced::PhysicalModel *dish, double way);

struct PathCourse {
  struct Phase {
    double end, first, smallest, largest; ///< of the load parameter
  };
  std::vector<Phase> phases;
  double growth;                          ///< of the next step
  std::function<TopTarget(double s)> top; ///< of the model's top face or middle, in its frame
  std::optional<RimFrame> frame;          ///< of the model, where it is not the plate's
  double parts_from = 2;                  ///< from here on the path ends where the walls part
  double picture;                         ///< fields are written so often
  /// Of the load parameter [s]; empty, or none: friction is that of slow motion, steel without rate.
  std::function<std::optional<double>(double s)> instant{};
  double duration(double s, double ds) const; ///< of a step [s]; 0 without an instant
};
/// Rung rim: from first touch beyond it and back, the height following the dish.
PathCourse course_from_touch(const scene::Scene &scene);
/// On the dish, from rest on the vertex: cycles, a figure of eight, a file's path; out to the rim, into it, back.
PathCourse course_on_dish(const scene::Scene &scene);

} // namespace rimpact::fe
