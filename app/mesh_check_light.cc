#include "app/mesh_check.h"
#include "app/sibling.h"

namespace rimpact::app {

MeshCheck check_own_mesh(const scene::Scene &, const planning::Plan &, const Console &console) {
  become_fe({console.argv + 1, console.argv + console.argc});
}

} // namespace rimpact::app
