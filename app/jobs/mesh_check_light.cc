#include "app/console/child_process.h"
#include "app/jobs/mesh_check.h"

namespace rimpact::app {

MeshCheck check_own_mesh(const scene::Scene &, const planning::Plan &, const Console &console) {
  exec_fe({console.argv + 1, console.argv + console.argc});
}

} // namespace rimpact::app
