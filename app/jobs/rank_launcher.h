/// `rimpact run`, with or without --ranks N: several ranks under mpirun, which hear what one process would.
///
/// mpirun kills its ranks a second after a Ctrl-C or a SIGTERM, too soon for a checkpoint; but it passes SIGUSR1 on. So
/// it runs in a process group of its own, and SIGINT, SIGTERM and SIGHUP reach the ranks as SIGUSR1: they end their
/// step, leave a checkpoint and exit with 130. A second signal ends them at once, and so does SIGKILL.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace rimpact::app {

/// Takes `--ranks N` (or --ranks=N) out of the words of a command; none: it is not there. Throws InputError for
/// anything but 1 up to the machine's processors, and under mpirun.
std::optional<int> take_ranks(std::vector<std::string> &words);

/// Ranks of a run whose words name none. Two, where the scene asks for mesh 1 or finer and two processors may be used
/// by it: $RIMPACT_THREADS says that they are shared out already, and where the address space has a limit one process
/// keeps it. Else one; also where the words are no run's, which rimpact-fe will say.
int usual_ranks(const std::vector<std::string> &words);

/// Runs `program words...` on so many ranks and returns their exit code. Throws IoError where mpirun is not installed.
int run_on_ranks(int n_ranks, const std::string &program, const std::vector<std::string> &words);

} // namespace rimpact::app
