// Names of the libraries in use, the BLAS first of all.
#include "fe_contact/drive/versions.h"

#include <deal.II/base/config.h>
#include <dlfcn.h>
#include <dmumps_c.h>
#include <gmsh.h>
#include <petscversion.h>
#include <sundials/sundials_config.h>

namespace rimpact::fe {
namespace {

/// What answers dgemm_ in this process: OpenBLAS tells its configuration, others only their file.
std::string blas_name() {
  if (void *config = dlsym(RTLD_DEFAULT, "openblas_get_config")) return reinterpret_cast<const char *(*)()>(config)();
  Dl_info info;
  if (void *gemm = dlsym(RTLD_DEFAULT, "dgemm_"))
    if (dladdr(gemm, &info) && info.dli_fname) return info.dli_fname;
  return "unknown";
}

/// What a library of this process says of its own threads by that function.
std::string threads_by(const char *function) {
  void *ask = dlsym(RTLD_DEFAULT, function);
  return ask ? std::to_string(reinterpret_cast<int (*)()>(ask)()) : "unknown";
}

} // namespace

std::vector<std::pair<std::string, std::string>> component_versions() {
  const auto dotted = [](int a, int b, int c) {
    return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
  };
  return {{"deal.II", DEAL_II_PACKAGE_VERSION},
          {"PETSc", dotted(PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR)},
          {"MUMPS", MUMPS_VERSION},
          {"SUNDIALS", SUNDIALS_VERSION},
          {"gmsh", dotted(GMSH_API_VERSION_MAJOR, GMSH_API_VERSION_MINOR, GMSH_API_VERSION_PATCH)},
          {"BLAS", blas_name()},
          {"BLAS threads", threads_by("openblas_get_num_threads")},
          {"OpenMP threads", threads_by("omp_get_max_threads")}};
}

std::string blas_warning() {
  const std::string name = blas_name();
  if (name.find("OpenBLAS") != std::string::npos || name.find("openblas") != std::string::npos) return {};
  return "the BLAS in use is " + name +
         ", not OpenBLAS: factorisations take 10 to 20 times longer; "
         "install libopenblas0-pthread and select it with update-alternatives --config "
         "libblas.so.3-x86_64-linux-gnu";
}

} // namespace rimpact::fe
