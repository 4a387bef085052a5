# Compiler settings shared by every target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# Assertions of Eigen and deal.II speak in debug builds, in none of the release: an inline function has one form in a
# program. What input can break is checked by code that throws.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

option(RIMPACT_UNITY "Compile a module's sources in batches: a whole build takes half the time" OFF)
set(CMAKE_UNITY_BUILD ${RIMPACT_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 40)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(rimpact_settings INTERFACE)
target_include_directories(rimpact_settings INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(rimpact_settings INTERFACE -Wall -Wextra -Wpedantic -Wno-psabi -fno-math-errno)
# What GCC says of its own AVX-512 intrinsics (bug 105593), from 13 on of Eigen's small vectors and of std::vector::insert too,
# is not so.
target_compile_options(rimpact_settings INTERFACE -Wno-maybe-uninitialized
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds;-Wno-stringop-overflow>")
# One alignment for every unit: Debian's Ceres and deal.II are compiled for plain x86-64.
target_compile_definitions(rimpact_settings INTERFACE EIGEN_MAX_ALIGN_BYTES=16)
# gmsh and Ceres carry Eigen's functions for plain x86-64 under the same weak names: ours, sized for this machine and allocating
# otherwise, must not be exported to them. Here those of the libraries, in CMakeLists.txt those of the programs' own sources.
target_link_options(rimpact_settings INTERFACE -Wl,--exclude-libs,ALL)
if(RIMPACT_NATIVE)
  target_compile_options(rimpact_settings INTERFACE -march=native)
endif()

set(RIMPACT_SANITIZE "" CACHE STRING "Sanitizers, e.g. address,undefined")
if(RIMPACT_SANITIZE)
  add_compile_options(-fsanitize=${RIMPACT_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${RIMPACT_SANITIZE})
endif()
