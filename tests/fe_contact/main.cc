// GoogleTest's main with PETSc started, which the direct solver needs, and without what this machine remembers of its
// runs.
#include "fe_contact/drive/mpi_start.h"
#include "io/files/library_threads.h"
#include <cstdlib>
#include <gtest/gtest.h>
#include <petscsys.h>

int main(int argc, char **argv) {
  rimpact::begin_with_one_library_thread(argv); // as rimpact-fe does
  rimpact::fe::start_mpi_alone_unless_launched();
  setenv("XDG_CACHE_HOME", "/nowhere", 1); // a plan's seconds are then those of the tables
  testing::InitGoogleTest(&argc, argv);
  PetscInitialize(nullptr, nullptr, nullptr, nullptr);
  const int result = RUN_ALL_TESTS();
  PetscFinalize();
  return result;
}
