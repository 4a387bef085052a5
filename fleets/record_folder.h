/// Ground motions of a folder of AT2 files, by the names PEER gives them.
#pragma once
#include <string>
#include <vector>

namespace rimpact::fleets {

/// Files of one station: NAME000.AT2, NAME090.AT2, NAME-UP.AT2 (three digits: an azimuth; UP, DWN, VER or V
/// behind "-" or "_": vertical). A file of another name stands alone as one horizontal component.
struct GroundMotion {
  std::string name;                    ///< what the names have in common
  std::vector<std::string> horizontal; ///< paths, by azimuth
  std::string vertical;                ///< path, empty when there is none
};

/// All of a folder, by name. Throws InputError when it is no folder or holds no AT2 file.
std::vector<GroundMotion> ground_motions(const std::string &folder);

/// Of a motion before any scale: the largest of its horizontal components'.
struct Intensity {
  double pga_g; ///< peak acceleration [standard g]
  double pgv;   ///< peak velocity [m/s]
  double sa_g;  ///< spectral acceleration at sa_period with 5 % damping [standard g], 0 when none is asked for
};
/// `sa_period` [s]; 0: none. Throws DataError naming a file that cannot be read.
Intensity intensity(const std::vector<std::string> &horizontal, double sa_period = 0);

} // namespace rimpact::fleets
