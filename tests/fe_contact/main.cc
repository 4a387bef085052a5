// GoogleTest's main with PETSc started: the direct solver needs it.
#include <gtest/gtest.h>
#include <petscsys.h>

int main(int argc, char **argv) {
  testing::InitGoogleTest(&argc, argv);
  PetscInitialize(nullptr, nullptr, nullptr, nullptr);
  const int result = RUN_ALL_TESTS();
  PetscFinalize();
  return result;
}
