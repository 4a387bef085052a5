#include "fe_contact/drive/mpi_start.h"

#include <cstdlib>
#include <utility>

namespace rimpact::fe {

void start_mpi_alone_unless_launched() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE")) return;
  for (const auto &[name, value] : {std::pair{"OMPI_MCA_ess_singleton_isolated", "1"},
                                    {"OMPI_MCA_orte_create_session_dirs", "0"},
                                    {"OMPI_MCA_pml", "ob1"},
                                    {"OMPI_MCA_btl", "self"}})
    setenv(name, value, 1);
}

} // namespace rimpact::fe
