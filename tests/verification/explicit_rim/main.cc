// An explicit program beside ours: a slider thrown at a rim, or pushed into it and drawn back, by central differences.
// Reads a deck that explicit_rim.py writes from our mesh, writes time, travel and force as CSV. mm, N, t, s; half
// model.
#include "contact.h"
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace explicit_rim {
namespace {

struct Deck {
  std::map<std::string, double> number;
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 8>> cells;
  Faces slider, wall;
  std::vector<int> top;
  std::vector<std::pair<int, Vec3>> held; ///< a node does not move along this direction
};

Deck read(const std::string &path) {
  Deck deck;
  std::ifstream file(path);
  for (std::string kind; file >> kind;) {
    if (kind == "number") {
      std::string name;
      file >> name, file >> deck.number[name];
    } else if (kind == "node") {
      auto &x = deck.nodes.emplace_back();
      file >> x[0] >> x[1] >> x[2];
    } else if (kind == "cell") {
      for (int &node : deck.cells.emplace_back()) file >> node;
    } else if (kind == "slider" || kind == "wall") {
      for (int &node : (kind == "wall" ? deck.wall : deck.slider).emplace_back()) file >> node;
    } else if (kind == "top") {
      file >> deck.top.emplace_back();
    } else {
      auto &[node, way] = deck.held.emplace_back();
      file >> node >> way[0] >> way[1] >> way[2];
    }
  }
  return deck;
}

/// Travel and rise of a push's top at t: in and back as one cosine, the rise that of the dish beyond the capacity.
Vec3 pushed(const std::map<std::string, double> &number, double t) {
  const double T = number.at("push_time"), a = number.at("half_width"), b = number.at("height"),
               L = number.at("capacity");
  const double u = number.at("travel") * (1 - std::cos(2 * M_PI * t / T)) / 2;
  const auto rise = [&](double r) { return b * (1 - std::sqrt(1 - r * r / (a * a))); };
  return {u, 0, rise(L + u) - rise(L)};
}

int run(const Deck &deck, const std::string &out) {
  const auto &number = deck.number;
  const double dt = number.at("step"), end = number.at("duration"), speed = number.at("speed");
  const bool pushes = number.at("push_time") > 0;
  Solid solid(deck.nodes, deck.cells,
              {number.at("shear"), number.at("bulk"), number.at("yield"), number.at("hardening"), number.at("density"),
               number.at("rate_D"), number.at("rate_q")},
              dt);
  Contact contact(deck.slider, deck.wall, deck.nodes,
                  {.stiffness = number.at("contact"), .friction = number.at("friction")});
  std::vector<Vec3> x = deck.nodes, v(x.size()), force(x.size());
  const int n_slider = static_cast<int>(number.at("slider_begins"));
  for (std::size_t i = n_slider; i < x.size(); ++i) v[i][0] = pushes ? 0 : speed;
  double top_mass = number.at("mass"); // of the half bearing, all that moves with the slider
  for (std::size_t i = n_slider; i < x.size(); ++i) top_mass -= solid.mass()[i];
  for (const int node : deck.top) top_mass += solid.mass()[node];
  std::FILE *file = std::fopen(out.c_str(), "w");
  std::fprintf(file, "time_s,travel_mm,force_N,speed_mm_s,contact_N\n");
  const int steps = static_cast<int>(end / dt), every = std::max(1, steps / 2000);
  const int lead = deck.top[0];
  double mean = 0, felt = 0;
  for (int i = 0; i < steps; ++i) {
    for (auto &f : force) f = {};
    solid.advance(x, v, i == 0 ? 0 : dt, force);
    felt += contact.push(x, v, force)[0] / every;
    double top_force = 0;
    for (const int node : deck.top) top_force += force[node][0];
    for (std::size_t n = 0; n < x.size(); ++n)
      for (int j = 0; j < 3; ++j)
        v[n][j] +=
            dt * (force[n][j] / solid.mass()[n] - number.at("damping") * (static_cast<int>(n) < n_slider) * v[n][j]);
    for (const auto &[node, way] : deck.held) {
      const double along = dot(v[node], way);
      for (int j = 0; j < 3; ++j) v[node][j] -= along * way[j];
    }
    const Vec3 now = pushes ? pushed(number, i * dt) : Vec3{}, next = pushes ? pushed(number, (i + 1) * dt) : Vec3{};
    static double top_speed = speed;
    top_speed += dt * top_force / top_mass;
    for (const int node : deck.top)
      v[node] = pushes ? Vec3{(next[0] - now[0]) / dt, 0, (next[2] - now[2]) / dt} : Vec3{top_speed, 0, 0};
    for (std::size_t n = 0; n < x.size(); ++n)
      for (int j = 0; j < 3; ++j) x[n][j] += dt * v[n][j];
    mean += top_force / every;
    if ((i + 1) % every == 0) {
      std::fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g\n", (i + 1) * dt, x[lead][0] - deck.nodes[lead][0], mean, v[lead][0],
                   felt);
      mean = felt = 0;
    }
    if (!std::isfinite(top_force)) throw std::runtime_error("the motion blew up at step " + std::to_string(i));
  }
  std::fclose(file);
  // Of the whole bearing, as the work is; cells, nodes and added mass are the half's.
  std::printf("cells %zu nodes %zu steps %d added_mass_kg %.4g plastic_work_J %.6g largest_plastic_strain %.4g\n",
              deck.cells.size(), x.size(), steps, 1e3 * solid.added_mass(), 2e-3 * solid.plastic_work(),
              solid.largest_plastic_strain());
  return 0;
}

} // namespace
} // namespace explicit_rim

int main(int argc, char **argv) try {
  if (argc != 3) throw std::runtime_error("usage: explicit_rim DECK OUT.csv");
  return explicit_rim::run(explicit_rim::read(argv[1]), argv[2]);
} catch (const std::exception &error) {
  std::cerr << "explicit_rim: " << error.what() << "\n";
  return 1;
}
