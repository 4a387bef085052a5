/// Ctrl-C and its like: a run ends with a checkpoint.
#pragma once
#include <atomic>

namespace rimpact::app {

/// SIGHUP too, unless the shell has it ignored (nohup): a closed terminal must not cost a run its last checkpoint.
/// SIGUSR1 is what mpirun passes on to its ranks, and what batch systems send before a job's time is up.
void catch_interrupts();
/// Set by Ctrl-C, SIGTERM, SIGUSR1 and SIGHUP once a verb watches it; a second one ends the process at once.
const std::atomic<bool> &interrupted();
/// From now on Ctrl-C sets the flag only. Until a verb calls it, Ctrl-C ends the process with exit code 130:
/// files are written atomically, so nothing is left half-way.
void watch_interrupts();

} // namespace rimpact::app
