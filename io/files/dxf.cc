#include "io/files/dxf.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace rimpact {
namespace {

/// Group codes of DXF as they are used here.
std::string pair(int code, const std::string &value) {
  return fmt::format("{:3}\n{}\n", code, value);
}
std::string pair(int code, int value) {
  return pair(code, fmt::format("{}", value));
}
std::string pair(int code, double value) {
  return pair(code, fmt::format("{:.9g}", value));
}
std::string place(double x, double y) {
  return pair(10, x) + pair(20, y) + pair(30, 0.0);
}

/// One line that a reader of text takes whole.
std::string one_line(std::string text) {
  for (char &c : text)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = ' ';
  return text;
}

const char *name_of(DxfDrawing::Line line) {
  switch (line) {
  case DxfDrawing::Line::dashed:
    return "DASHED";
  case DxfDrawing::Line::centre:
    return "CENTER";
  default:
    return "CONTINUOUS";
  }
}

/// A pattern of dashes (> 0) and gaps (< 0).
std::string line_type(const char *name, const std::vector<double> &dashes) {
  double length = 0;
  for (const double dash : dashes) length += std::abs(dash);
  std::string text = pair(0, "LTYPE") + pair(2, name) + pair(70, 0) + pair(3, "") + pair(72, 65) +
                     pair(73, static_cast<int>(dashes.size())) + pair(40, length);
  for (const double dash : dashes) text += pair(49, dash);
  return text;
}

} // namespace

DxfOutline mirrored_in_x(DxfOutline outline) {
  for (auto &vertex : outline) vertex.x = -vertex.x, vertex.bulge = -vertex.bulge;
  return outline;
}

DxfOutline mirrored_in_y(DxfOutline outline, double about) {
  for (auto &vertex : outline) vertex.y = 2 * about - vertex.y, vertex.bulge = -vertex.bulge;
  return outline;
}

DxfOutline moved(DxfOutline outline, double x, double y) {
  for (auto &vertex : outline) vertex.x += x, vertex.y += y;
  return outline;
}

void DxfDrawing::layer(const std::string &name, int colour, Line line) {
  layers_ += pair(0, "LAYER") + pair(2, name) + pair(70, 0) + pair(62, colour) + pair(6, name_of(line));
  ++n_layers_;
}

void DxfDrawing::reach(double x, double y) {
  low_[0] = std::min(low_[0], x), low_[1] = std::min(low_[1], y);
  high_[0] = std::max(high_[0], x), high_[1] = std::max(high_[1], y);
}

void DxfDrawing::outline(const std::string &layer, const DxfOutline &vertices, bool closed) {
  entities_ += pair(0, "POLYLINE") + pair(8, layer) + pair(66, 1) + place(0, 0) + pair(70, closed ? 1 : 0);
  for (const auto &[x, y, bulge] : vertices) {
    entities_ += pair(0, "VERTEX") + pair(8, layer) + place(x, y);
    if (bulge != 0) entities_ += pair(42, bulge);
    reach(x, y);
  }
  entities_ += pair(0, "SEQEND") + pair(8, layer);
}

void DxfDrawing::text(const std::string &layer, double x, double y, double height, const std::string &words) {
  entities_ += pair(0, "TEXT") + pair(8, layer) + place(x, y) + pair(40, height) + pair(1, one_line(words));
  reach(x, y);
}

std::string DxfDrawing::file(const std::vector<std::string> &comments) const {
  std::string text;
  for (const auto &comment : comments) text += pair(999, one_line(comment));
  const auto section = [&](const char *name, const std::string &content) {
    text += pair(0, "SECTION") + pair(2, name) + content + pair(0, "ENDSEC");
  };
  const auto table = [](const char *name, int n, const std::string &content) {
    return pair(0, "TABLE") + pair(2, name) + pair(70, n) + content + pair(0, "ENDTAB");
  };
  section("HEADER", pair(9, "$ACADVER") + pair(1, "AC1009") + pair(9, "$EXTMIN") + place(low_[0], low_[1]) +
                        pair(9, "$EXTMAX") + place(high_[0], high_[1]));
  const std::string types =
      line_type("CONTINUOUS", {}) + line_type("DASHED", {12, -6}) + line_type("CENTER", {30, -6, 6, -6});
  section("TABLES", table("LTYPE", 3, types) + table("LAYER", n_layers_, layers_));
  section("ENTITIES", entities_);
  return text + pair(0, "EOF");
}

} // namespace rimpact
