/// The limit a process's address space has (ulimit -v).
#pragma once
#include <optional>

namespace rimpact {

/// [bytes]; empty: none.
std::optional<double> address_space_limit();
/// What the limit leaves beside what is taken, this program's libraries most of all [bytes]; empty: there is no limit.
std::optional<double> address_space_left();

} // namespace rimpact
