// The finite-element executable: run, mesh, version. Starts PETSc (and MPI) once.
#include "app/verb.h"

#include <petscsys.h>

int main(int argc, char **argv) {
  // PETSc would take options of its own from the command line: give it none.
  int none = 1;
  char *name[] = {argv[0], nullptr}, **names = name;
  if (PetscInitialize(&none, &names, nullptr, nullptr)) return 1;
  PetscPopSignalHandler();
  const int code = rimpact::app::run_command(argc, argv,
                                             {{"run", rimpact::app::add_run},
                                              {"mesh", rimpact::app::add_mesh},
                                              {"version", rimpact::app::add_version}});
  PetscFinalize();
  return code;
}
