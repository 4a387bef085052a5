// Meshes drawn elsewhere: read, checked against the bearing, put where a rung wants them.
#include "io/files/error.h"
#include "meshes/exact_surfaces.h"
#include "meshes/rim_mesh.h"
#include "meshes/stack_mesh.h"
#include "meshes/surface_list.h"
#include "scene/script_permission.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gmsh.h>
#include <gtest/gtest.h>
#include <set>

namespace rimpact::meshes {
namespace {

const scene::Bearing bearing;

std::string path_of(const std::string &name) {
  return (std::filesystem::temp_directory_path() / ("rimpact_own_" + std::to_string(getpid()) + "_" + name)).string();
}

/// A file in the temporary folder, gone with this object.
struct TemporaryFile {
  std::string path;
  explicit TemporaryFile(const std::string &name) : path(path_of(name)) {}
  ~TemporaryFile() { std::filesystem::remove(path); }
};

/// A built-in mesh, changed, written and read back for rung rim.
HexMesh through_a_file(
    const std::function<void(HexMesh &)> &change, const std::function<void(MeshOrder &)> &options = [](auto &) {},
    int level = 0, bool curved = true) {
  HexMesh mesh = rim_mesh(bearing, {.level = level});
  change(mesh);
  const TemporaryFile file("mesh.msh");
  write_msh(mesh, file.path, curved);
  MeshOrder own;
  own.own.file = file.path;
  options(own);
  return rim_mesh(bearing, own);
}

std::string refusal(
    const std::function<void(HexMesh &)> &change, const std::function<void(MeshOrder &)> &options = [](auto &) {}) {
  try {
    through_a_file(change, options);
  } catch (const DataError &error) {
    return error.what();
  }
  return "accepted";
}
const auto as_it_is = [](HexMesh &) {};
void expect_says(const std::string &sentence, const std::string &part) {
  EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

void scale(HexMesh &mesh, double factor) {
  for (auto &node : mesh.nodes)
    for (double &x : node) x *= factor;
}
void drop(HexMesh &mesh, Surface group) {
  std::erase_if(mesh.faces, [&](const auto &face) { return face.group == group; });
}

/// Cells body by body, as a file is read.
HexMesh by_bodies(const HexMesh &mesh) {
  HexMesh result = mesh;
  result.cells.clear(), result.volumes.clear();
  for (const Volume body : {Volume::plate, Volume::rim, Volume::pad, Volume::foot, Volume::upper_slider})
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      if (mesh.volumes[c] == body) result.cells.push_back(mesh.cells[c]), result.volumes.push_back(body);
  return result;
}

/// Largest distance of two meshes' nodes, cell by cell.
double distance(const HexMesh &a, const HexMesh &b,
                const std::vector<Volume> &bodies = {Volume::plate, Volume::rim, Volume::upper_slider}) {
  double largest = 0;
  for (std::size_t c = 0; c < a.cells.size(); ++c)
    for (int n = 0; n < 27 && std::count(bodies.begin(), bodies.end(), a.volumes[c]); ++n)
      for (int i = 0; i < 3; ++i)
        largest = std::max(largest, std::abs(a.nodes[a.cells[c][n]][i] - b.nodes[b.cells[c][n]][i]));
  return largest;
}

TEST(OwnMesh, CurvedCellsComeBackAsTheyWere) {
  const HexMesh own = through_a_file(as_it_is), built_in = by_bodies(rim_mesh(bearing, {.level = 0}));
  ASSERT_EQ(own.cells.size(), built_in.cells.size());
  EXPECT_EQ(own.nodes.size(), built_in.nodes.size());
  EXPECT_EQ(own.faces.size(), built_in.faces.size());
  EXPECT_EQ(own.volumes, built_in.volumes);
  EXPECT_LT(distance(own, built_in), 1e-9);
}

TEST(OwnMesh, StraightCellsGetTheirCurvatureBack) {
  const HexMesh own = through_a_file(
                    as_it_is, [](auto &) {}, 3, false),
                built_in = by_bodies(rim_mesh(bearing, {.level = 3}));
  ASSERT_EQ(own.cells.size(), built_in.cells.size());
  EXPECT_EQ(own.nodes.size(), built_in.nodes.size());
  EXPECT_LT(distance(own, built_in, {Volume::rim}), 1e-9);
  EXPECT_LT(distance(own, built_in), 4e-3); // the layers above the socket, which lies 20 mm from its chord there
  HexMesh again = own;
  fit_to_surfaces(again, bearing, bearing.lateral_capacity(), "again");
  EXPECT_LT(distance(again, own), 1e-9); // what counts as moved there
}

TEST(OwnMesh, DrawnAtRestInMillimetresUnderOtherNames) {
  const double capacity = bearing.lateral_capacity(), up = scene::lift(bearing, capacity);
  const HexMesh own = through_a_file(
      [&](HexMesh &mesh) {
        std::vector<char> of_slider(mesh.nodes.size(), 0);
        for (std::size_t c = 0; c < mesh.cells.size(); ++c)
          if (mesh.volumes[c] == Volume::upper_slider)
            for (const unsigned node : mesh.cells[c]) of_slider[node] = 1;
        for (std::size_t k = 0; k < mesh.nodes.size(); ++k)
          if (of_slider[k]) mesh.nodes[k][0] -= capacity, mesh.nodes[k][2] -= up;
        scale(mesh, 1e3);
        for (auto &face : mesh.faces) // the file's names no longer mean what they say
          face.group = face.group == Surface::top ? Surface::foot_cap : face.group;
      },
      [](MeshOrder &options) {
        options.own.unit = scene::LengthUnit::mm;
        options.own.groups[static_cast<std::size_t>(n_volumes) + static_cast<std::size_t>(Surface::top) -
                           static_cast<std::size_t>(Surface::dish)] = "foot_cap";
      });
  double rightmost = 0, highest = 0;
  for (std::size_t c = 0; c < own.cells.size(); ++c)
    if (own.volumes[c] == Volume::upper_slider)
      for (const unsigned node : own.cells[c])
        rightmost = std::max(rightmost, own.nodes[node][0]), highest = std::max(highest, own.nodes[node][2]);
  EXPECT_NEAR(rightmost, capacity + 0.12, 1e-12);
  EXPECT_NEAR(highest, bearing.slider.top + up, 1e-12);
}

TEST(OwnMesh, AHalfIsMirroredForAWholeModel) {
  const HexMesh half = through_a_file(as_it_is),
                whole = through_a_file(as_it_is, [](MeshOrder &options) { options.half = false; });
  EXPECT_EQ(whole.cells.size(), 2 * half.cells.size());
  EXPECT_TRUE(
      std::none_of(whole.faces.begin(), whole.faces.end(), [](const auto &f) { return f.group == Surface::symmetry; }));
}

TEST(OwnMesh, AStackAtRestWithItsRim) {
  const TemporaryFile file("stack.msh");
  const HexMesh built_in = stack_mesh(bearing, {.level = 0, .rim = true});
  write_msh(built_in, file.path, true);
  MeshOrder options{.rim = true};
  options.own.file = file.path;
  EXPECT_EQ(stack_mesh(bearing, options).cells.size(), built_in.cells.size());
  options.rim = false; // what the scene does not need is left out
  EXPECT_LT(stack_mesh(bearing, options).cells.size(), built_in.cells.size());
  options.rim = true;
  options.directions = {0, M_PI};
  EXPECT_THROW(stack_mesh(bearing, options), DataError); // no wall at -x
}

TEST(OwnMesh, RefusalsNameWhatIsWrong) {
  expect_says(refusal([](HexMesh &m) { drop(m, Surface::rim_wall); }), "surface 'rim_wall' is missing");
  expect_says(refusal([](HexMesh &m) { drop(m, Surface::symmetry); }), "model.symmetry = \"whole\"");
  expect_says(refusal([](HexMesh &m) { scale(m, 1e3); }), "1e+03 times as much: model.own_mesh.unit is \"m\"");
  expect_says(refusal([](HexMesh &m) {
                for (auto &node : m.nodes) node[0] += 0.01;
              }),
              "drawn at x = 410.00 mm");
  expect_says(refusal([](HexMesh &m) {
                for (std::size_t c = 0; c < m.cells.size(); ++c)
                  if (m.volumes[c] == Volume::plate) m.volumes[c] = Volume::foot;
              }),
              "volume 'plate' is missing");
  expect_says(
      refusal([](HexMesh &m) {
        std::set<unsigned> outside;
        for (const auto &face : m.faces) outside.insert(face.corners.begin(), face.corners.end());
        for (const auto &cell : m.cells)
          if (std::none_of(cell.begin(), cell.begin() + 8, [&](unsigned node) { return outside.count(node) > 0; })) {
            for (int i = 0; i < 3; ++i) m.nodes[cell[0]][i] = 2 * m.nodes[cell[6]][i] - m.nodes[cell[0]][i];
            return;
          }
      }),
      "is inverted");
  expect_says(refusal(as_it_is, [](MeshOrder &o) { o.own.groups[1] = "rimm"; }), "did you mean \"rim\"");
  expect_says(refusal(as_it_is, [](MeshOrder &o) { o.own.file = "/nowhere.msh"; }), "no such mesh file");
}

TEST(OwnMesh, AWallElsewhereThanTheBearingsIsRefused) {
  expect_says(refusal([](HexMesh &m) {
                for (const auto &face : m.faces)
                  if (face.group == Surface::rim_wall)
                    for (const unsigned k : face.corners) {
                      auto &node = m.nodes[k];
                      const double factor = 0.521 / std::hypot(node[0], node[1]);
                      node[0] *= factor, node[1] *= factor;
                    }
              }),
              "drawing and bearing file differ");
}

TEST(OwnMesh, WeldedBodiesAreRefused) {
  expect_says(refusal([](HexMesh &m) {
                unsigned on_wall = 0, on_side = 0; // one corner of the slider becomes one of the rim
                for (const auto &face : m.faces) {
                  if (face.group == Surface::rim_wall) on_wall = face.corners[0];
                  if (face.group == Surface::slider_side) on_side = face.corners[0];
                }
                for (auto &cell : m.cells)
                  for (unsigned &node : cell)
                    if (node == on_side) node = on_wall;
                for (auto &face : m.faces)
                  for (unsigned &node : face.corners)
                    if (node == on_side) node = on_wall;
              }),
              "rim and upper_slider are welded: they share 1 nodes");
}

/// The part of a ring between two heights.
int ring(double low, double high) {
  namespace occ = gmsh::model::occ;
  const int outer = occ::addCylinder(0, 0, low, 0, 0, high - low, 560, -1, 1.0),
            inner = occ::addCylinder(0, 0, low - 1, 0, 0, high - low + 2, 520, -1, 1.0);
  gmsh::vectorpair result;
  std::vector<gmsh::vectorpair> map;
  occ::cut({{3, outer}}, {{3, inner}}, result, map);
  return result[0].second;
}

/// Rim sector and slider without their foot and socket, drawn with OpenCASCADE; a STEP file knows neither groups nor
/// cells. `parts`: the sector as one body, or plate and rim apart, one on the other.
void draw_step(const std::string &path, int parts = 1) {
  namespace occ = gmsh::model::occ;
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::add("step");
  const double edge = 1e3 * scene::make_surface(bearing.surface)->at(0.52, 0).z, bottom = 1e3 * bearing.slider.bottom;
  if (parts == 1)
    ring(-50, edge + 60);
  else
    ring(-50, edge), ring(edge, edge + 60);
  occ::addCylinder(0, 0, bottom, 0, 0, 100, 120, -1, M_PI);
  occ::synchronize();
  gmsh::write(path);
  gmsh::finalize();
}

TEST(OwnMesh, AStepFileIsMeshedWithHexahedra) {
  const TemporaryFile file("bearing.step");
  draw_step(file.path);
  MeshOrder options;
  options.own.file = file.path;
  options.own.unit = scene::LengthUnit::mm;
  options.own.size = 0.06, options.own.contact_size = 0.03;
  const auto name = [&](auto group, const char *in_file) {
    for (std::size_t k = 0; k < scene::mesh_group_names.size(); ++k)
      if (to_string(group) == scene::mesh_group_names[k]) options.own.groups[k] = in_file;
  };
  name(Volume::plate, "volume 1"), name(Volume::upper_slider, "volume 2");
  // Numbers as gmsh shows them (its statistics window, or `rimpact` when a name is wrong).
  name(Surface::rim_wall, "surface 6"), name(Surface::fixed, "surface 4"),
      name(Surface::symmetry, "surface 5, surface 10, surface 11");
  name(Surface::slider_side, "surface 7"), name(Surface::top, "surface 8"), name(Surface::sector_end, "surface 3");
  const HexMesh mesh = rim_mesh(bearing, options);
  EXPECT_EQ(quality(mesh).n_components, 2);
  EXPECT_GT(mesh.cells.size(), 100u);
  EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.01);
}

/// A quarter of a ring about the dish and a slider at rest, its lower edge rounded by 2 mm: gmsh's text, in mm.
void draw_rounded(const std::string &path) {
  std::ofstream(path) << R"(SetFactory("OpenCASCADE");
Point(1) = {520, 0, -50}; Point(2) = {560, 0, -50}; Point(3) = {560, 0, 147}; Point(4) = {520, 0, 147};
Point(5) = {0, 0, 58.25}; Point(6) = {118, 0, 58.25}; Point(7) = {118, 0, 60.25}; Point(8) = {120, 0, 60.25};
Point(9) = {120, 0, 158.25}; Point(10) = {0, 0, 158.25};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Circle(6) = {6, 7, 8}; Line(7) = {8, 9}; Line(8) = {9, 10}; Line(9) = {10, 5};
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5, 6, 7, 8, 9}; Plane Surface(1) = {1}; Plane Surface(2) = {2};
ring[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Surface{1}; };
slider[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi} { Surface{2}; };
Physical Volume("plate") = {ring[1]}; Physical Volume("upper_slider") = {slider[1]};
Physical Surface("fixed") = {ring[2]}; Physical Surface("rim_wall") = {ring[5]}; Physical Surface("sector_end") = {ring[0]};
Physical Surface("symmetry") = {1, 2, slider[0]}; Physical Surface("slider_side") = {slider[3], slider[4]};
Physical Surface("top") = {slider[5]};
)";
}

