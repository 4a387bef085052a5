/// The part of a fleet or study that one call runs.
#pragma once
#include <string>
#include <utility>

namespace rimpact::app {

/// "2/8" -> {2, 8}; empty: {1, 1}. Throws InputError naming the word.
std::pair<int, int> parse_shard(const std::string &text);

} // namespace rimpact::app
