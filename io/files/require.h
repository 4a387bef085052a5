/// What input must be.
#pragma once
#include "io/files/error.h"
#include <fmt/format.h>
#include <string>
#include <utility>

namespace rimpact {

/// Throws InputError with the sentence, its values put in, where the input is not `good`.
template <class... Values> void require(bool good, fmt::format_string<Values...> sentence, Values &&...values) {
  if (!good) throw InputError(fmt::format(sentence, std::forward<Values>(values)...));
}

/// Throws InputError "NAME VALUE must be BOUND" where it is not `good`.
inline void require_bound(bool good, const std::string &name, double value, const std::string &bound) {
  require(good, "{} {:g} must be {}", name, value, bound);
}

} // namespace rimpact
