/// Node and element tables of a frame as CSV, numbers from 1, SI units.
///   nodes.csv       node,x_m,y_m,z_m,diaphragm,vertical_mass_kg,bearing
///   elements.csv    element,i,j,E_Pa,G_Pa,A_m2,Iy_m4,Iz_m4,J_m4,Asy_m2,Asz_m2,up_x,up_y,up_z
///   diaphragms.csv  diaphragm,mass_kg,x_m,y_m,inertia_kg_m2
/// `bearing`: 0 none, 1 the scene's, else the name or file of its own.
#pragma once
#include "buildings/frame.h"
#include <map>

namespace rimpact::buildings {

/// The texts of nodes.csv, elements.csv and diaphragms.csv, by name, 17 digits.
std::map<std::string, std::string> tables_of(const Frame &frame);
/// These in an existing folder. Throws IoError.
void write_tables(const Frame &frame, const std::string &folder);
/// Columns by name, in any order; members of equal numbers share a section; damping 0.02. Throws DataError with file,
/// line and value, also for a frame that contradicts itself (Frame::validate).
Frame read_tables(const std::string &folder);

} // namespace rimpact::buildings
