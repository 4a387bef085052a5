/// gmsh is a process-wide singleton: one session an owner, quiet. Private to the meshes that use it.
#pragma once
#include <gmsh.h>

namespace rimpact::meshes {

struct GmshSession {
  GmshSession() {
    gmsh::initialize(0, nullptr,
                     false); // without ~/.gmshrc and ~/.gmsh-options: preferences of a user would change the meshes
    gmsh::option::setNumber("General.Terminal", 0);
  }
  ~GmshSession() { gmsh::finalize(); }
  GmshSession(const GmshSession &) = delete;
};

} // namespace rimpact::meshes
