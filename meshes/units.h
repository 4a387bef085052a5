#pragma once

namespace rimpact::meshes {

inline constexpr double mm = 1e-3; ///< [m]; sizes of sections are told in millimetres

} // namespace rimpact::meshes
