#include "studies/fleets/run_end.h"
#include <algorithm>
#include <array>

namespace rimpact::fleets {
namespace {

/// What the models say where a bearing or a frame has come to its end; tests/fleets/test_run_end.cc holds them to it.
constexpr std::array last_words{"left the dish", "left its dish", "left over a rim", "left over the stop",
                                "thrown over",   "overturned",    "collapsed",       "breaks off its plate"};

} // namespace

RunEnd run_end(std::optional<RowStatus> status, const std::string &reason) {
  if (status == RowStatus::done) return RunEnd::done;
  const auto says = [&](const char *words) { return reason.find(words) != std::string::npos; };
  return status == RowStatus::stopped && std::any_of(last_words.begin(), last_words.end(), says)
             ? RunEnd::beyond
             : RunEnd::without_result;
}

} // namespace rimpact::fleets
