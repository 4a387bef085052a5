/// Whether a run fits the limit of its address space.
#pragma once

namespace rimpact::fe {

/// Throws SolverStopped where the limit (ulimit -v) leaves less than `bytes` of a plan and the buffer of BLAS, which is
/// taken here: at the limit itself libraries wait for memory without end.
void need_memory(double bytes);

} // namespace rimpact::fe
