/// How MPI starts in a process of its own.
#pragma once

namespace rimpact::fe {

/// First thing in main: a process that mpirun did not start asks for no daemon, no network and no folder under /tmp.
/// Open MPI 4 shares that folder between all runs of a user and removes it under the feet of a run that begins.
void start_mpi_alone_unless_launched();

} // namespace rimpact::fe
