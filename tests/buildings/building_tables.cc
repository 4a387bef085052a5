// building_tables BUILDING FOLDER: writes the tables of a building, prints its fixed-base circular frequencies.
#include "buildings/frame_tables.h"
#include "buildings/modes.h"
#include "buildings/regular_building.h"
#include <cstdio>

int main(int, char **argv) {
  using namespace rimpact::buildings;
  const Frame frame = make_frame(load_building(argv[1]));
  write_tables(frame, argv[2]);
  for (const double omega : fixed_base_modes(assemble(frame)).omega) std::printf("%.17g\n", omega);
}
