#include "fleets/run_end.h"

namespace rimpact::fleets {

RunEnd run_end(std::optional<RowStatus> status, const std::string &reason) {
  if (status == RowStatus::done) return RunEnd::done;
  const auto says = [&](const char *words) { return reason.find(words) != std::string::npos; };
  return status == RowStatus::stopped &&
                 (says("left the dish") || says("left over") || says("overturned") || says("collapsed"))
             ? RunEnd::beyond
             : RunEnd::without_result;
}

} // namespace rimpact::fleets
