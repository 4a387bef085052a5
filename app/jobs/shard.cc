#include "app/jobs/shard.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include <cmath>
#include <fmt/format.h>

namespace rimpact::app {

std::pair<int, int> parse_shard(const std::string &text) {
  if (text.empty()) return {1, 1};
  const auto parts = split(text, '/');
  constexpr double most = 100'000;
  double number[2] = {0, 0};
  for (std::size_t i = 0; i < 2 && parts.size() == 2; ++i) number[i] = to_number(parts[i]).value_or(0);
  if (!(number[0] >= 1 && number[0] <= number[1] && number[1] <= most && number[0] == std::floor(number[0]) &&
        number[1] == std::floor(number[1])))
    throw InputError(fmt::format("--shard {} must be I/N with 1 <= I <= N, e.g. 2/8", text));
  return {static_cast<int>(number[0]), static_cast<int>(number[1])};
}

} // namespace rimpact::app
