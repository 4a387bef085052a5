// The finite-element executable: run, mesh, curve, version, and check of a scene with a mesh of its own. Starts PETSc
// (and MPI) once; under mpirun the first rank speaks.
#include "app/console/command.h"
#include "app/verbs/catalogue.h"
#include "fe_contact/drive/mpi_start.h"
#include "fe_contact/drive/run.h"
#include "io/files/library_threads.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <petscsys.h>
#include <sys/prctl.h>
#include <thread>

namespace {

/// A failure all ranks share ends each of them alike; one that struck this rank alone must end the others too, which
/// would wait for it for ever.
void leave_together(MPI_Comm comm, int code) {
  constexpr auto patience = std::chrono::seconds(10);
  MPI_Request request;
  MPI_Ibarrier(comm, &request);
  int all_here = 0;
  for (const auto start = std::chrono::steady_clock::now(); std::chrono::steady_clock::now() - start < patience;) {
    MPI_Test(&request, &all_here, MPI_STATUS_IGNORE);
    if (all_here) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  MPI_Abort(MPI_COMM_WORLD, code);
}

constexpr const rimpact::app::Verb *verbs[] = {&rimpact::app::run_verb,        &rimpact::app::check_verb,
                                               &rimpact::app::mesh_verb,       &rimpact::app::curve_verb,
                                               &rimpact::app::completion_verb, &rimpact::app::version_verb};

} // namespace

int main(int argc, char **argv) {
  rimpact::begin_with_one_library_thread(argv);
  rimpact::fe::start_mpi_alone_unless_launched();
  // PETSc would take options of its own from the command line, the environment and .petscrc files, some of which run
  // programs: it gets none of them.
  unsetenv("PETSC_OPTIONS");
  char skip[] = "-skip_petscrc";
  int n_words = 2;
  char *words[] = {argv[0], skip, nullptr}, **given = words;
  if (PetscInitialize(&n_words, &given, nullptr, nullptr)) return 1;
  PetscPopSignalHandler();
  int n_ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  MPI_Comm leaving;
  MPI_Comm_dup(MPI_COMM_WORLD, &leaving);
  const bool first = rimpact::fe::is_first_rank(), shares = argc > 1 && std::strcmp(argv[1], "run") == 0;
  if (n_ranks > 1) prctl(PR_SET_PDEATHSIG, SIGKILL); // a killed mpirun leaves nobody behind who would go on writing
  if (!first && (!std::freopen("/dev/null", "w", stdout) || !std::freopen("/dev/null", "w", stderr))) return 1;
  int code = 0;
  if (first || shares) code = rimpact::app::run_command(argc, argv, verbs);
  std::fflush(stdout);
  if (code != 0 && n_ranks > 1) leave_together(leaving, code);
  MPI_Comm_free(&leaving);
  PetscFinalize();
  return code;
}
