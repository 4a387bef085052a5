/// Steps of travel of a push onto the rim [m].
#pragma once

namespace rimpact::fe {

inline constexpr double first_step = 1e-5;    ///< the first contact wants a small one
inline constexpr double growth = 1.6;         ///< of the next step, at most
inline constexpr double smallest_step = 1e-8; ///< below it the push stops

} // namespace rimpact::fe
