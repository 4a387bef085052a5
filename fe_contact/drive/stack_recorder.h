/// What a run of the stack writes: a row of signals an instant, pictures' data now and then.
#pragma once
#include "fe_contact/drive/run_record.h"
#include "fe_contact/rungs/stack.h"

namespace rimpact::fe {

/// Forces of the bearing on what it carries, whole bearing [N]; the stack's own inertia is left out.
struct StackForces {
  Eigen::Vector3d dish = Eigen::Vector3d::Zero(), friction = Eigen::Vector3d::Zero(), rim = Eigen::Vector3d::Zero();
  Eigen::Vector3d total() const { return dish + rim; }
};
StackForces forces_of(const StackModel &model, const SystemState &state);

class StackRecorder {
public:
  StackRecorder(const scene::Scene &scene, const StackModel &model, RunRecord &record)
      : scene_(scene), model_(model), record_(record) {}

  /// u of the top face from rest on the vertex, its velocity v; with the record's ledger as it stands.
  void sample(double time, const Eigen::Vector3d &u, const Eigen::Vector3d &v, const SystemState &state, int iterations,
              double step);

private:
  const scene::Scene &scene_;
  const StackModel &model_;
  RunRecord &record_;
};

} // namespace rimpact::fe
