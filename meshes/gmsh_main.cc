// rimpact-gmsh: reads one foreign mesh file for rimpact-fe, confined; see mesh_process.h.
#include "meshes/mesh_process.h"

#include <unistd.h>

int main() {
  const int output = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO); // what gmsh prints must not come between
  return rimpact::meshes::serve_mesh(STDIN_FILENO, output);
}
