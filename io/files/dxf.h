/// A drawing in the plane as DXF of release 12 (AC1009), the oldest form that every program of drawing still reads:
/// text, a group code and its value on two lines each. Autodesk, "AutoCAD 2012 DXF reference", chapters 1 to 6. Lengths
/// are written as they are given.
#pragma once
#include <string>
#include <vector>

namespace rimpact {

struct DxfVertex {
  double x, y;
  /// Of the way to the next vertex: tan(a / 4) of an arc through the angle a, > 0 anticlockwise; 0: straight.
  double bulge = 0;
};
using DxfOutline = std::vector<DxfVertex>;

/// An outline mirrored in x = 0 or y = `about`, and moved.
DxfOutline mirrored_in_x(DxfOutline outline);
DxfOutline mirrored_in_y(DxfOutline outline, double about);
DxfOutline moved(DxfOutline outline, double x, double y);

class DxfDrawing {
public:
  enum class Line { continuous, dashed, centre };
  /// Colours are AutoCAD's numbers, 7 black or white. A layer is known before something is drawn on it.
  void layer(const std::string &name, int colour, Line line = Line::continuous);
  void outline(const std::string &layer, const DxfOutline &vertices, bool closed = true);
  void text(const std::string &layer, double x, double y, double height, const std::string &words);
  /// The file; `comments` stand at its head, line breaks in them become spaces.
  std::string file(const std::vector<std::string> &comments) const;

private:
  void reach(double x, double y);
  std::string layers_, entities_;
  int n_layers_ = 0;
  double low_[2] = {1e20, 1e20}, high_[2] = {-1e20, -1e20};
};

} // namespace rimpact
