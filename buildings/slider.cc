#include "buildings/slider.h"

namespace rimpact::buildings {

std::vector<Slider> sliders(const BuildingModel &m) {
  std::vector<Slider> list;
  for (std::size_t b = 0; b < m.bearings.size(); ++b) {
    const auto &W = m.slider[b];
    int d = 0;
    while (W(0, 3 * d) == 0) ++d; // a supported node lies in a diaphragm (Frame::validate)
    list.push_back({{3 * d, 3 * d + 1, 3 * d + 2, m.vertical(m.bearings[b])}, W(1, 3 * d + 2), -W(0, 3 * d + 2)});
  }
  return list;
}

} // namespace rimpact::buildings
