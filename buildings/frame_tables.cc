#include "buildings/frame_tables.h"
#include "files/file.h"
#include "responses/response.h"
#include <fmt/format.h>

namespace rimpact::buildings {

void write_tables(const Frame &f, const std::string &folder) {
  std::vector<int> owner(f.nodes.size(), 0);
  std::string slabs = "diaphragm,mass_kg,x_m,y_m,inertia_kg_m2\n",
              nodes = "node,x_m,y_m,z_m,diaphragm,vertical_mass_kg,bearing\n",
              elements = "element,i,j,E_Pa,G_Pa,A_m2,Iy_m4,Iz_m4,J_m4,Asy_m2,Asz_m2,up_x,up_y,up_z\n";
  for (std::size_t d = 0; d < f.diaphragms.size(); ++d) {
    const auto &s = f.diaphragms[d];
    for (const int node : s.nodes) owner[node] = static_cast<int>(d) + 1;
    slabs += fmt::format("{},{:.17g},{:.17g},{:.17g},{:.17g}\n", d + 1, s.mass, s.centre.x(), s.centre.y(), s.inertia);
  }
  for (std::size_t i = 0; i < f.nodes.size(); ++i) {
    const auto &n = f.nodes[i];
    nodes += fmt::format("{},{:.17g},{:.17g},{:.17g},{},{:.17g},{}\n", i + 1, n.at.x(), n.at.y(), n.at.z(), owner[i],
                         n.vertical_mass, int(n.supported));
  }
  for (std::size_t e = 0; e < f.elements.size(); ++e) {
    const auto &m = f.elements[e];
    const auto &s = f.sections[m.section];
    elements += fmt::format("{},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{}\n",
                            e + 1, m.i + 1, m.j + 1, s.E, s.G, s.area, s.Iy, s.Iz, s.torsion, s.shear_y, s.shear_z,
                            m.up.x(), m.up.y(), m.up.z());
  }
  write_atomically(nodes, folder + "/nodes.csv");
  write_atomically(elements, folder + "/elements.csv");
  write_atomically(slabs, folder + "/diaphragms.csv");
}

} // namespace rimpact::buildings
