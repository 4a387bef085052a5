# Third-party packages, all from Debian 12 or 13 (cmake/install.sh has their names). What differs between versions of
# one is found out here and adapted by one header: reduced_models/motion/sundials.h.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(Threads REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto) # SHA-256; HDF5's own package brings it
find_library(RIMPACT_ZIP zip REQUIRED) # archives of records; the targets of its own package need its programs, too
find_package(Ceres REQUIRED)

# HDF5. deal.II and PETSc are linked to the OpenMPI flavour, and two flavours in one process do not mix: finite elements take that one.
# The reduced side alone takes the serial one where it is, and with it needs no MPI.
add_library(rimpact_hdf5 INTERFACE)
find_library(HDF5_SERIAL hdf5_serial)
find_library(HDF5_HL_SERIAL hdf5_serial_hl)
if(HDF5_SERIAL AND HDF5_HL_SERIAL AND NOT RIMPACT_FE)
  target_include_directories(rimpact_hdf5 SYSTEM INTERFACE /usr/include/hdf5/serial)
  target_link_libraries(rimpact_hdf5 INTERFACE ${HDF5_HL_SERIAL} ${HDF5_SERIAL})
else()
  find_package(MPI REQUIRED COMPONENTS C)
  find_library(HDF5_OPENMPI hdf5_openmpi REQUIRED)
  find_library(HDF5_HL_OPENMPI hdf5_openmpi_hl REQUIRED)
  target_include_directories(rimpact_hdf5 SYSTEM INTERFACE /usr/include/hdf5/openmpi)
  target_link_libraries(rimpact_hdf5 INTERFACE ${HDF5_HL_OPENMPI} ${HDF5_OPENMPI} MPI::MPI_C)
endif()

# SUNDIALS 6 and 7, serial vectors; reduced_models/motion/sundials.h has both under one name.
add_library(rimpact_sundials INTERFACE)
foreach(component cvode nvecserial sunmatrixdense sunlinsoldense)
  find_library(SUNDIALS_${component} sundials_${component} REQUIRED)
  target_link_libraries(rimpact_sundials INTERFACE ${SUNDIALS_${component}})
endforeach()
find_library(SUNDIALS_core sundials_core)
if(SUNDIALS_core) # from 7 on: the base is a library of its own, and headers include MPI's where it was built so
  target_link_libraries(rimpact_sundials INTERFACE ${SUNDIALS_core})
  find_file(SUNDIALS_CONFIG sundials/sundials_config.h REQUIRED)
  file(STRINGS ${SUNDIALS_CONFIG} SUNDIALS_NEEDS_MPI REGEX "define SUNDIALS_MPI_ENABLED 1")
  if(SUNDIALS_NEEDS_MPI)
    find_package(MPI REQUIRED COMPONENTS C)
    target_link_libraries(rimpact_sundials INTERFACE MPI::MPI_C)
  endif()
endif()

if(RIMPACT_FE)
  find_package(deal.II 9.4 REQUIRED)
  find_library(RIMPACT_GMSH gmsh REQUIRED)
  find_library(RIMPACT_SECCOMP seccomp REQUIRED)
  find_library(RIMPACT_PETSC petsc_real REQUIRED)
  find_library(RIMPACT_SMUMPS smumps REQUIRED) # PETSc brings it
  find_library(RIMPACT_DMUMPS dmumps REQUIRED)
  # deal.II's targets without its compiler flags: deal_ii_setup_target() would impose C++17 and -O2 -g.
  add_library(rimpact_dealii INTERFACE)
  list(REMOVE_ITEM DEAL_II_INCLUDE_DIRS /usr/include)
  target_include_directories(rimpact_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
  target_compile_definitions(rimpact_dealii INTERFACE ${DEAL_II_USER_DEFINITIONS}
    $<IF:$<CONFIG:Debug>,${DEAL_II_USER_DEFINITIONS_DEBUG},${DEAL_II_USER_DEFINITIONS_RELEASE}>)
  target_link_libraries(rimpact_dealii INTERFACE
    $<IF:$<CONFIG:Debug>,${DEAL_II_TARGET_DEBUG},${DEAL_II_TARGET_RELEASE}> MPI::MPI_C)
  # inlined deal.II code needs symbols of libraries that deal.II links but does not pass on (TBB, Trilinos)
  target_link_options(rimpact_dealii INTERFACE -Wl,--copy-dt-needed-entries)
  add_library(rimpact_petsc INTERFACE)
  target_include_directories(rimpact_petsc SYSTEM INTERFACE /usr/lib/petscdir/petsc-real/include /usr/include/petsc)
  target_link_libraries(rimpact_petsc INTERFACE ${RIMPACT_PETSC} ${RIMPACT_SMUMPS} ${RIMPACT_DMUMPS} MPI::MPI_C)
endif()