/// Cells as long as four roundings follow it all around; thirty a turn of a rounding would be 30,000 tetrahedra.
TEST(OwnMesh, ARoundedEdgeOfADrawingTakesFewCells) {
  const TemporaryFile file("rounded.geo");
  draw_rounded(file.path);
  setenv(scene::script_permission, "1", 1);
  MeshOrder options;
  options.own.file = file.path;
  options.own.unit = scene::LengthUnit::mm;
  const HexMesh mesh = rim_mesh(bearing, options);
  unsetenv(scene::script_permission);
  EXPECT_LT(mesh.cells.size(), 20000u);
  EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.01);
}

/// The number of the surface of a body that is of this kind, with its middle nearest to a place.
int surface_near(const nlohmann::json &body, const std::string &kind, const std::array<double, 3> &place) {
  int number = 0;
  double nearest = INFINITY;
  for (const auto &surface : body["surfaces"]) {
    double distance = 0;
    for (std::size_t i = 0; i < 3; ++i)
      distance += std::pow((surface["box"][0][i].get<double>() + surface["box"][1][i].get<double>()) / 2 - place[i], 2);
    if (surface["kind"] == kind && distance < nearest) nearest = distance, number = surface["number"];
  }
  return number;
}

TEST(SurfaceList, KindsRadiiAndCentresAreThoseDrawn) {
  const TemporaryFile file("listed.step");
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::add("listed");
  gmsh::model::occ::addCylinder(10, 20, 30, 0, 5, 0, 7); // its axis along y
  gmsh::model::occ::addSphere(100, 0, -3, 11);
  gmsh::model::occ::addTorus(0, 0, 200, 50, 2);
  gmsh::model::occ::synchronize();
  gmsh::write(file.path);
  gmsh::finalize();
  const auto bodies = list_surfaces(file.path);
  ASSERT_EQ(bodies.size(), 3u);
  const auto of_kind = [](const nlohmann::json &body, const std::string &kind) {
    for (const auto &surface : body["surfaces"])
      if (surface["kind"] == kind) return surface;
    ADD_FAILURE() << kind;
    return nlohmann::json();
  };
  const auto expect = [](const nlohmann::json &found, const std::array<double, 3> &wanted) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i].get<double>(), wanted[i], 1e-5) << found;
  };
  const auto cylinder = of_kind(bodies[0], "Cylinder"), sphere = of_kind(bodies[1], "Sphere"),
             torus = of_kind(bodies[2], "Torus");
  EXPECT_NEAR(cylinder["radius"].get<double>(), 7, 1e-5);
  expect(cylinder["centre"], {10, 22.5, 30});
  EXPECT_NEAR(std::abs(cylinder["axis"][1].get<double>()), 1, 1e-6);
  EXPECT_NEAR(sphere["radius"].get<double>(), 11, 1e-5);
  expect(sphere["centre"], {100, 0, -3});
  EXPECT_NEAR(torus["radius"].get<double>(), 2, 1e-5);
  EXPECT_NEAR(torus["around"].get<double>(), 50, 1e-5);
  expect(torus["centre"], {0, 0, 200});
  const std::string text = describe_surfaces(bodies);
  EXPECT_NE(text.find("Sphere, radius 11, centre (100, 0, -3)"), std::string::npos) << text;
  try {
    list_surfaces("no-such.step");
    ADD_FAILURE() << "it is not there";
  } catch (const DataError &error) {
    EXPECT_STREQ(error.what(), "no-such.step: no such mesh file (--surfaces)") << "no key of a scene named it";
  }
}

