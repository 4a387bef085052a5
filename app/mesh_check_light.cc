#include "app/mesh_check.h"
#include "app/sibling.h"

namespace rimpact::app {

MeshCheck check_own_mesh(const scene::Scene &, const planning::Plan &, const Console &console) {
  become_fe(console.argc, console.argv);
}

} // namespace rimpact::app
