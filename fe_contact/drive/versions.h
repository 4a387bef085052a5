/// Libraries of the finite-element program.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace rimpact::fe {

/// Versions of deal.II, PETSc, MUMPS, SUNDIALS, gmsh and the BLAS in use, and how many threads BLAS and OpenMP take in
/// this process; second: a warning when the BLAS is not OpenBLAS.
std::vector<std::pair<std::string, std::string>> component_versions();
std::string blas_warning();

} // namespace rimpact::fe