/// Plate and rim of a STEP file, one on the other: they get a common face, and the surfaces keep their names.
TEST(OwnMesh, PlateAndRimDrawnApartAreJoined) {
  const TemporaryFile file("apart.step");
  draw_step(file.path, 2);
  const auto bodies = list_surfaces(file.path);
  ASSERT_EQ(bodies.size(), 3u);
  MeshOrder options;
  options.own.file = file.path;
  options.own.unit = scene::LengthUnit::mm;
  options.own.size = 0.06, options.own.contact_size = 0.03;
  const auto name = [&](auto group, const std::string &in_file) {
    for (std::size_t k = 0; k < scene::mesh_group_names.size(); ++k)
      if (to_string(group) == scene::mesh_group_names[k]) options.own.groups[k] = in_file;
  };
  const auto surfaces = [](std::initializer_list<int> numbers) {
    std::string text;
    for (const int number : numbers) text += (text.empty() ? "surface " : ", surface ") + std::to_string(number);
    return text;
  };
  const auto &plate = bodies[0], &rim = bodies[1], &slider = bodies[2];
  const double edge = rim["box"][0][2], end = 540 * std::cos(1.0), out = 540 * std::sin(1.0);
  name(Volume::plate, "volume 1"), name(Volume::rim, "volume 2"), name(Volume::upper_slider, "volume 3");
  name(Surface::rim_wall, surfaces({surface_near(rim, "Cylinder", {400, 218, edge + 30})}));
  name(Surface::fixed, surfaces({surface_near(plate, "Plane", {416, 235, -50})}));
  name(Surface::symmetry,
       surfaces({surface_near(plate, "Plane", {540, 0, 0}), surface_near(rim, "Plane", {540, 0, edge + 30}),
                 surface_near(slider, "Plane", {60, 0, 108}), surface_near(slider, "Plane", {-60, 0, 108})}));
  name(Surface::sector_end,
       surfaces({surface_near(plate, "Plane", {end, out, 0}), surface_near(rim, "Plane", {end, out, edge + 30})}));
  name(Surface::slider_side, surfaces({surface_near(slider, "Cylinder", {0, 60, 108})}));
  name(Surface::top, surfaces({surface_near(slider, "Plane", {0, 60, 158})}));
  const HexMesh mesh = rim_mesh(bearing, options);
  EXPECT_EQ(quality(mesh).n_components, 2) << "one piece, and the slider";
  EXPECT_GT(std::count(mesh.volumes.begin(), mesh.volumes.end(), Volume::rim), 0);
  EXPECT_GT(quality(mesh).min_scaled_jacobian, 0.01);
}

} // namespace
} // namespace rimpact::meshes
